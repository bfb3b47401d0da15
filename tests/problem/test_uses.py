"""A name that is used where it is not known is reported once, at the first such place."""

from __future__ import annotations

import pytest

from tests.problem.turning_crank import faults


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        (
            '[lengths]\nhalf = "r/2"',
            "",
            [
                'crank.toml:20: points.M: unknown name "half" - known here: A, O, clockwise and 9 more'
            ],
        ),
        (
            'velocity = "omega"',
            'velocity = "omeg"',
            ['crank.toml:5: inputs[1].velocity: unknown name "omeg" - did you mean "omega"?'],
        ),
        (
            '"r < 2"',
            '"R < 2"',
            ['crank.toml:6: conditions[1]: unknown name "R" - did you mean "r"?'],
        ),
        (
            '"r < 2"',
            '"phi < 90"',
            [
                'crank.toml:6: conditions[1]: "phi < 90": an angle against a number - write degrees as parts of pi, like phi < pi/2'
            ],
        ),
        (
            'half = "r/2"',
            'half = "R/2"',
            [
                'crank.toml:16: lengths.half: unknown name "R" - did you mean "r"? (known here: omega, phi, pi, r)'
            ],
        ),
        (
            "gives = { v_A",
            "gives = { v_B",
            [
                'crank.toml:31: published[1].gives.v_B: no ask "v_B" - did you mean "v_A"? (known here: v_A)'
            ],
        ),
        (
            '"omega*r"',
            '"omega*R"',
            [
                'crank.toml:31: published[1].gives.v_A: unknown name "R" - did you mean "r"? (known here: omega, phi, pi, r)'
            ],
        ),
        (
            "gives = {",
            "given = { R = 2 }\ngives = {",
            [
                'crank.toml:31: published[1].given.R: no parameter "R" - did you mean "r"? (known here: omega, phi, r)'
            ],
        ),
        (
            'A = "polar(O, r, phi)"',
            'A = "polar(O, r, psi)"',
            ['crank.toml:20: points.A: unknown name "psi" - did you mean "pi" or "phi"?'],
        ),
        (
            'A = "polar(O, r, phi)"',
            'A = "polar(M, r, phi)"',
            [
                'crank.toml:20: points.A: unknown name "M" - known here: O, clockwise, counterclockwise and 9 more'
            ],
        ),
        (
            'half = "r/2"',
            'half = "whole/2"\nwhole = "r"',
            ['crank.toml:16: lengths.half: unknown name "whole" - known here: omega, phi, pi, r'],
        ),
        (
            "pin O: ground OA",
            "pin O: ground OAB",
            [
                'crank.toml:4: joints[1]: no body "OAB" - did you mean "OA"? (known here: OA, ground)'
            ],
        ),
        (
            "pin O: ground OA",
            "pin Q: ground OA",
            ['crank.toml:4: joints[1]: no point "Q" - known here: A, M, O'],
        ),
        (
            "pin O: ground OA",
            "A of OA slides on line(Q, psi)",
            [
                'crank.toml:4: joints[1]: unknown name "Q" - known here: A, M, O and 11 more',
                'crank.toml:4: joints[1]: unknown name "psi" - did you mean "pi" or "phi"?',
            ],
        ),
        (
            '"OA turns"',
            '"OB turns relative to OC"',
            [
                'crank.toml:5: inputs[1].motion: no body "OB" - known here: OA, ground',
                'crank.toml:5: inputs[1].motion: no body "OC" - known here: OA, ground',
            ],
        ),
        (
            '"OA turns"',
            '"B of OA circles C"',
            [
                'crank.toml:5: inputs[1].motion: no point "B" - known here: A, M, O',
                'crank.toml:5: inputs[1].motion: no point "C" - known here: A, M, O',
                "crank.toml:5: inputs[1]: its velocity is an angular velocity (rad/s) - expected a velocity (m/s) - check the units",
            ],
        ),
        (
            '"OA turns"',
            '"A of OA moves along direction(O, B)"',
            [
                'crank.toml:5: inputs[1].motion: unknown name "B" - known here: A, M, O and 11 more',
                "crank.toml:5: inputs[1]: its velocity is an angular velocity (rad/s) - expected a velocity (m/s) - check the units",
            ],
        ),
        (
            "magnitude(velocity(A))",
            "omega(AB)",
            [
                'crank.toml:27: asks.v_A.quantity: unknown name "AB" - did you mean "A"?',
                'crank.toml:27: asks.v_A.quantity: this is an angular velocity (rad/s): it cannot be counted in "m/s" - write unit = "rad/s", or ask for something else',
            ],
        ),
        (
            '"omega*r"',
            '"omega*half"',
            [
                'crank.toml:31: published[1].gives.v_A: unknown name "half" - known here: omega, phi, pi, r'
            ],
        ),
    ],
)
def test_a_name_that_is_not_there_is_reported_where_it_is_used(
    old: str, new: str, expected: list[str]
) -> None:
    assert faults((old, new)) == expected


def test_a_name_that_is_used_often_is_one_fault() -> None:
    assert faults(("r = { unit", "R = { unit"), ('conditions = ["r < 2"]', "")) == [
        'crank.toml:16: lengths.half: unknown name "r" (and at 4 more places) - '
        'did you mean "R"? (known here: R, omega, phi, pi)'
    ]


@pytest.mark.parametrize(
    "change",
    [
        ('half = "r/2"', 'half = "r/"'),
        ('unit = "deg"', 'unit = "grad"'),
        ('A = "polar(O, r, phi)"', 'A = "polar(O, r phi)"'),
        ('OA = "O A M"', 'OA = ""'),
        ('unit = "m/s"', 'unit = "knots"'),
        ("[lengths]", "[length]"),
        ("[asks]", "[ask]"),
        ("[points]", "[point]"),
    ],
)
def test_what_is_made_of_a_faulty_line_is_no_second_fault(change: tuple[str, str]) -> None:
    more = (
        ('"r < 2"', '"r < 2", "phi < pi/2"'),
        ('"pin O: ground OA"', '"pin O: ground OA", "A of OA slides on line(O, A)"'),
        ("[bodies]", '[figure]\nlabels = { A = "A_1", OA = "1" }\n[bodies]'),
    )
    assert len(faults(change, *more)) == 1
