"""What doubles refuse is refused by the exact solution too, and for the same reason."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from fractions import Fraction

import pytest

from kinegrade.draws.draw_filter import DrawFilter
from kinegrade.draws.examining import Refused, require_room, solve_sensible
from kinegrade.draws.screening import screen
from kinegrade.numbers.tolerance import Tolerance
from kinegrade.problem.template.library.library import load_template
from kinegrade.students.separation import collect_columns
from tests.problem.draws import draw_filter

DRAWS = 60
NARROW = Tolerance(Fraction(1, 1000))
CASES = (  # whether tolerances may be widened; where not, more is refused
    ("rod-sliding-on-driven-wheel", True),
    ("pole-four-bar-coupler", True),
    ("crank-slider-in-floating-link", False),
    ("rod-ground-and-incline", False),
)


def exactly(question: DrawFilter, place: int, bounds: dict[str, float]) -> str:
    """What the exact solution says of a combination, mistakes aside."""
    values = question.deck.combination(place)
    try:
        solution = solve_sensible(question.template, values, question.asks, None)
        require_room(solution, question.accuracy, bounds)
    except Refused as refusal:
        return str(refusal)
    return "fit"


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
        bounds = {ask: float(row[place]) for ask, row in seen.bounds.items()}
        if refusal is not None and refusal.reason != "mistake":
            found[refusal.reason] += 1
            assert exactly(question, place, bounds) == str(refusal)
    assert found
