"""A sign convention that the quantity cannot have, or that makes it count the other way, is
refused when the template is read: students would be told the reverse of the key.
"""

from __future__ import annotations

import pytest

from kinegrade.errors import TemplateError
from tests.problem.crank import crank

ASK = '\n[asks]\nw = { quantity = "%s", unit = "%s", sign = "%s", means = { en = "w", zh = "w 量" } }\n'


def faults(quantity: str, unit: str, sign: str) -> list[str]:
    with pytest.raises(TemplateError) as refusal:
        crank(("\n[asks]\n", ASK % (quantity, unit, sign)))
    return list(refusal.value.problems)


@pytest.mark.parametrize(
    ("quantity", "unit", "sign", "problem"),
    [
        (
            "omega(OA)",
            "rad/s",
            "cw",
            '"cw" does not go with omega(...) - expected "ccw" or "signed" - where "cw" is meant, '
            'write quantity = "-omega(...)"',
        ),
        (
            "-alpha(OA)",
            "rad/s^2",
            "ccw",
            '"ccw" does not go with -alpha(...) - expected "cw" or "signed" - where "ccw" is '
            'meant, write quantity = "alpha(...)"',
        ),
        (
            "omega(OA)",
            "r/min",
            "+x",
            '"+x" does not go with omega(...) - expected "ccw" or "signed"',
        ),
        (
            "x(velocity(A))",
            "m/s",
            "ccw",
            '"ccw" does not go with x(...) - expected "+x" or "signed"',
        ),
        (
            "x(velocity(A))",
            "m/s",
            "-x",
            '"-x" does not go with x(...) - expected "+x" or "signed" - where "-x" is meant, '
            'write quantity = "-x(...)"',
        ),
        (
            "y(velocity(A))",
            "m/s",
            "+x",
            '"+x" does not go with y(...) - expected "+y" or "signed"',
        ),
        (
            "2*omega(OA)",
            "rad/s",
            "-y",
            '"-y" does not go with "rad/s" - expected "ccw", "cw" or "signed"',
        ),
        (
            "2*x(velocity(A))",
            "m/s",
            "cw",
            '"cw" does not go with "m/s" - expected "+x", "-x", "+y", "-y" or "signed"',
        ),
    ],
)
def test_a_sign_that_the_quantity_cannot_have_is_refused(
    quantity: str, unit: str, sign: str, problem: str
) -> None:
    [fault] = faults(quantity, unit, sign)
    assert f"asks.w.sign: {problem}" in fault
    assert fault.endswith(problem)


@pytest.mark.parametrize(
    ("quantity", "unit", "sign"),
    [
        ("-omega(OA)", "rad/s", "cw"),
        ("-y(velocity(A))", "m/s", "-y"),
        ("omega(OA)", "rad/s", "signed"),
        ("omega(OA)", "rad/s", "as the crank turns"),
        ("2*omega(OA)", "rad/s", "ccw"),
        ("angle(A - O, velocity(A))", "deg", "ccw"),
        ("x(A - O)/r", "1", "+x"),
    ],
)
def test_a_sign_that_fits_is_read(quantity: str, unit: str, sign: str) -> None:
    assert crank(("\n[asks]\n", ASK % (quantity, unit, sign))).asks["w"]
