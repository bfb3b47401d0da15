r"""Math and units in HTML as learning management systems show it: formulas between `\(` and `\)`,
set by MathJax.

Every character that comes in is escaped; the only tags are those made here, and they are
well-formed XML too.
"""

from __future__ import annotations

import re
from functools import lru_cache
from html import escape

from kinegrade.exam.formula import RAISED, TEXT, require_known_math, write_unit

# What no XML document may hold
_CONTROL = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\ufffe\uffff\ud800-\udfff]")
_BOLD = re.compile(r"\\bm(?![A-Za-z])")


def write_plain_html(text: str) -> str:
    """A text as it is; control characters, which XML cannot hold, become blanks.

    >>> write_plain_html("a < b")
    'a &lt; b'
    """
    return escape(_CONTROL.sub(" ", text))


@lru_cache(maxsize=4096)
def write_math_html(latex: str, where: str = "text", *, display: bool = False) -> str:
    r"""A formula between MathJax's delimiters, in the LaTeX that MathJax knows.

    Raises TypesetError where it holds anything but the math that every press prints.

    >>> write_math_html(r"v_B = 2\,\unit{m/s^2}")
    '\\(v_B = 2\\,\\mathrm{m/s^{2}}\\)'
    """
    known = _BOLD.sub(r"\\boldsymbol", require_known_math(latex.strip(), where))
    written = TEXT.sub(lambda found: "{,}" if found[2] else _write_upright(found), known)
    return rf"\[{write_plain_html(written)}\]" if display else rf"\({write_plain_html(written)}\)"


def write_unit_html(unit: str) -> str:
    """A unit with raised exponents; "" for a pure number.

    >>> write_unit_html("rad/s^2"), write_unit_html("deg"), write_unit_html("1")
    ('rad/s<sup>2</sup>', '°', '')
    """
    raised = RAISED.sub(
        lambda power: f"<sup>{power[1].replace('-', '−')}</sup>", write_plain_html(unit)
    )
    return {"deg": "°", "1": ""}.get(unit, raised.replace("*", "·"))


def _write_upright(found: re.Match[str]) -> str:
    r"""`\unit{...}` as upright math, `\text{...}` with raised exponents as it is."""
    if not found[0].startswith(r"\unit"):
        return rf"\text{{{write_unit(found[1])}}}"
    if found[1] == "deg":
        return r"{}^{\circ}"
    raised = RAISED.sub(r"^{\1}", found[1]).replace("*", r"{\cdot}")
    return rf"\mathrm{{{raised}}}"
