"""What doubles refuse is refused by the exact solution too, and for the same reason."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction
from typing import get_args

import pytest

from kinegrade.draws.draw_filter import DrawFilter
from kinegrade.draws.examining import Refused, require_room, solve_sensible
from kinegrade.draws.screening import screen
from kinegrade.numbers.tolerance import Tolerance
from kinegrade.problem.holding import condition_holds
from kinegrade.problem.template.library.library import load_template
from kinegrade.problem.template.template import Relation
from kinegrade.students.comparison import collect_columns
from kinegrade.students.rounding.rounding import Rounding, take_one
from tests.problem.crank import crank
from tests.problem.draws import draw_filter

DRAWS = 60
NARROW = Tolerance(Fraction(1, 1000))
CASES = (  # whether tolerances may be widened; where not, more is refused
    ("bent-rod-two-sleeves", True),
    ("pole-four-bar-coupler", True),
    ("crank-slider-in-floating-link", False),
    ("rod-ground-and-incline", False),
)


def exactly(question: DrawFilter, place: int, roundings: Mapping[str, Rounding[float]]) -> str:
    """What the exact solution says of a combination, mistakes aside."""
    values = question.deck.combination(place)
    try:
        solution = solve_sensible(question.template, values, question.asks, None)
        require_room(solution, question.accuracy, roundings)
    except Refused as refusal:
        return str(refusal)
    return "fit"


@pytest.mark.parametrize("mark", [*get_args(Relation), ">", ">="])
def test_no_relation_is_refused_where_it_holds(mark: str) -> None:
    """`u != v` was refused wherever u was greater than v, in silence."""
    template = crank(("omega < 10000000", f"h {mark} r/4"), ("draw = [1, 2]", "draw = [1, 2, 3]"))
    question = draw_filter(template)
    separation = question.separation
    assert separation is not None
    draws = [question.deck.combination(place) for place in range(question.deck.size)]
    unmet = separation.compare(collect_columns(draws)).unmet
    [condition] = template.scheme.conditions
    held = [condition_holds(template, condition, values) for values in draws]
    refused = [place >= 0 for place in unmet]
    assert True in held
    assert False in held
    assert [
        (each, wrongly) for each, wrongly in zip(held, refused, strict=True) if each and wrongly
    ] == []


@pytest.mark.parametrize(("name", "honest"), CASES)
def test_nothing_fit_is_refused_and_much_is(name: str, honest: bool) -> None:
    template = load_template(name)
    plain = draw_filter(template, tolerances=dict.fromkeys(template.asked(), NARROW))
    question = replace(plain, honest=frozenset(template.asked() if honest else ()))
    separation = question.separation
    assert separation is not None
    seen = separation.compare(collect_columns(question.deck.first(DRAWS)))
    found: Counter[str] = Counter()
    for place, refusal in enumerate(screen(separation, question.accuracy, seen)):
        roundings = take_one(seen.roundings, place)
        if refusal is not None and refusal.reason != "mistake":
            found[refusal.reason] += 1
            assert exactly(question, place, roundings) == str(refusal)
    assert found
