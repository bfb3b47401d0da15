"""Where the arrows of the motions of one point may stand: each by itself, and two as twins."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import partial

from msgspec import Struct
from msgspec.structs import replace

from kinegrade.figure.marks.imposed import find_imposed_direction
from kinegrade.figure.marks.straight.moving_arrow import ARROW, LEAVING, MovingArrow
from kinegrade.figure.marks.straight.twin_arrows import AT_END, IN_BLOCK, Stance, list_twins
from kinegrade.figure.marks.straight.twin_arrows import AT_PIN as TWINS_AT_PIN
from kinegrade.figure.mechanism.rails import Rail
from kinegrade.figure.mechanism.straight_parts import Bar, Part, Rod, is_slender, list_ways
from kinegrade.figure.placing.mark import direction
from kinegrade.figure.plane import NEAR, length, mean, unit
from kinegrade.figure.symbols.pins import PIN
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import Moving

# Millimetres from the point to the tail, from where on bars are kept off, and of the arrow, with
# their demerits: at its pin, there with a bar at its side, and longer, across a rim
AT_PIN = PIN + 0.2
_AHEAD = {
    (AT_PIN, LEAVING, ARROW): 0.0,
    (AT_PIN, 5.4, ARROW): 0.4,
    (AT_PIN, LEAVING, 12.0): 2.0,
    (AT_PIN, 5.4, 12.0): 2.4,
    (AT_PIN, 7.5, 12.0): 3.0,
    (AT_PIN, LEAVING, 15.0): 3.4,
    (AT_PIN, 5.4, 15.0): 3.8,
}
# Millimetres of an arrow above the ground on which it lies otherwise, where its tail is on the dot
# of its point
_ABOVE = 0.95
# Millimetres of an arrow beside the rod that leaves its point ahead of it, and from the point to
# its tail; its lengths, a shorter one beside a short rod, with their demerits
_BESIDE_ROD, _FROM_PIN = 1.15, 0.3
_ALONG_ROD = {ARROW: 0.6, 7.0: 0.8, 5.0: 1.0}
# Millimetres beside the line of motion, on the free side first, and along it to the tail: level
# with the point, unless a bar leaves it there
_OFFSETS = {3.6: 1.0, -3.6: 1.3, 2.8: 1.6, -2.8: 1.9, 5.0: 2.0, -5.0: 2.3, 6.6: 3.0, -6.6: 3.3}
_SHIFTS = {0.0: 0.0, 2.5: 6.0, 4.0: 9.0}
_FREER = 3.0  # millimetres by which the mechanism lies on one side for the other to be the free one
# Demerit of an arrow from the free end of a rod, and millimetres from that to its tail
_FROM_END, _OFF_END = 0.5, 0.3
_ROOM_BELOW = 2.0  # millimetres from a point without a block to its ground, as of a rack, for twins
_PAIR = 2  # motions of one point that may be twins
# Cosine of the angle between a motion and a bar from its point under which no twins have room
_AHEAD_OF_PIN = 0.3
_SAME = 1e-3  # between two unit vectors of one direction

# The ways to draw an arrow, by those of its point that are placed
Ways = Callable[[Sequence[MovingArrow]], Iterable[MovingArrow]]


class Site(Struct, frozen=True):
    """What the point of motions lies on: the rails of the figure, and the straight parts."""

    mechanism: Mechanism
    rails: Sequence[Rail] = ()
    parts: Sequence[Part] = ()

    def list_plans(self, hints: Sequence[Moving]) -> Iterator[Sequence[Ways]]:
        """What each of the motions of a point may be drawn as: arrows by themselves first, then
        two in one sense as twins, from each place where such an arrow may begin and no bar lies
        in their way.
        """
        usual = [self._list_arrows(hint) for hint in hints]
        yield [partial(_list_among, ways) for ways in usual]
        towards = [ways[0].toward for ways in usual]
        if len(hints) != _PAIR or length(towards[1] - towards[0]) > _SAME:
            return
        begun = [_list_begun(ways) for ways in usual]
        for first, second in zip(*begun, strict=True):
            own = self.find_rails(first.point)
            at_end = first.point != self.mechanism.points[hints[0].point]
            stance = AT_END if at_end else IN_BLOCK if own else TWINS_AT_PIN
            if stance == TWINS_AT_PIN and self._has_bar_in_lanes(first.point, first.toward):
                continue
            if not any(rail.bare and rail.level < _ROOM_BELOW for rail in own):
                side = -own[0].side if own else self._find_open_side(first.point, first.toward)
                twins = partial(_list_twins_of, side=side, stance=stance)
                yield [twins(first, short=True), twins(second, short=False)]
                yield [twins(first, short=False), twins(second, short=True)]

    def find_rails(self, point: Vector) -> list[Rail]:
        """The rails on which a point slides."""
        return [rail for rail in self.rails if length(rail.at - point) < NEAR]

    def list_ways_off_ground(self, point: Vector) -> list[Vector]:
        """The steps from a bare end on the ground to just above that."""
        rails = (rail for rail in self.find_rails(point) if rail.bare and rail.level < _ABOVE)
        return [-rail.side * _ABOVE for rail in rails]

    def find_direction(self, hint: Moving) -> Vector:
        """The unit vector of a motion."""
        if hint.along:
            points = self.mechanism.points
            return unit(direction(points, points[hint.point], hint.along))
        return find_imposed_direction(self.mechanism, hint)

    def _list_arrows(self, hint: Moving) -> list[MovingArrow]:
        """Arrows in the direction of the motion: from the point, just above the ground where a bare
        end slides, beside the bar that leaves it there, from the free end of its rod, then beside
        it, first those clear of the mechanism; never behind something.
        """
        point, toward = self.mechanism.points[hint.point], self.find_direction(hint)
        across = self._find_open_side(point, toward)
        ahead = [
            MovingArrow(point + toward * gap, toward, hint, worse, point, size=size, leaving=leave)
            for (gap, leave, size), worse in _AHEAD.items()
        ]
        above = [
            replace(arrow, start=self._start_at_bar(point + step, point, toward))
            for step in self.list_ways_off_ground(point)
            for arrow in ahead
            if abs(step.dot(toward)) < NEAR
        ]
        ahead = above or ahead
        ahead += [
            MovingArrow(start, toward, hint, usual + worse, point, size=size, outward=side)
            for size, usual in _ALONG_ROD.items()
            for side, worse in ((across, 0.0), (-across, 0.1))
            for start in (point + side * _BESIDE_ROD + toward * _FROM_PIN,)
            if any(length(way - toward) < _SAME for way in self._list_slender_from(point))
        ]
        ahead += [
            MovingArrow(end + toward * _OFF_END, toward, hint, _FROM_END, end)
            for end in self._list_rod_ends(hint.point, toward)
            if hint.point not in hint.symbol  # else it is read as leaving that point
        ]
        beside = [
            MovingArrow(point + across * offset + toward * shift, toward, hint, worse, point)
            for offset, nearby in _OFFSETS.items()
            for shift, level in _SHIFTS.items()
            for worse in (nearby + level,)
        ]
        return [*ahead, *beside]

    def _start_at_bar(self, start: Vector, point: Vector, toward: Vector) -> Vector:
        """The start of an arrow above the ground: in a bar that leaves its point over it, so that
        no tail sticks out behind that.
        """
        for way in self._list_bars_from(point):
            ahead = (start - point).cross(way) / way.cross(toward) if way.dot(toward) > NEAR else 0
            if ahead > 0:
                return start + toward * ahead
        return start

    def _list_bars_from(self, point: Vector) -> list[Vector]:
        """The unit vectors along the slender bars that leave a point."""
        bars = (part for part in self.parts if isinstance(part, Bar) and is_slender(part))
        return [unit(way) for bar in bars for way in list_ways(bar, point)]

    def _list_slender_from(self, point: Vector) -> list[Vector]:
        """The unit vectors along the slender bars and translating rods that leave a point."""
        slender = (part for part in self.parts if is_slender(part))
        return [unit(way) for part in slender for way in list_ways(part, point)]

    def _list_rod_ends(self, name: str, toward: Vector) -> Iterator[Vector]:
        """The free ends ahead of a point of the rods that translate with it."""
        at = self.mechanism.points[name]
        bodies = {body.name for body in self.mechanism.bodies if name in body.points}
        for part in self.parts:
            if isinstance(part, Rod) and part.body in bodies:
                steps = ((end, end - at) for end in part.free)
                yield from (end for end, step in steps if length(unit(step) - toward) < _SAME)

    def _has_bar_in_lanes(self, at: Vector, toward: Vector) -> bool:
        """Whether a slender bar leaves a pin so that it hides the tail of a twin, or crosses it."""
        return any(way.dot(toward) > _AHEAD_OF_PIN for way in self._list_bars_from(at))

    def _find_open_side(self, point: Vector, toward: Vector) -> Vector:
        """The unit vector across a motion away from the mechanism, where that lies on one side."""
        across = toward.turned()
        beyond = (point - mean(self.mechanism.points.values())).dot(across)
        return across if beyond > _FREER else -across


def _list_among(
    ways: Iterable[MovingArrow], placed: Sequence[MovingArrow]
) -> Iterator[MovingArrow]:
    return (arrow.among(placed) for arrow in ways)


def _list_twins_of(on_line: MovingArrow, *, side: Vector, stance: Stance, short: bool) -> Ways:
    twins = tuple(list_twins(on_line, side, stance, short=short))
    return lambda _: twins


def _list_begun(ways: Iterable[MovingArrow]) -> list[MovingArrow]:
    """The arrows on their lines of motion, one for each place from which they may begin."""
    begun: dict[Vector, MovingArrow] = {}
    for arrow in ways:
        if arrow.is_ahead():
            begun.setdefault(arrow.point, arrow)
    return list(begun.values())
