"""A quantity prints exactly, in LaTeX, as a decimal of any length, and as a problem states it."""

from __future__ import annotations

import json

import pytest
from flint import arb, ctx, fmpq

from kinegrade.numbers.angle import Angle
from kinegrade.numbers.field import Field
from kinegrade.numbers.units import read_unit
from kinegrade.problem.quantity import Quantity, express_in_unit

ROOT_3 = "1.732050807568877293527446341505872366943"


def quantity(number: object, unit: str = "m/s") -> Quantity:
    return express_in_unit("v", number, read_unit(unit))


def test_a_surd_is_exact_in_every_notation() -> None:
    v = quantity(Field().sqrt(fmpq(3)))
    assert (v.is_exact, v.exact, v.latex, v.is_zero) == (True, "sqrt(3)", r"\sqrt{3}", False)
    assert (v.decimal(40), v.value) == (ROOT_3, 3**0.5)


def test_an_enclosure_has_a_decimal_and_no_exact_form() -> None:
    previous, ctx.prec = ctx.prec, 200
    try:
        v = quantity(arb(3).sqrt())
        assert (v.is_exact, v.exact, v.latex, v.is_zero) == (False, None, None, False)
        assert (v.decimal(40), v.given_text) == (ROOT_3, "1.73205")
    finally:
        ctx.prec = previous


@pytest.mark.parametrize(
    ("number", "text"),
    [
        (fmpq(1, 4), "0.25"),
        (fmpq(12), "12"),
        (fmpq(-3, 8), "-0.375"),
        (fmpq(1, 10**6), "0.000001"),
        (fmpq(1, 3), r"\frac{1}{3}"),
        (fmpq(1, 10**7), r"\frac{1}{10000000}"),
        (fmpq(0), "0"),
    ],
)
def test_a_problem_states_short_decimals_and_leaves_fractions(number: object, text: str) -> None:
    assert quantity(number).given_text == text


@pytest.mark.parametrize(
    ("angle", "exact", "stated"),
    [
        (Angle(fmpq(1, 3)), "60", "60"),
        (Angle(fmpq(-1, 8)), "-45/2", "-22.5"),
        (Angle(fmpq(0)), "0", "0"),
    ],
)
def test_degrees_leave_as_degrees(angle: Angle, exact: str, stated: str) -> None:
    phi = quantity(angle, "deg")
    assert (phi.exact, phi.given_text, phi.decimal(5)) == (exact, stated, stated)


def test_units_are_left_by_their_factor() -> None:
    assert quantity(fmpq(1, 4), "mm").exact == "250"
    assert quantity(fmpq(1, 3), "1").exact == "1/3"
    assert quantity(3, "m").exact == "3"


def test_zero_is_known_in_every_form() -> None:
    assert quantity(fmpq(0)).is_zero
    assert quantity(Angle(fmpq(0)), "deg").is_zero
    assert quantity(arb(0, 1e-50)).is_zero
    assert not quantity(Angle(fmpq(1, 7)), "deg").is_zero


def test_the_record_is_what_the_key_and_json_hold() -> None:
    record = quantity(Field().sqrt(fmpq(3)) * -1).record()
    assert record == {
        "exact": "-sqrt(3)",
        "value": -(3**0.5),
        "unit": "m/s",
        "decimal": f"-{ROOT_3}",
    }
    assert json.loads(json.dumps(record)) == record
