"""Given straight motions as arrows at a point, each with several alternatives."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

from kinegrade.figure.marks.imposed import find_imposed_direction
from kinegrade.figure.marks.moving_arrow import ARROW, LEAVING, MovingArrow
from kinegrade.figure.marks.turning_arrow import TurningArrow
from kinegrade.figure.mechanism.rails import Rail
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.placing.letters import trace_leader
from kinegrade.figure.placing.mark import Mark, direction
from kinegrade.figure.placing.obstacles import Obstacles, Segment
from kinegrade.figure.placing.place import Wish
from kinegrade.figure.plane import NEAR, length, mean, polar, unit
from kinegrade.figure.scene import THIN, Bow, Label, Primitive, Strokes
from kinegrade.figure.symbols import PIN
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import Moving

# Millimetres from the point to the tail, from where on bars are kept off, and of the arrow, with
# their demerits: at its pin, there with a bar at its side, and longer, across a rim
_AT_PIN = PIN + 0.2
_AHEAD = {
    (_AT_PIN, LEAVING, ARROW): 0.0,
    (_AT_PIN, 5.4, ARROW): 0.4,
    (_AT_PIN, LEAVING, 12.0): 2.0,
    (_AT_PIN, 5.4, 12.0): 2.4,
}
# Demerits of an arrow that ends at a rim, as a radius would, and at the arc of an angle
_HEAD_AT_RIM, _HEAD_AT_ARC = 3.5, 8.0
_OVER_SIDE = 18.0  # demerit of a longer arrow that hides the side of an angle
# Millimetres of an arrow above the ground on which it lies otherwise, and the demerit
_ABOVE, _OFF_GROUND = 1.1, 0.2
# Millimetres beside the line of motion, on the free side first, and along it to the tail: level
# with the point, unless a bar leaves it there
_OFFSETS = {3.6: 1.0, -3.6: 1.3, 2.8: 1.6, -2.8: 1.9, 5.0: 2.0, -5.0: 2.3, 6.6: 3.0, -6.6: 3.3}
_SHIFTS = {0.0: 0.0, 2.5: 2.0, 4.0: 4.0}
_BEHIND = 30.0  # demerit of an arrow on the far side of the rail on which its point slides
_FREER = 3.0  # millimetres by which the mechanism lies on one side for the other to be the free one
_ACROSS_ARC = 12.0  # demerit of an arrow across the arc of an angle, which would seem to end there
_SAME = 1e-3  # between two unit vectors of one direction
_SLANTED = 4.0  # demerit of an arrow in the ground whose line would slant through the hatching
_LANE = 0.85  # millimetres on either side of an arrow to come that are kept clear of letters
_PAST_HATCHING = 1.4  # millimetres from a rail to the way past its hatching


def add_motions(
    layout: Layout,
    mechanism: Mechanism,
    hints: Sequence[Moving],
    rails: Sequence[Rail] = (),
    named: Iterable[Wish] = (),
) -> Layout:
    """The layout with an arrow for each motion of one point, in its direction, and then their
    symbols, each nearest to its own; these leave the letter of the point, if that is among those
    `named` that are still to be written, a place close to it.

    Beside the point an arrow keeps off the line of another one that goes the other way: the two
    would read as a dimension. It stays on the open side of the rail on which the point slides.
    """
    arcs = [line for line in layout.lines if isinstance(line, Bow) and line.pen == THIN]
    arrows: list[MovingArrow] = []
    for hint in hints:
        ways = _list_arrows(mechanism, hint, rails)
        along = [arc for arc in arcs if _begins_along(arc, ways[0])]
        across = Obstacles.of(arc for arc in arcs if arc not in along)
        rims = Obstacles((), layout.obstacles.rings)
        around = _Surroundings(tuple(rails), across, Obstacles.of(along), rims)
        layout, _ = layout.chosen([around.rate(arrow.among(arrows)) for arrow in ways])
        arrows += [mark for mark in layout.marks[-1:] if isinstance(mark, MovingArrow)]
    usual = _caption(layout, arrows, rails)
    for letter in named:
        if letter.names == mechanism.points[hints[0].point] and _stands_off(letter, usual):
            kept = layout.written([letter]).labels[-1:]
            other = _caption(layout, arrows, rails, kept)
            if len(other.crowded) <= len(usual.crowded) and not _stands_off(letter, other):
                return other
    return usual


def _caption(
    layout: Layout,
    arrows: Sequence[MovingArrow],
    rails: Sequence[Rail],
    kept: Sequence[Label] = (),
) -> Layout:
    """The layout with the symbols of arrows at one point, each nearest to its own, which keep clear
    of a letter that is still to be written.
    """
    for arrow in arrows:
        others = [other for other in arrows if other != arrow]
        own = [rail for rail in rails if length(rail.at - arrow.point) < NEAR]
        layout = layout.captioned(arrow.wish_apart(others, own), kept)
    return layout


def _stands_off(letter: Wish, layout: Layout) -> bool:
    """Whether a letter written now would stand off from its point."""
    label = layout.written([letter]).labels[-1]
    return letter.names is not None and trace_leader(label, letter.names) is not None


def list_arrows(marks: Iterable[Mark]) -> tuple[TurningArrow | MovingArrow, ...]:
    """The arrows of straight motions and of rotations among the marks of a figure."""
    return tuple(mark for mark in marks if isinstance(mark, TurningArrow | MovingArrow))


def list_likely_motions(mechanism: Mechanism, hints: Iterable[Moving]) -> list[Segment]:
    """Where arrows will be, if nothing is in the way, from their points to their tips."""
    starts = [
        (mechanism.points[hint.point], find_motion_direction(mechanism, hint)) for hint in hints
    ]
    return [(at, at + toward * (_AT_PIN + ARROW)) for at, toward in starts]


def draw_likely_motions(arrows: Iterable[Segment]) -> tuple[Primitive, ...]:
    """Lines on either side of likely arrows, from where these leave the parts at their points;
    angles keep clear of them.
    """
    lanes = []
    for at, tip in arrows:
        toward = unit(tip - at)
        for aside in (_LANE, -_LANE):
            beside = at + toward.turned() * aside
            lanes.append((beside + toward * LEAVING, beside + toward * ARROW))
    return (Strokes(tuple(lanes), THIN),) if lanes else ()


def _begins_along(arc: Bow, arrow: MovingArrow) -> bool:
    """Whether an arrow from the vertex of an angle runs along a side of it."""
    sides = (polar(arc.start), polar(arc.start + arc.sweep))
    at_vertex = length(arc.centre - arrow.point) < NEAR
    return at_vertex and any(length(side - arrow.toward) < _SAME for side in sides)


@dataclass(frozen=True)
class _Surroundings:
    """What else decides where an arrow may stand: rails, the arcs of angles, those of them that
    begin `along` it, and rims.
    """

    rails: tuple[Rail, ...]
    angles: Obstacles
    along: Obstacles
    rims: Obstacles

    def rate(self, arrow: MovingArrow) -> MovingArrow:
        """The arrow with its demerit here; the way to one in the ground is past the hatching, and
        straight through it.
        """
        worse, past, ground = 0.0, arrow.past, 0.0
        if self.angles.lines and self.angles.along(arrow.path(), arrow.shared) > 0:
            worse += _ACROSS_ARC
        if self.along.lines and arrow.short:
            worse += _OVER_SIDE
        elif self.along.lines and self.along.along((arrow.head(),), arrow.shared) > 0:
            worse += _HEAD_AT_ARC
        if self.rims.rings and self.rims.along((arrow.head(),), arrow.shared) > 0:
            worse += _HEAD_AT_RIM
        for rail in self.rails:
            slides = length(rail.at - arrow.point) < NEAR
            if slides and (arrow.start - rail.at).dot(rail.side) > rail.level:
                worse += _BEHIND + _SLANTED * (not arrow.is_level())
                past, ground = max(past, rail.level + _PAST_HATCHING), rail.level
        if not worse and past == arrow.past:
            return arrow
        return replace(arrow, demerit=arrow.demerit + worse, past=past, ground=ground)


def _list_arrows(mechanism: Mechanism, hint: Moving, rails: Sequence[Rail]) -> list[MovingArrow]:
    """Arrows in the direction of the motion: from the point, just above the ground where a bare end
    slides, then beside it, first those clear of the mechanism; never behind something.
    """
    point = mechanism.points[hint.point]
    toward = find_motion_direction(mechanism, hint)
    across = toward.turned()
    beyond = (point - mean(mechanism.points.values())).dot(across)
    across = across if beyond > _FREER else -across
    ahead = [
        MovingArrow(point + toward * gap, toward, hint, demerit, point, size=size, leaving=leaving)
        for (gap, leaving, size), demerit in _AHEAD.items()
    ]
    above = [-rail.side for rail in rails if rail.bare and length(rail.at - point) < NEAR]
    ahead += [
        replace(arrow, start=arrow.start + side * _ABOVE, demerit=arrow.demerit + _OFF_GROUND)
        for side in above
        for arrow in ahead
        if abs(side.dot(toward)) < NEAR
    ]
    beside = [
        MovingArrow(point + across * offset + toward * shift, toward, hint, nearby + level, point)
        for offset, nearby in _OFFSETS.items()
        for shift, level in _SHIFTS.items()
    ]
    return [*ahead, *beside]


def find_motion_direction(mechanism: Mechanism, hint: Moving) -> Vector:
    """The unit vector of a motion."""
    if hint.along:
        return unit(direction(mechanism.points, mechanism.points[hint.point], hint.along))
    return find_imposed_direction(mechanism, hint)
