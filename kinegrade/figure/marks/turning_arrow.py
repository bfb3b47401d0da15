"""A rotation as one curved arrow, and how well it is told from what else there is at its pivot."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from math import pi

from kinegrade.figure.placing.mark import chords
from kinegrade.figure.placing.obstacles import Segment
from kinegrade.figure.placing.place import Wish, list_spots_along_arc
from kinegrade.figure.plane import shorter_way
from kinegrade.figure.scene import Bow, Primitive
from kinegrade.figure.symbols import HEADS, draw_curved_arrow
from kinegrade.problem.template.hints import Turning

_COARSE = 0.7  # radians of an arrow that count as straight when its way is looked at
# Millimetres between an arrow and the arc of an angle within it, and the demerit of less
_APART, _MERGED = 3.0, 4.0
# Millimetres between two arrows at one pivot along their arcs, and the demerit of each that lacks;
# half as much where their radii differ by so many millimetres, else they cannot be told apart
_BETWEEN, _FOLLOWING, _NESTED, _COVERED = 6.0, 0.6, 2.5, 100.0
_FOREIGN = 4.5  # millimetres between an arrow and the rim of another body, 1 demerit for each less


@dataclass(frozen=True)
class TurningArrow:
    """A curved arrow along an arc."""

    bow: Bow
    hint: Turning
    demerit: float
    shared: bool = False

    def path(self) -> tuple[Segment, ...]:
        """The arc, in few pieces: there are many arrows to choose from."""
        return chords(self.bow, _COARSE)

    def wish(self) -> Wish:
        """Along the arc."""
        return list_spots_along_arc(self.hint.symbol, self.bow)

    def primitives(self) -> tuple[Primitive, ...]:
        """The arc and its arrowhead."""
        return draw_curved_arrow(self.bow, HEADS[self.hint.level])


def rate_room(
    bow: Bow, arcs: Iterable[Bow], twins: Iterable[Bow], foreign: Iterable[float]
) -> float:
    """The demerit of an arrow near what is about the same pivot: the arcs of angles, other arrows,
    and rims of other bodies by their radii (millimetres).
    """
    return _rate_arcs(bow, arcs) + _rate_twins(bow, twins) + _rate_rims(bow, foreign)


def _rate_arcs(bow: Bow, arcs: Iterable[Bow]) -> float:
    """The demerit of an arrow, larger where it would look like a part of the arc of an angle at the
    same pivot.
    """
    worse = 0.0
    for arc in arcs:
        from_start = bow.start + bow.sweep / 2 - arc.start
        turned = from_start % (2 * pi) if arc.sweep > 0 else -from_start % (2 * pi)
        if turned < abs(arc.sweep) and abs(bow.radius - arc.radius) < _APART:
            worse += _MERGED
    return worse


def _rate_twins(bow: Bow, twins: Iterable[Bow]) -> float:
    """The demerit of an arrow that follows or covers another one at the same pivot, so that the two
    read as one: they stand opposite one another, else one well outside the other.
    """
    worse = 0.0
    for twin in twins:
        radius = (bow.radius + twin.radius) / 2
        turned = bow.start + bow.sweep / 2 - twin.start - twin.sweep / 2
        shafts = (abs(bow.sweep) + abs(twin.sweep)) / 2
        gap = radius * (abs(shorter_way(turned)) - shafts)
        apart = abs(bow.radius - twin.radius) / _NESTED
        worse += _FOLLOWING * max(0.0, 1 - apart / 2) * max(0.0, _BETWEEN - max(gap, 0.0))
        worse += _COVERED * (gap < 0 and apart < 1)
    return worse


def _rate_rims(bow: Bow, foreign: Iterable[float]) -> float:
    """The demerit of an arrow near the rims of another body about the same pivot, which would seem
    to turn.
    """
    return sum(max(0.0, _FOREIGN - abs(bow.radius - radius)) for radius in foreign)
