"""Which instances are fit for students, and for which reason the others are not."""

from __future__ import annotations

import pytest

from kinegrade.draws.examining import LARGEST, SMALLEST, Refused, solve_sensible
from kinegrade.problem.holding import condition_holds
from kinegrade.problem.template.template import Template
from tests.problem.crank import crank


def refusal(template: Template, **values: str) -> Refused:
    with pytest.raises(Refused) as caught:
        solve_sensible(
            template, {"r": "2", "h": "1/2", "omega": "2", **values}, template.asked(), None
        )
    return caught.value


@pytest.mark.parametrize(
    ("values", "reason", "detail"),
    [
        ({"omega": "20000000"}, "condition", "omega < 10000000"),
        (
            {"h": "3"},
            "mechanism",
            "crank: points.A: the circle about O of radius 2 does not reach the line y = 3",
        ),
        ({"h": "0"}, "degenerate", "v_x is zero"),
        ({"omega": "1000000"}, "absurd", "v_x is -500000 m/s"),
    ],
)
def test_an_instance_is_refused_for_a_reason(
    values: dict[str, str], reason: str, detail: str
) -> None:
    refused = refusal(crank(), **values)
    assert refused.reason == reason
    assert str(refused).startswith(detail)


def test_zero_is_a_proper_answer_where_the_template_says_so() -> None:
    vanishing = crank(('sign = "+x", points', 'sign = "+x", vanishes = true, points'))
    solution = solve_sensible(vanishing, {"r": "2", "h": "0", "omega": "2"}, ("v_x",), None)
    assert solution["v_x"].is_zero


def test_only_the_answers_asked_for_must_be_sensible() -> None:
    assert (
        solve_sensible(crank(), {"r": "2", "h": "2", "omega": "2"}, ("v_x",), None)["v_x"].exact
        == "-4"
    )
    with pytest.raises(Refused, match="v_y is zero"):
        solve_sensible(crank(), {"r": "2", "h": "2", "omega": "2"}, ("v_x", "v_y"), None)


def test_the_bounds_of_sensible_answers_are_sensible_themselves() -> None:
    for size in (SMALLEST, LARGEST):
        assert solve_sensible(
            crank(), {"r": "2", "h": "1", "omega": f"{size:.3f}"}, ("v_x",), None
        ).answers
    assert refusal(crank(), h="1", omega="0.0009999").reason == "absurd"
    assert refusal(crank(), h="1", omega="100000.1").reason == "absurd"


@pytest.mark.parametrize(
    ("condition", "held"),
    [
        ("h < r", True),
        ("r < h", False),
        ("r < 2", False),
        ("r <= 2", True),
        ("sqrt(3) < r*sqrt(3)/2", False),
        ("sqrt(3) <= r*sqrt(3)/2", True),
        ("sin(r) < 1", True),
        ("1/(r - 2) < 1", False),
        ("sqrt(h - r) < 9", False),
        ("atan(h) < pi/2", True),
        ("pi/2 < atan(h)", False),
        ("pi/4 < pi/3", True),
        ("0 < atan(h)", True),
        ("r > 2", False),
        ("r >= 2", True),
        ("r > h", True),
        ("sqrt(3)*r == sqrt(12)", True),
        ("r == h", False),
        ("r != h", True),
        ("sqrt(3)*r != sqrt(12)", False),
        ("sin(r) == cos(r)", False),
    ],
)
def test_conditions_are_decided_exactly_at_their_bounds(condition: str, held: bool) -> None:
    template = crank(("omega < 10000000", condition), kept=True)
    assert (
        condition_holds(
            template, template.scheme.conditions[0], {"r": "2", "h": "1/2", "omega": "1"}
        )
        is held
    )


@pytest.mark.parametrize(
    ("condition", "held"),
    [
        ("distance(O, A) <= 2", True),
        ("distance(O, A) < 2", False),
        ("y(meet(circle(O, r), circle(A, 1/10), upper)) > 0", True),
        ("y(meet(circle(O, r), circle(A, 5), upper)) > 0", False),  # they do not meet
    ],
)
def test_conditions_may_name_points_and_fail_where_these_cannot_be_constructed(
    condition: str, held: bool
) -> None:
    template = crank(("omega < 10000000", condition), kept=True)
    (stated,) = template.scheme.conditions
    assert condition_holds(template, stated, {"r": "2", "h": "1/2", "omega": "1"}) is held


def test_a_magnitude_that_is_negative_is_never_dealt() -> None:
    negative = crank(('sign = "+x", points', 'sign = "magnitude", points'))
    assert str(refusal(negative)) == "v_x is negative, though papers would say that it is not"
