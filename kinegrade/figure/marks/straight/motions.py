"""Given straight motions as arrows at a point, each with several alternatives."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import partial

import numpy as np

from kinegrade.figure.marks.straight.arrow_places import AT_PIN, Site, Ways
from kinegrade.figure.marks.straight.arrow_surroundings import Surroundings
from kinegrade.figure.marks.straight.moving_arrow import ARROW, LEAVING, MovingArrow
from kinegrade.figure.marks.straight.twin_arrows import LONG, list_lanes
from kinegrade.figure.marks.turning_arrow import TurningArrow
from kinegrade.figure.mechanism.straight_parts import Bar, Rod
from kinegrade.figure.placing.aligned import list_thin_lines
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.placing.letters import trace_leader
from kinegrade.figure.placing.mark import Mark
from kinegrade.figure.placing.obstacles import Obstacles, Segment
from kinegrade.figure.placing.ownership import Claims, list_places
from kinegrade.figure.placing.place import Wish
from kinegrade.figure.plane import length, unit
from kinegrade.figure.scene import THIN, Disc, Label, Primitive, Strokes
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import Moving

_LANE = 0.85  # millimetres on either side of an arrow to come that are kept clear of letters
_PAST_TIP = 2.0  # millimetres past its tip, where the arc of an angle would seem to end it
# Millimetres about a tail in which thin lines may seem to own a symbol, and beside the arrow itself
_ABOUT, _BESIDE = 18.0, 1.2
_PAST = 2.4  # millimetres past its tip in which a line on its own line is no other one
_AT_LINE = 4.0  # demerit of a symbol past a tip on a line that runs on from the arrow
_MISPLACED = 60.0  # cost from which on an arrow has no good place
_UNLIKE = 3.0  # demerit of two arrows in one sense that are not twins


def add_motions(
    layout: Layout,
    site: Site,
    hints: Sequence[Moving],
    named: Iterable[Wish] = (),
) -> Layout:
    """The layout with an arrow for each motion of one point, in its direction, and then their
    symbols, each nearest to its own; these leave the letter of the point, if that is among those
    `named` that are still to be written, a place close to it.

    Beside the point an arrow keeps off the line of another one that goes the other way: the two
    would read as a dimension. It stays on the open side of the rail on which the point slides.
    """
    at, toward = site.mechanism.points[hints[0].point], site.find_direction(hints[0])
    around = Surroundings.of(layout, site.rails, at, toward)
    usual, *twins = site.list_plans(hints)
    rate = partial(_rate_plan, len(hints))
    placed = [_place(layout, around, plan) for plan in twins]
    if not placed or min(map(rate, placed)) >= _UNLIKE:
        placed = [_place(layout, around, usual), *placed]
    layout, arrows = min(placed, key=rate)
    captioned = _caption(layout, arrows, site)
    for letter in named:
        if letter.names == at and _stands_off(letter, captioned):
            kept = layout.written([letter]).labels[-1:]
            other = _caption(layout, arrows, site, kept)
            if len(other.crowded) <= len(captioned.crowded) and not _stands_off(letter, other):
                return other
    return captioned


def _place(
    layout: Layout, around: Surroundings, plan: Iterable[Ways]
) -> tuple[Layout, list[MovingArrow]]:
    """The layout with an arrow for each motion, without their symbols, and these arrows."""
    arrows: list[MovingArrow] = []
    for ways in plan:
        layout, wish = layout.chosen(list(ways(arrows)), rate=around.rate)
        if layout.costs[-1] >= _MISPLACED:
            layout = layout.complaining(wish.symbol)
        arrows += [mark for mark in layout.marks[-1:] if isinstance(mark, MovingArrow)]
    return layout, arrows


def _rate_plan(count: int, plan: tuple[Layout, Sequence[MovingArrow]]) -> float:
    """The cost of so many arrows; of two in one sense that are no twins, more."""
    layout, arrows = plan
    twins = count == 1 or arrows[0].outward is not None
    return round(sum(layout.costs[-count:]) + _UNLIKE * (not twins), 6)


def _caption(
    layout: Layout,
    arrows: Sequence[MovingArrow],
    site: Site,
    kept: Sequence[Label] = (),
) -> Layout:
    """The layout with the symbols of arrows at one point, each nearest to its own, which keep clear
    of a letter that is still to be written.
    """
    lines = list_thin_lines(layout.lines)
    bars = tuple((part.start, part.end) for part in site.parts if isinstance(part, Bar | Rod))
    discs = [part for part in layout.lines if isinstance(part, Disc)]
    for arrow in arrows:
        others = [other for other in arrows if other != arrow]
        wish = arrow.wish_apart(others, site.find_rails(arrow.point))
        own, places = arrow.list_stations(), list(list_places(lines, arrow.start, _ABOUT))
        near = [*own, own[-1] + arrow.toward * _PAST]
        foreign = [at for at in places if all(length(at - each) > _BESIDE for each in near)]
        around = tuple(disc for disc in discs if arrow.lies_in(disc))
        claims = Claims(around, bars, lines=tuple(foreign))
        worse = claims.rate(wish.symbol, wish.spots, own)
        if any(arrow.is_past(at) for at in places):
            worse += _AT_LINE * np.array([arrow.is_past(Vector(*at)) for at in wish.spots])
        layout = layout.captioned(wish.worse_by(worse), kept)
    return layout


def _stands_off(letter: Wish, layout: Layout) -> bool:
    """Whether a letter written now would stand off from its point."""
    label = layout.written([letter]).labels[-1]
    return letter.names is not None and trace_leader(label, letter.names) is not None


def list_arrows(marks: Iterable[Mark]) -> tuple[TurningArrow | MovingArrow, ...]:
    """The arrows of straight motions and of rotations among the marks of a figure."""
    return tuple(mark for mark in marks if isinstance(mark, TurningArrow | MovingArrow))


def list_arrow_places(marks: Iterable[Mark]) -> list[Vector]:
    """Places along those arrows."""
    return [at for arrow in list_arrows(marks) for at in arrow.list_stations()]


def gather_arrows(marks: Iterable[Mark]) -> Obstacles:
    """Those arrows as obstacles."""
    return Obstacles.of(part for arrow in list_arrows(marks) for part in arrow.primitives())


def list_likely_motions(site: Site, hints: Iterable[Moving]) -> list[Segment]:
    """Where arrows will be, if nothing is in the way, from their points to their tips: where they
    lie on the ground just above it, where two go one way on either side of their line as well.
    """
    starts = [(site.mechanism.points[hint.point], site.find_direction(hint)) for hint in hints]
    segments: list[Segment] = []
    for number, (at, toward) in enumerate(starts):
        twins = (at, toward) in starts[:number]
        step = toward * (AT_PIN + (LONG if twins else ARROW))
        beside = [*site.list_ways_off_ground(at), *(list_lanes(toward) if twins else ())]
        segments += [(at, at + step), *((at + side, at + side + step) for side in beside)]
    return segments


def list_likely_symbols(site: Site, hints: Iterable[Moving]) -> Iterator[Label]:
    """Where the symbols of arrows along the ground will be, which have room on one side alone."""
    for hint in hints:
        at, toward = site.mechanism.points[hint.point], site.find_direction(hint)
        for step in site.list_ways_off_ground(at):
            wish = MovingArrow(at + step, toward, hint, 0.0, at).wish()
            open_spots = (wish.spots - np.array(at + step)) @ np.array(step) > 0
            yield wish.label_at(int(np.argmax(open_spots)))


def draw_likely_motions(arrows: Iterable[Segment]) -> tuple[Primitive, ...]:
    """Lines on either side of likely arrows, from where these leave the parts at their points;
    angles keep clear of them.
    """
    lanes = []
    for at, tip in arrows:
        toward = unit(tip - at)
        past = toward * (AT_PIN + ARROW + _PAST_TIP)
        for aside in (_LANE, -_LANE):
            beside = at + toward.turned() * aside
            lanes.append((beside + toward * LEAVING, beside + past))
    return (Strokes(tuple(lanes), THIN),) if lanes else ()
