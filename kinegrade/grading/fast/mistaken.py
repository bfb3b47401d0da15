"""The fast twin of `judging.decision.find_mistaken`: the mistakes that lead to thousands of wrong
answers at once, in double precision.

`block_judge` uses it; where several mistakes lead to an answer and double precision cannot rank
them, `decide` does.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import groupby
from operator import itemgetter
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kinegrade.exam.folder.columns.gathering import LedTo
from kinegrade.grading.fast.bounds import Numbers, Places, Rules
from kinegrade.grading.fast.comparison import compare
from kinegrade.grading.fast.reasons import read_comparisons
from kinegrade.grading.judging.decision import rank_mistake
from kinegrade.language import Language

_TOO_NEAR = 1e-9  # relative: of two mistakes this near to each other, either may be the nearer one
_PLACE = itemgetter(0)


class Way(NamedTuple):
    """A mistake that may lead to the answer at a place: its distance from the answer, also in
    words.
    """

    place: int
    name: str
    certain: bool
    difference: float
    value: float
    comparison: str


@dataclass(frozen=True, slots=True)
class Mistakes:
    """What mistakes lead to: their names, the places of the answers, and the wrong values."""

    names: NDArray[np.object_]
    places: Places
    values: Numbers

    @classmethod
    def of(cls, places: Places, led_to: LedTo) -> Mistakes:
        """The mistakes at each of these places."""
        return cls(led_to.names, np.repeat(places, led_to.counts), led_to.values)

    def leading(
        self, answers: Numbers, rules: Rules, language: Language
    ) -> Iterator[tuple[int, list[Way]]]:
        """The ways that may lead to the answers, in the order of the places; `answers` and `rules`
        are those of all places.
        """
        agreeing = rules.at(self.places).may_agree(answers[self.places], self.values)
        near = np.flatnonzero(agreeing)
        places = self.places[near]
        led = compare(answers[places], self.values[near], rules.at(places))
        likely = np.flatnonzero(led.right | ~led.decided)
        ways = map(
            Way,
            places[likely].tolist(),
            self.names[near[likely]].tolist(),
            led.certain[likely].tolist(),
            led.difference[likely].tolist(),
            led.centres[likely].tolist(),
            led.reasons(likely, read_comparisons(language)),
        )
        for place, group in groupby(ways, _PLACE):
            yield place, list(group)


def find_best(ways: Sequence[Way], shares: Mapping[str, Fraction]) -> Way | None:
    """The first by rank of the mistakes that lead to an answer; None where double precision cannot
    decide.
    """
    if not all(way.certain for way in ways):
        return None
    if len(ways) == 1:  # as most answers have
        return ways[0]
    best = min(ways, key=lambda way: rank_mistake(way.name, way.difference, shares))
    for way in ways:
        near = abs(way.difference - best.difference) < _TOO_NEAR * abs(best.value)
        if near and way.value != best.value:
            return None
    return best
