"""Which of several ways to draw a mark covers least."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from heapq import heapify, heappop, heappush
from itertools import chain, islice, repeat, takewhile
from math import inf
from typing import TypeVar

from kinegrade.figure.placing.mark import Mark
from kinegrade.figure.placing.obstacles import Obstacles
from kinegrade.figure.placing.place import Wish, measure_crowding

Way = TypeVar("Way", bound=Mark)
# Alternatives of a mark that are judged together: usually one of the first is accepted
_BATCHES = (4, 12, 36)


def keep_demerit(mark: Mark) -> Mark:
    """The mark, whose demerit is known already."""
    return mark


def choose_least_covering(
    alternatives: Sequence[Way],
    obstacles: Obstacles,
    rate: Callable[[Way], Mark] = keep_demerit,
    *,
    own: bool,
) -> tuple[Mark, Wish, float]:
    """The cheapest alternative, its wish and its cost: what its line covers, what its label
    covers, its `own` line as well, and its demerit; among equals the preferred one. What `rate`
    makes of an alternative has no smaller demerit.

    Alternatives are judged in order of preference, several at once, and coverage is computed only
    while it can still decide: first of the line, then of the label.
    """
    ranked = _rank(alternatives, rate)
    best, least = list[tuple[Mark, Wish]](), inf
    for size in chain(_BATCHES, repeat(_BATCHES[-1])):
        marks = _take_better(ranked, size, least)
        if not marks:
            break
        waiting = [(round(mark.demerit, 6), number, False) for number, mark in enumerate(marks)]
        while waiting and waiting[0][0] < least:
            cost, number, crossed = heappop(waiting)
            mark = marks[number]
            if not crossed:
                covered = obstacles.along(mark.path(), mark.shared, least - mark.demerit)
                heappush(waiting, (round(covered + mark.demerit, 6), number, True))
                continue
            wish = mark.wish()
            under = obstacles.with_drawn(mark.primitives()) if own else obstacles
            total = round(cost + measure_crowding(wish, under, least - cost), 6)
            if total < least:
                best, least = [(mark, wish)], total
    return *best[0], least


def _rank(alternatives: Sequence[Way], rate: Callable[[Way], Mark]) -> Iterator[tuple[float, Mark]]:
    """All of them with their demerits, the preferred ones first; each is rated when no other one
    can come before it.
    """
    unrated = [(round(way.demerit, 6), number) for number, way in enumerate(alternatives)]
    heapify(unrated)
    rated: list[tuple[float, int, Mark]] = []
    while unrated or rated:
        if unrated and (not rated or unrated[0] < rated[0][:2]):
            _, number = heappop(unrated)
            mark = rate(alternatives[number])
            heappush(rated, (round(mark.demerit, 6), number, mark))
        else:
            demerit, _, mark = heappop(rated)
            yield demerit, mark


def _take_better(ranked: Iterator[tuple[float, Mark]], size: int, least: float) -> list[Mark]:
    """The next of them, so many at most, as long as their demerits are below the least cost."""
    return [mark for _, mark in takewhile(lambda each: each[0] < least, islice(ranked, size))]
