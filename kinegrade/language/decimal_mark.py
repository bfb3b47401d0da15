"""Decimal numbers with the decimal mark of a language: 0.25 or 0,25."""

from __future__ import annotations

import re

from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue

_POINT = re.compile(r"(?<=[0-9])\.(?=[0-9])")
_FORMULA = re.compile(r"\$[^$]*\$")


def write_decimal_text(number: str, language: Language) -> str:
    """A number of plain text, written with a point, as the language writes it.

    >>> write_decimal_text("-0.25", Language("en"))
    '-0.25'
    """
    return _POINT.sub(open_catalogue(language).decimal_mark, number)


def write_decimals_of_math(latex: str, language: Language) -> str:
    """LaTeX math whose decimals are written as the language writes them; a comma stands in braces,
    or a blank would follow it.
    """
    mark = open_catalogue(language).decimal_mark
    return latex if mark == "." else _POINT.sub(f"{{{mark}}}", latex)


def write_decimals_of_prose(markdown: str, language: Language) -> str:
    """Prose whose formulas have their decimals as the language writes them; its words stay."""
    return _FORMULA.sub(lambda formula: write_decimals_of_math(formula[0], language), markdown)
