"""What shows only where numbers are put in is refused with the name of the template and the place."""

from __future__ import annotations

import pytest

from kinegrade.errors import MechanismError, TemplateError
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template
from kinegrade.problem.template.library.reading import read_template
from tests.problem.turning_crank import CRANK, solving


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (
            ('A = "polar(O, r, phi)"', 'A = "r"'),
            "crank: points.A: expected a point, like (x, y) or polar(O, r, phi)",
        ),
        (
            ('A = "polar(O, r, phi)"', 'A = "O + r"'),
            'crank: points.A: "+" between things that do not go together',
        ),
        (
            ('A = "polar(O, r, phi)"', 'A = "meet(circle(O, r), line((0, 3), 0), right)"'),
            "crank: points.A: the circle about O of radius 1 does not reach the line y = 3",
        ),
        (
            ('"pin O: ground OA"', '"pin O: ground OA", "A of OA slides on line(O, right)"'),
            "crank: A of OA slides on line(O, right): line cannot be made from the arguments in its "
            "brackets",
        ),
        (
            ('"pin O: ground OA"', '"pin O: ground OA", "A of OA slides on line(r, 0)"'),
            "crank: A of OA slides on line(r, 0): line cannot be made from the arguments in its "
            "brackets",
        ),
        (
            ('"pin O: ground OA"', '"pin O: ground OA", "circle(O, A) of OA touches line(A, 0)"'),
            "crank: circle(O, A) of OA touches line(A, 0): expected a number",
        ),
        (
            ('"OA turns", velocity = "omega"', '"OA turns", velocity = "A"'),
            "crank: OA turns: expected a number",
        ),
        (
            ('"OA turns"', '"A of OA moves along A - O"'),
            "moves along ...: expected +x, -x, +y, -y or an angle",
        ),
        (('A = "polar(O, r, phi)"', 'A = "(right, 0)"'), "crank: points.A: expected a number"),
        (
            ("magnitude(velocity(A))", "velocity(A)"),
            "crank: v_A: expected a number: take magnitude(...), x(...), y(...)",
        ),
        (("magnitude(velocity(A))", "OA"), "crank: v_A: expected a number"),
        (("magnitude(velocity(A))", "line(O, A)"), "crank: v_A: expected a number"),
        (
            ('omega(OA)", unit = "deg"', 'omega(OA)", unit = "deg"'),
            "crank: turned: expected an angle: degrees count angle(...)",
        ),
        (
            ("magnitude(velocity(A))", "magnitude(velocity(r))"),
            "crank: v_A: expected a point's name here",
        ),
        (
            ("magnitude(velocity(A))", "magnitude(velocity(A + O))"),
            "crank: v_A: expected a point's name here",
        ),
        (
            ("magnitude(velocity(A))", "omega(A)"),
            'crank: v_A: "A" is a point: expected the name of a body here',
        ),
        (
            ("magnitude(velocity(A))", "x(pole(OA)) + speed(A)"),
            'crank: v_A: unknown function "speed"',
        ),
        (
            ("magnitude(velocity(A))", "y(velocity(P))"),
            "crank: v_A: point P belongs to no body: name the body that "
            "carries it, like velocity(P, OA)",
        ),
        (
            ("magnitude(velocity(A))", "y(velocity(A))/(r - 1)"),
            "crank: v_A: division by zero: check the values given",
        ),
        (
            ("magnitude(velocity(A))", "angle(velocity(O), velocity(A))"),
            "crank: v_A: angle(...): the direction of a zero vector",
        ),
    ],
)
def test_what_shows_only_at_an_instance_is_told_with_its_place(
    change: tuple[str, str], message: str
) -> None:
    more = (
        '[asks]\nturned = { quantity = "omega(OA)", unit = "deg", means = { en = "turned", zh = '
        '"转" } }'
    )
    more = more if "deg" in change[0] else "[asks]"
    assert message in solving(
        ('M = "polar(O, half, phi)"', 'M = "polar(O, half, phi)"\nP = "(1, 1)"'),
        ("[asks]", more),
        change,
    )


def test_a_point_of_two_bodies_that_are_not_pinned_needs_its_body() -> None:
    text = solving(
        ('OA = "O A M"', 'OA = "O A M"\nBC = "A"'),
        (
            '"pin O: ground OA"',
            '"pin O: ground OA", "BC turns with OA", '
            '"A of BC slides on line(O, A) of OA", "A of BC slides on line(O, pi/2)"',
        ),
        ('"O A M"', '"O A M"'),
        phi="90",
    )
    assert (
        "dead point" in text or "can still" in text or "name the body, like velocity(A, OA)" in text
    )


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"R": "1"}, 'crank: no parameter "R": did you mean "r"? (known here: omega, phi, r)'),
        (
            {"r": "1,5"},
            'crank: r = 1,5: "1,5", character 2: found ",", expected an operator or the end',
        ),
        ({"r": "x\ny"}, 'crank: r = x·y: "x·y", character 3'),
        ({"r": "q"}, 'crank: r: unknown name "q": known here: pi'),
        ({"r": "sqrt(-1)"}, "crank: r: sqrt(...): square root of a negative number"),
        ({"phi": "60 + pi"}, 'crank: phi: "+" between things that do not go together'),
    ],
)
def test_values_that_are_no_numbers(values: dict[str, str], message: str) -> None:
    with pytest.raises(TemplateError) as refusal:
        solve_template(read_template("crank", CRANK), values)
    assert refusal.value.problems == (str(refusal.value),)
    assert message in str(refusal.value)


def test_all_unknown_parameters_are_told_at_once_and_unknown_asks_too() -> None:
    template = read_template("crank", CRANK)
    with pytest.raises(TemplateError) as refusal:
        solve_template(template, {"a": "1", "b": "2", "r": "("})
    assert len(refusal.value.problems) == 3
    with pytest.raises(TemplateError, match='crank: no ask "v_B": did you mean "v_A"'):
        solve_template(template, {}, ["v_B"])


def test_values_that_no_precision_tells_from_degenerate_ones_are_refused() -> None:
    # 2 cos(1 degree) cos(2 degrees) = cos(3 degrees) + cos(1 degree): zero, but not for balls
    zero = "2*cos(pi/180)*cos(pi/90) - cos(pi/60) - cos(pi/180)"
    assert "cannot be distinguished from a degenerate one" in solving(
        ('quantity = "magnitude(velocity(A))"', f'quantity = "y(velocity(A))/({zero})"')
    )


def test_a_mechanism_that_is_refused_names_its_template() -> None:
    with pytest.raises(
        MechanismError, match=r"slider-crank: points\.B: the circle about A of radius 0\.5 does not"
    ):
        solve_template(load_template("slider-crank"), {"k": "1/2", "phi": "90"})
