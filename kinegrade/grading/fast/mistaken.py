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

from kinegrade.exam.folder.columns.gathering import LedTo
from kinegrade.grading.fast.bounds import Flags, Numbers, Places, Rules
from kinegrade.grading.fast.comparison import compare
from kinegrade.grading.judging.decision import rank_mistake

_TOO_NEAR = 1e-9  # relative: of two mistakes this near to each other, either may be the nearer one
_PLACE = itemgetter(0)


class Way(NamedTuple):
    """A mistake that may lead to the answer at a place, and its distance from the answer; `number`
    is its own among all ways.
    """

    number: int
    name: str
    certain: bool
    difference: float
    value: float


@dataclass(frozen=True, slots=True)
class Mistakes:
    """What mistakes lead to, and the place of the answer that each is held against."""

    led_to: LedTo
    places: Places

    @classmethod
    def of(cls, places: Places, led_to: LedTo) -> Mistakes:
        """The mistakes at each of these places."""
        return cls(led_to, np.repeat(places, led_to.counts))

    def leading(self, answers: Numbers, rules: Rules, decimals: Flags) -> Leading:
        """The ways that may lead to the answers; `answers`, `rules` and which answers are
        `decimals` of few digits are those of all places.
        """
        values = self.led_to.values
        agreeing = rules.may_agree(answers, self.places, values)
        near = np.flatnonzero(agreeing)
        places = self.places[near]

        def are_decimals(ways: Places) -> Flags:
            return decimals[places[ways]] & self.led_to.as_written

        led = compare(answers[places], values[near], rules.at(places), are_decimals)
        likely = np.flatnonzero(led.right | ~led.decided)
        return Leading(
            places[likely],
            self.led_to.names[near[likely]].astype(np.intp),
            self.led_to.known,
            led.certain[likely],
            led.stated[:, likely],
            led.bounds.to_figures[likely],
        )


@dataclass(frozen=True, slots=True)
class Leading:
    """The ways that may lead to answers, in the order of their places, as columns; `names` are
    numbers of those that are `known`, `stated` and `to_figures` what their reasons say.
    """

    places: Places
    names: Places
    known: Sequence[str]
    certain: Flags
    stated: Numbers
    to_figures: Flags

    def group_others(self) -> Iterator[tuple[int, list[Way]]]:
        """The other answers, each with its ways."""
        others = np.flatnonzero(~self.single)
        values, differences = self.stated[:2, others].tolist()
        names = map(self.known.__getitem__, self.names[others].tolist())
        certain = self.certain[others].tolist()
        ways = map(Way, others.tolist(), names, certain, differences, values)
        placed = zip(self.places[others].tolist(), ways, strict=True)
        for place, group in groupby(placed, _PLACE):
            yield place, [way for _, way in group]

    @property
    def single(self) -> Flags:
        """Which ways are certain, and lead to an answer to which no other does: most."""
        changes = np.ones(len(self.places) + 1, dtype=np.bool_)
        changes[1:-1] = self.places[1:] != self.places[:-1]
        found: Flags = changes[:-1] & changes[1:] & self.certain
        return found


def find_best(ways: Sequence[Way], shares: Mapping[str, Fraction]) -> Way | None:
    """The first by rank of the mistakes that lead to an answer; None where double precision cannot
    decide.
    """
    if not all(way.certain for way in ways):
        return None
    best = min(ways, key=lambda way: rank_mistake(way.name, way.difference, shares))
    for way in ways:
        near = abs(way.difference - best.difference) < _TOO_NEAR * abs(best.value)
        if near and way.value != best.value:
            return None
    return best
