"""Which of several ways to draw a mark covers least."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from heapq import heappop, heappush
from itertools import chain, repeat
from math import inf

from kinegrade.figure.placing.mark import Mark
from kinegrade.figure.placing.obstacles import Obstacles
from kinegrade.figure.placing.place import Wish, measure_crowding

# Alternatives of a mark that are judged together: usually one of the first is accepted
_BATCHES = (4, 12, 36)


def _batch(ranked: Sequence[Mark]) -> Iterator[Sequence[Mark]]:
    """All of them in order, a few first and then more at a time."""
    first = 0
    for size in chain(_BATCHES, repeat(_BATCHES[-1])):
        if first >= len(ranked):
            return
        yield ranked[first : first + size]
        first += size


def choose_least_covering(
    alternatives: Sequence[Mark], obstacles: Obstacles, *, own: bool
) -> tuple[Mark, Wish, float]:
    """The cheapest alternative, its wish and its cost: what its line covers, what its label
    covers, its `own` line as well, and its demerit; among equals the preferred one.

    Alternatives are judged in order of preference, several at once, and coverage is computed only
    while it can still decide: first of the line, then of the label.
    """
    ranked = sorted(alternatives, key=lambda mark: round(mark.demerit, 6))
    best, least = (ranked[0], ranked[0].wish()), inf
    for marks in _batch(ranked):
        if marks[0].demerit >= least:
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
            total = round(cost + measure_crowding(wish, under), 6)
            if total < least:
                best, least = (mark, wish), total
    return *best, least
