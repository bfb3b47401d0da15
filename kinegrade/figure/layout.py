"""A figure in the making: what is drawn and written so far, and how one thing more finds its place."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import chain, repeat

import numpy as np

from kinegrade.figure.mark import Mark
from kinegrade.figure.obstacles import Obstacles
from kinegrade.figure.place import Wish, crowding, label
from kinegrade.figure.scene import Label, Primitive

BATCHES = (4, 12, 36)  # how many alternatives of a mark are judged together: mostly one of the first will do


@dataclass(frozen=True)
class Layout:
    """Lines, labels, and both as obstacles; every step gives a new one."""

    lines: tuple[Primitive, ...]
    labels: tuple[Label, ...]
    obstacles: Obstacles

    @staticmethod
    def of(primitives: Iterable[Primitive]) -> Layout:
        """The start: a mechanism without marks and labels."""
        lines = tuple(primitives)
        return Layout(lines, (), Obstacles(lines))

    @property
    def primitives(self) -> tuple[Primitive, ...]:
        """Everything, labels on top."""
        return (*self.lines, *self.labels)

    def drawn(self, primitives: Sequence[Primitive]) -> Layout:
        """With more lines."""
        return replace(
            self, lines=(*self.lines, *primitives), obstacles=self.obstacles.with_drawn(primitives)
        )

    def written(self, wishes: Iterable[Wish]) -> Layout:
        """With a label for each wish, in order."""
        layout = self
        for wish in wishes:
            layout = layout._labelled(label(wish, layout.obstacles))
        return layout

    def marked(self, alternatives: Sequence[Mark], sparing: Sequence[Primitive] = ()) -> Layout:
        """With the alternative that covers least, and its label; what is still to come may be spared."""
        crowded = self.obstacles.with_drawn(sparing) if sparing else self.obstacles
        mark = least_covering(alternatives, crowded)
        layout = self.drawn(mark.primitives())
        crowded = layout.obstacles.with_drawn(sparing) if sparing else layout.obstacles
        return layout._labelled(label(mark.wish(), crowded))

    def _labelled(self, placed: Label) -> Layout:
        return replace(
            self, labels=(*self.labels, placed), obstacles=self.obstacles.with_drawn((placed,))
        )


def _batches(ranked: Sequence[Mark]) -> Iterator[Sequence[Mark]]:
    """All of them in order, a few first and then more at a time."""
    first = 0
    for size in chain(BATCHES, repeat(BATCHES[-1])):
        if first >= len(ranked):
            return
        yield ranked[first : first + size]
        first += size


def least_covering(alternatives: Sequence[Mark], obstacles: Obstacles) -> Mark:
    """The cheapest by what its line covers, what its label covers, and its demerit; the nicest of equals.

    Alternatives are judged the nicest first, a few at once, and only while they can still decide.
    """
    ranked = sorted(alternatives, key=lambda mark: round(mark.demerit, 6))
    best, least = ranked[0], np.inf
    for marks in _batches(ranked):
        if marks[0].demerit >= least:
            break
        crossed = obstacles.along([mark.path() for mark in marks], marks[0].shared).tolist()
        costs = [round(cost + mark.demerit, 6) for mark, cost in zip(marks, crossed, strict=True)]
        for cost, mark in sorted(zip(costs, marks, strict=True), key=lambda costed: costed[0]):
            if cost >= least:
                break
            total = round(cost + crowding(mark.wish(), obstacles), 6)
            best, least = (mark, total) if total < least else (best, least)
    return best
