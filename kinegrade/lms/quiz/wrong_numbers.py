"""What wrong numbers show: the known mistakes that lead to them, all of them where several lead to
one number.

A system that takes the first answer that fits would name only one mistake where two lead to nearly
the same number. So every set of mistakes that lead to some number together is listed here with the
interval that they share.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise

from kinegrade.exam.quiz.document import QuizAsk, QuizMistake
from kinegrade.lms.quiz.intervals import RightInterval, turn


@dataclass(frozen=True)
class WrongNumbers:
    """Mistakes that lead to the same numbers, and those numbers: one interval, or one for each turn
    of an angle.
    """

    mistakes: tuple[QuizMistake, ...]
    intervals: tuple[RightInterval, ...]

    @property
    def credit(self) -> Fraction:
        """The best share of the points that one of the mistakes earns."""
        return max(mistake.credit for mistake in self.mistakes)


@dataclass(frozen=True)
class _Lead:
    """One interval that a mistake leads to; `mistake` is its index among the ask's."""

    mistake: int
    interval: RightInterval

    def holds(self, number: Fraction) -> bool:
        return self.interval.low <= number <= self.interval.high


def find_wrong_numbers(ask: QuizAsk) -> tuple[WrongNumbers, ...]:
    """The sets of mistakes that some number shows; the first set whose intervals contain a number
    names all the mistakes that lead to it.

    What two sets have in common belongs to a larger one, and larger ones come first.
    """
    found: dict[tuple[int, ...], list[RightInterval]] = {}
    for cluster in _find_clusters(_find_leads(ask)):
        for together in _find_sets(cluster):
            mistakes = tuple(sorted({lead.mistake for lead in together}))
            found.setdefault(mistakes, []).append(_intersect(together))
    largest_first = sorted(found.items(), key=lambda entry: -len(entry[0]))
    return tuple(
        WrongNumbers(tuple(ask.mistakes[place] for place in places), tuple(intervals))
        for places, intervals in largest_first
    )


def _find_leads(ask: QuizAsk) -> list[_Lead]:
    """All intervals that mistakes lead to, by their lower ends."""
    leads = [
        _Lead(place, interval)
        for place, mistake in enumerate(ask.mistakes)
        for interval in turn(RightInterval(mistake.value, *mistake.interval), ask.period)
    ]
    return sorted(leads, key=lambda lead: lead.interval.low)


def _find_clusters(leads: Sequence[_Lead]) -> Iterator[list[_Lead]]:
    """Groups that overlap, directly or through others; usually each interval is alone."""
    cluster: list[_Lead] = []
    for lead in leads:
        if cluster and lead.interval.low > max(each.interval.high for each in cluster):
            yield cluster
            cluster = []
        cluster.append(lead)
    if cluster:
        yield cluster


def _find_sets(cluster: Sequence[_Lead]) -> list[tuple[_Lead, ...]]:
    """Every set of leads that contain some number together: an end of an interval, or a number
    between two ends.
    """
    if len(cluster) == 1:
        return [tuple(cluster)]
    ends = sorted({end for lead in cluster for end in (lead.interval.low, lead.interval.high)})
    between = [(end + following) / 2 for end, following in pairwise(ends)]
    places = (
        tuple(place for place, lead in enumerate(cluster) if lead.holds(number))
        for number in (*ends, *between)
    )
    return [tuple(cluster[place] for place in each) for each in dict.fromkeys(places)]


def _intersect(together: Sequence[_Lead]) -> RightInterval:
    """The interval that all of them share."""
    if len(together) == 1:
        return together[0].interval
    low = max(lead.interval.low for lead in together)
    high = min(lead.interval.high for lead in together)
    return RightInterval((low + high) / 2, low, high)
