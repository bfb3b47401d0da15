"""Formulas as Typst code: equations with the words that stand in for them where a page is heard."""

from __future__ import annotations

from functools import lru_cache

from kinegrade.language import Language
from kinegrade.language.math.reading import read_math
from kinegrade.language.math.spoken.speaking import speak_row
from kinegrade.language.math.tree import Row
from kinegrade.language.math.typst.formula import write_typst_row
from kinegrade.language.message import Location
from kinegrade.language.typst_text import write_literal


def write_formula(latex: str, where: Location, language: Language) -> str:
    """A formula as Typst code, in its line. Raises TypesetError with its faults, which name
    `where`.

    >>> write_formula("v_B", "q1", Language("en"))
    'math.equation(alt:"v B",$v_(B)$.body)'
    """
    read_math(latex, where)
    return _write_once(latex, language)


@lru_cache(maxsize=8192)
def _write_once(latex: str, language: Language) -> str:
    return write_equation(read_math(latex, ""), language)


def write_equation(row: Row, language: Language, math: str | None = None) -> str:
    """A tree as Typst code, in its line; `math` is the Typst math of it where that is set in a way
    of its own.
    """
    written = write_typst_row(row) if math is None else math
    return f"math.equation({_write_alternative((row,), language)},${written}$.body)"


def write_display(rows: tuple[Row, ...], language: Language) -> str:
    """Equations below each other as Typst code, on lines of their own.

    >>> write_display((read_math("x = 1", "q1"),), Language("en"))
    'math.equation(block:true,alt:"x equals 1",$x = 1$.body)'
    """
    written = " \\ ".join(map(write_typst_row, rows))
    return f"math.equation(block:true,{_write_alternative(rows, language)},${written}$.body)"


def _write_alternative(rows: tuple[Row, ...], language: Language) -> str:
    said = "; ".join(speak_row(row, language) for row in rows)
    return f"alt:{write_literal(said)}"
