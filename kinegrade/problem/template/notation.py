"""From the names of parameters and asks to the symbols of textbooks, in LaTeX math: Greek letters
are spelled out, what follows a letter as a point's name or behind `_` is its subscript.

omega_AB  \\omega_{AB}      r1       r_{1}            a_BC_y   a_{BC,y}
v_tr      v_{\\mathrm{e}}   a_tr_n   a_{\\mathrm{e}}^{\\mathrm{n}}   a_cor  a_{\\mathrm{Cor}}
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from functools import lru_cache

from kinegrade.language.math.letters import GREEK

_GREEK = {name: rf"\{name}" for name in GREEK} | {
    "eps": r"\varepsilon",
    "epsilon": r"\varepsilon",
    "lam": r"\lambda",
    "phi": r"\varphi",
}
_OF_POINT = re.compile(r"^([a-z]|" + "|".join(_GREEK) + r")([A-Z]\w*)", re.ASCII)
_PARTS = {"rel": r"\mathrm{r}", "tr": r"\mathrm{e}", "cor": r"\mathrm{Cor}"}
_COMPONENTS = ("x", "y")
_UPPER = {"n": r"\mathrm{n}", "t": r"\mathrm{t}"}


def write_symbol(name: str) -> str:
    """The LaTeX symbol of a parameter or an ask.

    >>> write_symbol("omega_AB"), write_symbol("a_BA_n"), write_symbol("xO6")
    ('\\\\omega_{AB}', 'a_{BA}^{\\\\mathrm{n}}', 'x_{O_{6}}')
    """
    head, *rest = _OF_POINT.sub(r"\1_\2", name, 1).split("_")
    letters, digits = _split_digits(head)
    parts = [digits, *(part for part in rest if part not in _UPPER)]
    upper = [_UPPER[part] for part in rest if part in _UPPER]
    text = _GREEK.get(letters, letters)
    lower = "".join(_write_subscripts(list(filter(None, parts))))
    if lower:
        text += "_{" + lower + "}"
    return text + ("^{" + ",".join(upper) + "}" if upper else "")


def _write_subscripts(parts: Sequence[str]) -> Iterator[str]:
    r"""The parts of a subscript: relative, transport and Coriolis by their letters, points with
    their digits; commas between them, but not between a kind of motion and whose it is.

    >>> write_symbol("v_rel_2"), write_symbol("v_rel_x")
    ('v_{\\mathrm{r}2}', 'v_{\\mathrm{r},x}')
    """
    for before, part in zip(["", *parts], parts, strict=False):
        whose = before in _PARTS and part not in _COMPONENTS
        yield "," if before and not whose else ""
        yield _PARTS.get(part, write_point_symbol(part))


@lru_cache(maxsize=4096)
def write_point_symbol(name: str) -> str:
    """A point or body name in LaTeX math: O1 becomes O_{1}, Bp becomes B'.

    >>> write_point_symbol("O1"), write_point_symbol("Bp"), write_point_symbol("AB")
    ('O_{1}', "B'", 'AB')
    """
    primed = re.sub(r"(?<=[A-Z])p", "'", name)
    return re.sub(r"(\d+)", r"_{\1}", primed) if not name.isdigit() else name


def _split_digits(head: str) -> tuple[str, str]:
    """A name's letters and the digits at its end."""
    match = re.fullmatch(r"(.*?)(\d*)", head)
    return (match.group(1), match.group(2)) if match else (head, "")
