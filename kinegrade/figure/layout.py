"""A figure in the making: what is drawn and written so far, and how one thing more finds its place."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from kinegrade.figure.mark import Mark
from kinegrade.figure.obstacles import Obstacles
from kinegrade.figure.place import Wish, crowding, label
from kinegrade.figure.scene import Label, Primitive

AT_ONCE = 6  # alternatives of a mark judged together


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

    def marked(self, alternatives: Sequence[Mark], sparing: Sequence[Label] = ()) -> Layout:
        """With the alternative that covers least, and its label; labels still to come may be spared."""
        crowded = self.obstacles.with_drawn(sparing)
        mark = least_covering(alternatives, crowded)
        lines = mark.primitives()
        return self.drawn(lines)._labelled(label(mark.wish(), crowded.with_drawn(lines)))

    def _labelled(self, placed: Label) -> Layout:
        return replace(
            self, labels=(*self.labels, placed), obstacles=self.obstacles.with_drawn((placed,))
        )


def least_covering(alternatives: Sequence[Mark], obstacles: Obstacles) -> Mark:
    """The cheapest by what its line covers, what its label covers, and its demerit; the nicest of equals.

    Alternatives are judged the nicest first, a few at once, and only while they can still decide.
    """
    ranked = sorted(alternatives, key=lambda mark: round(mark.demerit, 6))
    best, least = ranked[0], np.inf
    for first in range(0, len(ranked), AT_ONCE):
        marks = ranked[first : first + AT_ONCE]
        if marks[0].demerit >= least:
            break
        crossed = obstacles.along([mark.path() for mark in marks], marks[0].shared)
        for mark, cost in zip(marks, crossed.tolist(), strict=True):
            if cost + mark.demerit < least:
                total = round(cost + mark.demerit + crowding(mark.wish(), obstacles), 6)
                best, least = (mark, total) if total < least else (best, least)
    return best
