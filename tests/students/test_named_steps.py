"""Questions with steps in place of a mechanism: what follows from a student's values, and what the
author's mistakes lead to, by hand.
"""

from __future__ import annotations

import pytest

from kinegrade.numbers.field import Field
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.reading import read_template
from kinegrade.students.following.connections import find_stages
from kinegrade.students.following.followed_steps import StepFollower
from kinegrade.students.mistaking.mistake_kinds import find_candidates
from kinegrade.students.mistaking.mistakes import choose_way, find_known_mistakes, work_out

FALL = read_template(
    "fall",
    """
statement = "{{ g }} {{ h }} {{ u }}"
parameters.g = { unit = "m/s^2", draw = [10] }
parameters.h = { unit = "m", draw = [20, 45] }
parameters.u = { unit = "m/s", draw = [20, 30] }
steps.t = "sqrt(2*h/g)"
steps.x = "u*t"
steps.v_y = "g*t"
steps.beta = "atan(v_y/u)"
asks.x = { unit = "cm", means = "the reach" }
asks.v_y = { unit = "m/s", means = "down" }
asks.beta = { unit = "deg", means = "below the horizontal" }
mistakes.no-root = { steps.t = "h/u", means = "It is not at the speed u that it falls." }
""",
    kept=True,
)
AT = {"g": 10.0, "h": 20.0, "u": 20.0}  # it falls for 2 s


@pytest.mark.parametrize(
    ("own", "later", "follows"),
    [
        ({"v_y": 40.0}, "beta", (63.43494882,)),  # the arctangent of 2
        ({"v_y": 20.0}, "beta", (45.0,)),  # right, as is what follows
        ({"x": 1000.0}, "beta", ()),  # of which nothing depends on the reach
        ({"beta": 30.0}, "v_y", ()),  # found before
        ({"x": 1000.0, "v_y": 40.0}, "beta", (63.43494882,)),
        ({"v_y": 0.0}, "beta", ()),
        ({}, "beta", ()),
    ],
)
def test_later_steps_follow_from_own_values(
    own: dict[str, float], later: str, follows: tuple[float, ...]
) -> None:
    assert StepFollower(FALL, AT).consequences(own, later) == pytest.approx(follows)


def test_answers_are_in_their_units_and_come_in_the_order_of_the_steps() -> None:
    follower = StepFollower(FALL, AT)
    assert follower.right("x") == pytest.approx(4000)  # 40 m
    assert StepFollower(FALL, {**AT, "g": 0.0}).right("x") is None
    assert find_stages(FALL, ["beta", "x"]) == [["x"], ["beta"]]


def test_the_authors_mistake_runs_on_exactly_and_for_many_instances_alike() -> None:
    solution = solve_template(FALL, {"h": "45", "u": "30"})  # taken to fall for 1.5 s
    field, values = Field(), {name: q.number for name, q in solution.parameters.items()}
    (own,) = (each for each in find_candidates(FALL, FALL.asks) if each.own)
    way = choose_way(own, FALL, values, field)
    exact = work_out(FALL, FALL.asks, way, solution.motion.plan, field)
    assert [str(exact[name]) for name in ("x", "v_y")] == ["4500", "15"]
    draws = {"g": ["10", "10"], "h": ["20", "45"], "u": ["20", "30"]}
    many = find_known_mistakes(FALL, FALL.asks, draws, solution.motion.plan)
    assert many["x"]["no-root"].tolist() == pytest.approx([2000, 4500])
    assert many["v_y"]["no-root"].tolist() == pytest.approx([10, 15])
