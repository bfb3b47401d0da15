"""The table of typed answers, typed_answers.tsv, which any instructor may review; values are
checked by sympy.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from fractions import Fraction
from functools import cache
from pathlib import Path

import pytest
import sympy

from kinegrade.grading.typed.answers import Reading, read
from kinegrade.grading.typed.decimal_style import find_file_style
from kinegrade.grading.typed.number_text import DecimalStyle
from kinegrade.language import ENGLISH
from kinegrade.problem.template.signs import write_sign
from kinegrade.sign_conventions import CONVENTIONS
from tests.said import said

TABLE = Path(__file__).with_name("typed_answers.tsv")
STYLES = {
    "comma": find_file_style([], "comma").style, "point": find_file_style([], "point").style,
    "undecided": find_file_style([]).of_row(["0,5", "1,234.5"]),
}  # fmt: skip
DIGITS = 60


def table() -> Iterator[tuple[str, str, str, str, str]]:
    for line in TABLE.read_text(encoding="utf-8").split("\n"):
        if line and not line.startswith("#"):
            typed, unit, context, reading, remark = line.split("\t")
            yield unescaped(typed), unit, context, reading, remark


def unescaped(text: str) -> str:
    """With the invisible characters in place of \\uXXXX, \\t and \\n."""
    plain = re.sub(r"\\u([0-9a-f]{4})", lambda code: chr(int(code[1], 16)), text)
    return plain.replace("\\t", "\t").replace("\\n", "\n")


ROWS = list(table())


@cache
def expected(expression: str) -> tuple[Fraction, bool]:
    """A value to 60 digits and whether it is rational, by an independent hand."""
    value = sympy.nsimplify(sympy.sympify(expression, rational=True))
    if value.is_Rational:
        return Fraction(int(value.p), int(value.q)), True
    return Fraction(str(sympy.N(value, DIGITS))), False


def test_the_table_is_long_and_says_nothing_twice() -> None:
    assert len(ROWS) >= 250
    assert len({row[:3] for row in ROWS}) == len(ROWS)


@pytest.mark.parametrize(("typed", "unit", "context", "reading", "remark"), ROWS)
def test_typed_answers(typed: str, unit: str, context: str, reading: str, remark: str) -> None:
    convention = next((each for each in CONVENTIONS if each == context), None)
    words = write_sign(convention, ENGLISH) if convention else ""
    found = read(typed, unit, STYLES.get(context, DecimalStyle()), convention, words)
    assert found.typed == typed
    kind, _, reason = reading.partition(": ")
    if kind in ("blank", "unreadable", "wrong unit"):
        assert (found.kind, found.value, found.remark) == (kind, None, "")
        assert reason.replace("\\\\", "\\") in said(found.reason)
        return
    assert (found.kind, found.reason) == ("number", "")
    assert remark in said(found.remark)
    assert bool(remark) is bool(found.remark)
    assert_value(found, reading)


def assert_value(found: Reading, expression: str) -> None:
    value, rational = expected(expression)
    assert found.value is not None
    if rational:
        assert (found.value, found.error) == (value, 0)
    else:
        assert abs(found.value - value) <= found.error <= abs(value) / 10**37
    assert float(found.read_as) == pytest.approx(float(value), rel=1e-11)
