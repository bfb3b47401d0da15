r"""Math and units in HTML as learning management systems show it: formulas between `\(` and `\)`,
set by MathJax.

Every character that comes in is escaped; the only tags are those made here, and they are
well-formed XML too.
"""

from __future__ import annotations

import re
from functools import lru_cache
from html import escape

from kinegrade.language.math.latex import MATHJAX, write_latex_math, write_latex_row
from kinegrade.language.math.tree import Row
from kinegrade.language.math.units import raise_exponents, write_unit

# What no XML document may hold
_CONTROL = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\ufffe\uffff\ud800-\udfff]")


def write_plain_html(text: str) -> str:
    """A text as it is; control characters, which XML cannot hold, become blanks.

    >>> write_plain_html("a < b")
    'a &lt; b'
    """
    return escape(_CONTROL.sub(" ", text))


@lru_cache(maxsize=4096)
def write_math_html(latex: str, where: str = "text") -> str:
    r"""A formula between MathJax's delimiters, in the LaTeX that MathJax knows.

    Raises TypesetError where it holds anything but the math that every press prints.

    >>> write_math_html(r"v_B = 2\,\unit{m/s^2}")
    '\\(v_{B} = 2\\,\\mathrm{m/s^{2}}\\)'
    """
    return rf"\({write_plain_html(write_latex_math(latex, where, MATHJAX))}\)"


def write_row_html(row: Row) -> str:
    """A formula between MathJax's delimiters, by its tree."""
    return rf"\({write_plain_html(write_latex_row(row, MATHJAX))}\)"


def write_display_html(row: Row) -> str:
    """A formula on lines of its own between MathJax's delimiters, by its tree."""
    return rf"\[{write_plain_html(write_latex_row(row, MATHJAX))}\]"


def write_unit_html(unit: str) -> str:
    """A unit with raised exponents; "" for a pure number.

    >>> write_unit_html("rad/s^2"), write_unit_html("deg"), write_unit_html("1")
    ('rad/s<sup>2</sup>', '°', '')
    """
    return write_unit(write_plain_html(unit), "", _write_symbols)


def _write_symbols(unit: str) -> str:
    return raise_exponents(unit, write_raised=_write_sup)


def _write_sup(exponent: str) -> str:
    return f"<sup>{exponent.replace('-', '−')}</sup>"
