"""What is written wrong once is one fault, however often it is used."""

from __future__ import annotations

import pytest

from tests.problem.consistency import faults


def test_a_named_length_of_two_dimensions_is_refused_once() -> None:
    lengths = '\n[lengths]\nmixed = "h + omega"\n\n[points]\n'
    assert faults(("\n[points]\n", lengths), ('"(0, h)"', '"(mixed, mixed)"')) == [
        'crank.toml:19: lengths.mixed: "+": a length (m) and an angular velocity (rad/s) '
        "do not go together - check the units"
    ]


def test_one_unreadable_unit_is_one_fault() -> None:
    assert faults(('r     = { unit = "m"', 'r     = { unit = "furlong"')) == [
        'crank.toml:14: parameters.r.unit: unit "furlong" - expected a product or quotient like m/s^2 of '
        "1, cm, deg, ft, h, in, km, m, min, mm, r, rad, rpm, s"
    ]


def test_one_wrong_unit_is_one_fault() -> None:
    (fault,) = faults(('h     = { unit = "m"', 'h     = { unit = "s"'))
    assert fault == (
        'crank.toml:15: parameters.h.unit: "s" does not fit where h is used (2 faults), as in points.P: '
        "its coordinates are a time (s) - expected a length (m) - check the units"
    )


def test_one_point_or_ask_that_cannot_be_read_is_one_fault() -> None:
    assert faults(('"(0, h)"', '"(0, h"')) == [
        'crank.toml:20: points.P: "(0, h", character 6: found the end, expected "," or ")"'
    ]
    assert faults(('"(0, 0)"', '"(0 0)"')) == [
        'crank.toml:19: points.O: "(0 0)", character 4: found "0", expected "," or ")"'
    ]
    assert faults(('"x(velocity(A))"', '"x(velocity(A)"')) == [
        'crank.toml:27: asks.v_x.quantity: "x(velocity(A)", character 14: found the end, expected "," or ")"'
    ]


@pytest.mark.parametrize(
    ("changes", "fault"),
    [
        (
            [("h     = {", "height = {")],
            '20: points.P: unknown name "h" (and at 3 more places) - '
            "known here: O, clockwise, counterclockwise and 8 more",
        ),
        (
            [('OA = "O A"', 'CA = "O A"')],
            '5: joints[1]: no body "OA" (and at 1 more place) - known here: CA, ground',
        ),
        (
            [('quantity = "x(v', 'qantity = "x(v')],
            '27: asks.v_x.qantity: unknown key - did you mean "quantity"? (known here: cyclic, '
            "means, points, quantity, sign, symbol, unit, vanishes)",
        ),
    ],
)
def test_one_misspelt_name_does_not_flood_its_author(
    changes: list[tuple[str, str]], fault: str
) -> None:
    assert faults(*changes) == [f"crank.toml:{fault}"]


def test_one_misspelt_table_does_not_make_every_name_unknown() -> None:
    assert faults(("[parameters]", "[parameter]")) == [
        'crank.toml:13: parameter: unknown table or key - did you mean "parameters"?'
    ]
