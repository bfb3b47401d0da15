"""From the names of parameters and asks to the symbols of textbooks, in LaTeX math.

omega_AB  \\omega_{AB}      r1       r_{1}            a_BC_y   a_{BC,y}
v_tr      v_{\\mathrm{e}}   a_tr_n   a_{\\mathrm{e}}^{\\mathrm{n}}   a_cor  a_{\\mathrm{C}}
"""

from __future__ import annotations

import re

GREEK = {
    "alpha": r"\alpha",
    "beta": r"\beta",
    "gamma": r"\gamma",
    "delta": r"\delta",
    "eps": r"\varepsilon",
    "theta": r"\theta",
    "kappa": r"\kappa",
    "lam": r"\lambda",
    "rho": r"\rho",
    "phi": r"\varphi",
    "psi": r"\psi",
    "eta": r"\eta",
    "omega": r"\omega",
}
PARTS = {"rel": r"\mathrm{r}", "tr": r"\mathrm{e}", "cor": r"\mathrm{C}"}
UPPER = {"n": r"\mathrm{n}", "t": r"\mathrm{t}"}


def symbol(name: str) -> str:
    """The LaTeX symbol of a parameter or an ask.

    >>> symbol("omega_AB"), symbol("a_BA_n")
    ('\\\\omega_{AB}', 'a_{BA}^{\\\\mathrm{n}}')
    """
    head, *rest = name.split("_")
    letters, digits = split_digits(head)
    lower = ([digits] if digits else []) + [subscript(part) for part in rest if part not in UPPER]
    upper = [UPPER[part] for part in rest if part in UPPER]
    text = GREEK.get(letters, letters)
    if lower:
        text += "_{" + ",".join(lower) + "}"
    return text + ("^{" + ",".join(upper) + "}" if upper else "")


def subscript(part: str) -> str:
    """One part of a subscript: relative, transport and Coriolis by their letters, points with their
    digits.
    """
    return PARTS.get(part, point_symbol(part))


def point_symbol(name: str) -> str:
    """A point or body name in LaTeX math: O1 becomes O_{1}, Bp becomes B'.

    >>> point_symbol("O1"), point_symbol("Bp"), point_symbol("AB")
    ('O_{1}', "B'", 'AB')
    """
    primed = re.sub(r"(?<=[A-Z])p", "'", name)
    return re.sub(r"(\d+)", r"_{\1}", primed) if not name.isdigit() else name


def split_digits(head: str) -> tuple[str, str]:
    """A name's letters and the digits at its end."""
    match = re.fullmatch(r"(.*?)(\d*)", head)
    return (match.group(1), match.group(2)) if match else (head, "")
