"""Honest work for many instances at once: never right where an instance alone is not, and mostly
found right.
"""

from __future__ import annotations

import re

import pytest

from kinegrade.draws.deck import make_deck
from kinegrade.draws.examining import Refused, examine, examine_together, solve_sensible
from kinegrade.numbers.tolerance import Tolerance
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.library.library import load_template
from kinegrade.problem.template.template import Template
from kinegrade.students.rounding.honest_rounding import find_stray
from kinegrade.students.rounding.honest_rounding_arrays import surely_honest
from tests.problem.crank import crank

NAMES = (
    "slider-crank",
    "flat-faced-follower-curvature-radius",
    "bar-through-swivelling-sleeve",
    "pin-in-two-rings",
    "four-bar-parallel-coupler",
    "rolling-wheel-rim-points",
    "slider-driven-gear-on-rack",
)


def solutions(template: Template, count: int) -> list[Solution]:
    found: list[Solution] = []
    for values in make_deck(template, "spring", "q1").first(count):
        try:
            found.append(
                solve_sensible(
                    template,
                    values,
                    template.asked(),
                    found[0].motion.plan if found else None,
                )
            )
        except Refused:
            continue
    return found


@pytest.mark.parametrize("name", NAMES)
def test_whoever_is_surely_right_together_is_right_alone(name: str) -> None:
    found = solutions(load_template(name), 60)
    sure = surely_honest(found, {})
    right = [find_stray(solution, {}) is None for solution in found]
    assert not [number for number, flag in enumerate(sure) if flag and not right[number]]
    assert sum(sure) >= sum(right) / 3


def test_it_does_not_matter_who_is_looked_at_together() -> None:
    found = solutions(load_template("bar-through-swivelling-sleeve"), 40)
    sure = surely_honest(found, {})
    apart = [*surely_honest(found[:7], {}), *surely_honest(found[7:], {})]
    assert sure == apart


def test_so_few_are_left_to_be_worked_out_alone() -> None:
    assert surely_honest([], {}) == []
    few = solutions(load_template("slider-crank"), 3)
    assert surely_honest(few, {}) == [False] * len(few)


def test_an_instance_that_cannot_be_found_spoils_nobody_else() -> None:
    template = crank(('draw = [0, "1/2", 3]', 'draw = ["1/2", "1.006"]'))
    values = [{"r": "2", "h": "1/2", "omega": str(number)} for number in range(2, 8)]
    # Put down at y = 1.01: the crank does not reach it
    values.insert(2, {"r": "1.0065", "h": "1.006", "omega": "2"})
    found = [solve_sensible(template, given, template.asks, None) for given in values]
    sure = surely_honest(found, {})
    assert not sure[2]
    assert sum(sure) >= 5


def test_examined_together_is_examined_alone() -> None:
    template = load_template("slotted-bar-between-two-rods")
    tolerances = dict[str, Tolerance]()
    draws = make_deck(template, "spring", "q1").first(40)
    together = examine_together(template, draws, template.asked(), None, tolerances)
    assert {type(one) for one in together} == {Solution, Refused}
    for values, one in zip(draws, together, strict=True):
        if isinstance(one, Solution):
            assert one.parameters == examine(template, values, template.asked()).parameters
        else:
            with pytest.raises(Refused, match=f"^{re.escape(str(one))}$") as caught:
                examine(template, values, template.asked())
            assert (caught.value.reason, caught.value.ask) == (one.reason, one.ask)
