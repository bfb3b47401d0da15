"""A number in a file is read exactly, whoever wrote it, and never works for days."""

from __future__ import annotations

import gc
from collections.abc import Iterator
from decimal import Decimal
from fractions import Fraction
from time import process_time

import pytest

from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.numbers.written import NumberError, read_number


@pytest.mark.parametrize(
    ("found", "value"),
    [
        ("0.1", Fraction(1, 10)),
        (0.1, Fraction(1, 10)),
        (Decimal("1.50"), Fraction(3, 2)),
        ("-2/3", Fraction(-2, 3)),
        ("1e300", Fraction(10**300)),
        ("+.5", Fraction(1, 2)),
        ("5.", Fraction(5)),
        ("-2.5E-3", Fraction(-1, 400)),
        ("0." + "3" * 500, Fraction(10**500 // 3, 10**500)),
        (7, Fraction(7)),
        (Fraction(1, 3), Fraction(1, 3)),
    ],
)
def test_what_stands_there_is_the_value_exactly(found: object, value: Fraction) -> None:
    assert read_number(found) == value


@pytest.fixture
def uncollected() -> Iterator[None]:
    """Nothing is timed that the collector of garbage does for other tests."""
    gc.disable()
    yield
    gc.enable()


@pytest.mark.parametrize(
    "found",
    [
        "1e9999999999", "-1e9999999999", "1e-9999999999", "1e301", "9" * 10_000, 9**4000, float("nan"), float("inf"),
        Decimal("1e9999999999"), Decimal("NaN"), "1/0", "", ".", "e5", "x", "1 2", "１", True, None, [], {},
    ],
)  # fmt: skip
@pytest.mark.usefixtures("uncollected")
def test_anything_else_is_refused_at_once_and_briefly(found: object) -> None:
    start = process_time()
    with pytest.raises(NumberError, match="expected a number between -1e300 and 1e300") as caught:
        read_number(found)
    assert process_time() - start < 0.1
    assert len(str(caught.value)) < 120


def test_a_refusal_says_what_stands_there_in_every_language() -> None:
    with pytest.raises(NumberError) as caught:
        read_number("1,5")
    assert str(caught.value) == '"1,5" - expected a number between -1e300 and 1e300'
    (fault,) = caught.value.faults
    assert open_catalogue(Language("zh")).write(fault) == '"1,5" - 应为-1e300 与 1e300 之间的数'
