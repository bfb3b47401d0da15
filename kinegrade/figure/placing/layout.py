"""A figure in progress: everything drawn and written so far, and how the next item finds its
place.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

import numpy as np
from msgspec import Struct
from msgspec.structs import replace

from kinegrade.figure.placing.aligned import list_thin_lines
from kinegrade.figure.placing.alternatives import Way, choose_least_covering, keep_demerit
from kinegrade.figure.placing.beside import adjoins, keep_from_labels, makes_word
from kinegrade.figure.placing.letters import (
    is_astray,
    is_misread,
    keep_off_lines,
    place_letter,
    trace_wished_leader,
)
from kinegrade.figure.placing.mark import Mark
from kinegrade.figure.placing.obstacles import COST_FIRM, COST_LABEL, Obstacles, Segment
from kinegrade.figure.placing.place import (
    Placed,
    Wish,
    is_covered,
    place_label,
)
from kinegrade.figure.plane import length, unit
from kinegrade.figure.scene import THIN, Label, Primitive, Strokes

_CHEAP = 8.0  # cost of a mark up to which no further alternatives are made
_LITTLE = 6.0  # cost by which a mark may be worse so that its label has a good place
# Costs from which on a leader would cross too much to be of use: of a short one, and of one so many
# millimetres long across teeth and two outlines at most, without which nobody would find its point
_HARD, _HARDER, _LONG = 20.0, 60.0, 3.0
_MISLEADING = 20.0  # demerit of a letter behind a wall that no leader joins to its point


def no_others(_: float) -> Iterable[Mark]:
    """No further alternatives of a mark."""
    return ()


class Layout(Struct, frozen=True):
    """Lines, labels, and both as obstacles; each step gives a new layout.

    `marks` are those chosen so far, with what each costs in `costs`; `crowded` are the symbols
    that found no good place, `astray` those that stand off from their points behind a wall;
    `strain` is set by who places marks: what too dear ones cost, and arrows off the bars that they
    should be tied to; so is `claimed`: the symbols of
    lengths that are nearer to something else than to their own lines.
    """

    lines: tuple[Primitive, ...]
    labels: tuple[Label, ...]
    obstacles: Obstacles
    crowded: tuple[str, ...] = ()
    marks: tuple[Mark, ...] = ()
    costs: tuple[float, ...] = ()
    strain: float = 0.0
    astray: tuple[str, ...] = ()
    claimed: tuple[str, ...] = ()

    @staticmethod
    def of(primitives: Iterable[Primitive]) -> Layout:
        """The start: a mechanism without marks and labels."""
        lines = tuple(primitives)
        return Layout(lines, (), Obstacles.of(lines))

    @property
    def primitives(self) -> tuple[Primitive, ...]:
        """Everything, labels on top."""
        return (*self.lines, *self.labels)

    def drawn(self, primitives: Sequence[Primitive]) -> Layout:
        """The layout with more lines."""
        obstacles = self.obstacles.with_drawn(primitives)
        return replace(self, lines=(*self.lines, *primitives), obstacles=obstacles)

    def written(self, wishes: Iterable[Wish]) -> Layout:
        """The layout with a label for each wish, in order, and a leader where one is needed."""
        layout = self
        for wish in wishes:
            placed = layout._keep_off_lines(wish, place_letter(wish, layout.obstacles))
            leader = trace_wished_leader(wish, placed.label)
            close = leader and adjoins(placed.label, layout.labels)
            if close or makes_word(placed.label, layout.labels):
                placed = layout._keep_apart(wish, placed, layout.obstacles)
            if layout._misleads(wish, placed.label):
                placed = layout._lead_in(wish, placed)
            leader = trace_wished_leader(wish, placed.label)
            useful = leader is not None and layout._is_useful(leader, wish.amid)
            layout = layout._labelled(placed)
            if leader and useful:
                layout = layout.drawn((Strokes((leader,), THIN),))
            elif is_astray(placed.label, wish):
                layout = replace(layout, astray=(*layout.astray, wish.symbol))
        return layout

    def _misleads(self, wish: Wish, label: Label) -> bool:
        """Whether a letter stands off from its point behind a wall, without a leader of use."""
        if not is_astray(label, wish):
            return False
        leader = trace_wished_leader(wish, label)
        return leader is None or not self._is_useful(leader, wish.amid)

    def _lead_in(self, wish: Wish, placed: Placed) -> Placed:
        """The letter where it was placed, or where it has a leader of use or no wall before it, if
        there is such a place without a fault.
        """
        labels = [wish.label_at(spot) for spot in range(len(wish.spots))]
        worse = _MISLEADING * np.array([self._misleads(wish, label) for label in labels])
        joined = wish.worse_by(worse)
        led = place_label(joined, self.obstacles)
        return placed if led.faulty else self._keep_off_lines(joined, led)

    def _keep_off_lines(self, wish: Wish, placed: Placed) -> Placed:
        """The letter where it was placed, or where its leader is not misread, if there is such a
        place without a fault.
        """
        leader = trace_wished_leader(wish, placed.label)
        if leader is None:
            return placed
        lines, rings = list_thin_lines(self.lines), self.obstacles.rings
        if not is_misread(leader, lines, rings):
            return placed
        off = place_label(keep_off_lines(wish, lines, rings), self.obstacles)
        return placed if off.faulty else off

    def _keep_apart(self, wish: Wish, placed: Placed, crowded: Obstacles) -> Placed:
        """The label where it was placed, or where it does not stand in one row with another one
        or close to it, if there is such a place without a fault.
        """
        beside = adjoins(placed.label, self.labels) or makes_word(placed.label, self.labels)
        if placed.faulty or not beside:
            return placed
        apart = place_label(keep_from_labels(wish, self.labels), crowded)
        return placed if apart.faulty else apart

    def _is_useful(self, leader: Segment, amid: float) -> bool:
        """Whether a leader does not cross too much before it is so many millimetres from its
        end.
        """
        start, end = leader
        size = length(end - start)
        if size <= amid:
            return True
        before = ((start, end - unit(end - start) * amid),)
        crossed = self.obstacles.along(before, shared=True)
        if crossed < _HARD or crossed >= _HARDER or size <= _LONG:
            return crossed < _HARD
        return self.obstacles.outlines().along(before, shared=True) <= 2 * COST_FIRM

    def marked(
        self,
        alternatives: Sequence[Mark],
        sparing: Sequence[Primitive] = (),
        find_cheaper: Callable[[float], Iterable[Mark]] = no_others,
    ) -> Layout:
        """The layout with the alternative that covers least, and its label; areas reserved for
        later items may be kept clear. Only where the best is not cheap, `find_cheaper` gives
        further ones with a demerit below its cost; only where it leaves no good place for its
        own label, one that is little worse is taken.
        """
        found = self._marked_best(alternatives, sparing, find_cheaper)
        if len(found.crowded) == len(self.crowded) or len(alternatives) < 2:
            return found
        others = [mark for mark in alternatives if mark is not found.marks[-1]]
        second = self._marked_best(others, sparing, find_cheaper)
        near = second.costs[-1] < found.costs[-1] + _LITTLE
        return second if near and len(second.crowded) < len(found.crowded) else found

    def _marked_best(
        self,
        alternatives: Sequence[Mark],
        sparing: Sequence[Primitive],
        find_cheaper: Callable[[float], Iterable[Mark]],
    ) -> Layout:
        """The layout with the alternative that covers least, and its label: only where that is
        crowded, the labels are judged by the lines of their own marks as well, and further ones
        are taken that cross little.
        """
        layout, wish = self.chosen(alternatives, sparing)
        cost = layout.costs[-1]
        further = tuple(find_cheaper(cost)) if cost > _CHEAP else ()
        if further:
            layout, wish = self.chosen([layout.marks[-1], *further], sparing)
        usual = layout.captioned(wish, sparing)
        if usual.crowded == self.crowded:
            return usual
        ways = [*alternatives, *further]
        layout, wish = self.chosen(ways, sparing, beside_own_lines=True)
        if not further and layout.costs[-1] > _CHEAP:
            ways = [layout.marks[-1], *find_cheaper(layout.costs[-1])]
            led, symbol = self.chosen(ways, sparing, beside_own_lines=True)
            layout, wish = (led, symbol) if led.costs[-1] < _HARD else (layout, wish)
        other = layout.captioned(wish, sparing)
        return other if other.crowded == self.crowded else usual

    def chosen(
        self,
        alternatives: Sequence[Way],
        sparing: Sequence[Primitive] = (),
        rate: Callable[[Way], Mark] = keep_demerit,
        *,
        beside_own_lines: bool = False,
    ) -> tuple[Layout, Wish]:
        """The layout with the alternative that covers least, and the wish of its label, which is
        still to be written. What `rate` makes of an alternative has no smaller demerit.
        """
        crowded = self.obstacles.with_drawn(sparing) if sparing else self.obstacles
        mark, wish, cost = choose_least_covering(alternatives, crowded, rate, own=beside_own_lines)
        struck = cost >= COST_LABEL and self._strikes_label(mark)
        layout = replace(
            self.drawn(mark.primitives()),
            marks=(*self.marks, mark),
            costs=(*self.costs, cost),
        )
        return (layout.complaining(wish.symbol) if struck else layout), wish

    def captioned(self, wish: Wish, sparing: Sequence[Primitive] = ()) -> Layout:
        """The layout with the label of a mark, which has a fault only where something is under
        it, or where it is lost.
        """
        crowded = self.obstacles.with_drawn(sparing) if sparing else self.obstacles
        placed = self._keep_apart(wish, place_label(wish, crowded), crowded)
        faulty = placed.faulty and (placed.lost or is_covered(placed.label, self.obstacles))
        return self._labelled(replace(placed, faulty=faulty))

    def _strikes_label(self, mark: Mark) -> bool:
        """Whether a mark is drawn through a letter, with its path or with what is rated in its
        demerit alone, as the beginnings of extension lines are.
        """
        on_path = self.obstacles.along(mark.path(), mark.shared)
        return max(mark.demerit, on_path) >= COST_LABEL

    def _labelled(self, placed: Placed) -> Layout:
        label = placed.label
        obstacles = self.obstacles.with_drawn((label,))
        layout = replace(self, labels=(*self.labels, label), obstacles=obstacles)
        return layout.complaining(label.symbol) if placed.faulty else layout

    def complaining(self, symbol: str) -> Layout:
        """The layout with one more symbol that found no good place."""
        return replace(self, crowded=tuple(dict.fromkeys((*self.crowded, symbol))))
