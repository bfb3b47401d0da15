"""The names of bodies: in their circles or beside their bars, where nothing else could own them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import copysign, pi
from typing import assert_never

import numpy as np
from msgspec import Struct
from msgspec.structs import replace

from kinegrade.errors import TemplateError
from kinegrade.figure.joints.symbol import Rim
from kinegrade.figure.marks.circle_names import list_spots_in_circle
from kinegrade.figure.marks.frames import FrameAxis
from kinegrade.figure.marks.in_angles import lies_in_angle, list_arcs, rate_in_angles
from kinegrade.figure.marks.lengths.dimension_lines import Leader, SymbolBeside
from kinegrade.figure.marks.lengths.extension_lines import (
    is_taken_for_one,
    list_extension_lines,
    rate_beyond_lines,
)
from kinegrade.figure.marks.names import find_named_points
from kinegrade.figure.marks.straight.motions import list_arrow_places
from kinegrade.figure.mechanism.layers import Drawing
from kinegrade.figure.mechanism.slotted_discs import list_slotted_rims
from kinegrade.figure.mechanism.straight_parts import Bar, Rod
from kinegrade.figure.placing.extent import measure_symbol
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.placing.place import (
    Floats,
    Wish,
    list_spots_around,
    list_spots_beside,
    place_label,
)
from kinegrade.figure.plane import polar, unit
from kinegrade.figure.symbols.bars import BAR_WIDTH, SLOT_WIDTH
from kinegrade.figure.teeth import TOOTH_ROOT
from kinegrade.language.message import Fault, Message, Quoted
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import FigureHints

_SPACE, _ROW = 2.5, 9.0  # millimetres between words, and from a name to a length in its row
_INSIDE_RIM = 1.5  # millimetres inside a rim at which a leader to a disc ends
_NEAR = 48  # spots around the middle of a bar before those along it
# Millimetres of the leader of a bar's name, and where on the bar it ends
_REACHES, _PLACES = (6.0, 9.0, 12.0), (0.5, 0.35, 0.65, 0.8, 0.9)
_ALONG = 0.45  # sine between a slotted bar and a leader that would run into its slot
_TAKEN, _DEAR = 10.0, 40.0  # demerit of a leader to a taken place; cost of one that is of no use
_AS_EXTENSION = 14.0  # demerit of a leader that would seem to be one of a dimension's lines
# Millimetres of paper between a name and a point whose letter it would seem to be, or the tip of an
# axis whose index
_AT_POINT, _AT_TIP = 2.6, 6.0


def add_body_names(
    layout: Layout, mechanism: Mechanism, hints: FigureHints, drawing: Drawing
) -> Layout:
    """The layout with the names of bodies, which may stand anywhere in or next to them, but last in
    the disc of another one or a smaller disc of their own, beside what is written already, at the
    end of a line or in an angle, which would seem to have that name. The name of a bar without any
    other place is led to it.

    Raises TemplateError for the label of a body of which nothing is drawn.
    """
    for body, symbol in hints.labels.items():
        if symbol and body not in mechanism.points:
            circles = [*drawing.rims, *list_slotted_rims(drawing.parts)]
            own = next((rim for rim in circles if rim.body == body), None)
            others = tuple(rim for rim in circles if rim is not own)
            named = find_named_points(mechanism, hints, drawing)
            points = *(mechanism.points[name] for name in named), *list_arrow_places(layout.marks)
            tips = tuple(mark.tip() for mark in layout.marks if isinstance(mark, FrameAxis))
            around = _Surroundings(layout, own, others, points, tips)
            spots = _list_spots(body, symbol, own, drawing)
            taken = around.rate(symbol, spots) + around.find_outside(spots)
            wish = Wish(symbol, spots[np.argsort(taken, kind="stable")])
            layout = _write_name(layout, wish, around, _list_leaders(body, symbol, own, drawing))
    return layout


def _write_name(
    layout: Layout, wish: Wish, around: _Surroundings, leaders: Sequence[Leader]
) -> Layout:
    """The layout with a name at one of its places, or at a leader where none is its own."""
    placed = place_label(wish, layout.obstacles)
    spot = np.array([placed.label.centre])
    lost = around.rate(wish.symbol, spot) + around.find_outside(spot)
    if leaders and (placed.faulty or lost[0] > 0):
        led = layout.marked(around.rate_leaders(leaders))
        if led.costs[-1] < _DEAR:
            return led
    return layout.written((wish,))


class _Surroundings(Struct, frozen=True):
    """What else a name might be read as that of: what is written and marked, other bodies' rims,
    points and places along arrows; and the circle of its `own` body.
    """

    layout: Layout
    own: Rim | None
    others: tuple[Rim, ...]
    points: tuple[Vector, ...]
    tips: tuple[Vector, ...]

    def rate(self, symbol: str, spots: Floats) -> Floats:
        """For each spot how many things there would seem to have the name."""
        wish = Wish(symbol, spots)
        taken = _find_beside(wish, self.layout) + _find_at_lines(wish, self.layout)
        taken += _find_at_points(wish, self.points, _AT_POINT)
        taken += _find_at_points(wish, self.tips, _AT_TIP)
        return taken + _find_in_others(wish, self.others)

    def find_outside(self, spots: Floats) -> Floats:
        """For each spot 1 outside the disc of its body, where nothing says whose name it is."""
        if self.own is None or self.own.ring:
            return np.zeros(len(spots))
        outside = np.hypot(*(spots - np.array(self.own.at)).T) > self.own.radius
        return np.asarray(outside, dtype=float)

    def rate_leaders(self, leaders: Sequence[Leader]) -> list[Leader]:
        """The leaders of one name, each with its demerit here."""
        ends = np.concatenate([leader.wish().spots[:1] for leader in leaders])
        arcs = tuple(list_arcs(self.layout.marks))
        lines = tuple(list_extension_lines(self.layout.marks))
        found = []
        for leader, taken in zip(leaders, self.rate(leaders[0].symbol, ends), strict=True):
            worse = _TAKEN * (taken + lies_in_angle(leader.line(), arcs))
            worse += _AS_EXTENSION * is_taken_for_one(leader.line(), lines)
            found.append(replace(leader, worse=worse))
        return found


def _find_beside(wish: Wish, layout: Layout) -> Floats:
    """For each spot of a wish 1 where a letter stands close to its left or right, or the symbol of
    a bar's length in one row with it, else 0.
    """
    beside = np.zeros(len(wish.spots))
    lengths = {mark.symbol for mark in layout.marks if isinstance(mark, SymbolBeside)}
    width, height = measure_symbol(wish.symbol)
    for label in layout.labels:
        steps = np.abs(wish.spots - np.array(label.centre))
        level = steps[:, 1] < (height + label.height) / 2
        space = _ROW if label.symbol in lengths else _SPACE
        close = steps[:, 0] < (width + label.width) / 2 + space
        beside = np.maximum(beside, level & close)
    return beside


def _find_at_lines(wish: Wish, layout: Layout) -> Floats:
    """For each spot of a wish 1 in an angle, or beyond the end of a line along a side of one or of
    an extension line, else 0.
    """
    arcs, half = tuple(list_arcs(layout.marks)), max(measure_symbol(wish.symbol)) / 2
    sides = [side for arc in arcs for side in arc.list_sides()]
    lines = (*sides, *list_extension_lines(layout.marks))
    return np.maximum(rate_in_angles(wish.spots, arcs), rate_beyond_lines(wish.spots, half, lines))


def _find_at_points(wish: Wish, points: Iterable[Vector], near: float) -> Floats:
    """For each spot of a wish 1 where it stands so near to a point, whose letter it would seem to
    be, or to the tip of an axis, whose index.
    """
    found, half = np.zeros(len(wish.spots)), np.array(measure_symbol(wish.symbol)) / 2
    for point in points:
        away = np.hypot(*np.maximum(np.abs(wish.spots - np.array(point)) - half, 0.0).T)
        found = np.maximum(found, away < near)
    return found


def _find_in_others(wish: Wish, others: Iterable[Rim]) -> Floats:
    """For each spot of a wish 1 in the disc of another body, or beyond a ring, else 0."""
    found = np.zeros(len(wish.spots))
    for rim in others:
        steps = wish.spots - np.array(rim.at)
        inside = np.hypot(*steps.T) < rim.radius
        found = np.maximum(found, inside != rim.ring)
    return found


def _list_spots(body: str, symbol: str, circle: Rim | None, drawing: Drawing) -> Floats:
    if circle:
        return list_spots_in_circle(symbol, circle)
    parts = [part for part in drawing.parts if isinstance(part, Bar | Rod) and part.body == body]
    if not parts:
        what = Message("figure.nothing-to-label", body=Quoted(body))
        raise TemplateError(Fault(f"figure.labels.{body}", what))
    around = list_spots_around(symbol, (parts[0].start + parts[0].end) / 2)
    along = [list_spots_beside(symbol, part.start, part.end) for part in parts]
    return np.concatenate((around[:_NEAR], *along, around[_NEAR:]))


def _list_leaders(body: str, symbol: str, circle: Rim | None, drawing: Drawing) -> list[Leader]:
    """Leaders to places on the bar that a body is drawn as, or to the rim of its disc; none to a
    ring.
    """
    if circle:
        return _list_leaders_to_rim(symbol, circle)
    bars = [part for part in drawing.parts if isinstance(part, Bar | Rod) and part.body == body]
    turns = [pi / 6 * turn for turn in range(12)] + [pi / 12 * turn for turn in range(1, 24, 2)]
    starts = [
        (start, turn)
        for bar in bars[:1]
        for share in _PLACES
        for turn in turns
        for start in _find_solid(bar, bar.start + (bar.end - bar.start) * share, turn)
    ]
    return [Leader(start, turn, reach, symbol) for reach in _REACHES for start, turn in starts]


def _find_solid(bar: Bar | Rod, at: Vector, turn: float) -> list[Vector]:
    """Where a leader in a direction ends at a place on a bar: of a slotted one beside its slot,
    and not from along it.
    """
    if isinstance(bar, Rod) or bar.use != "slot":
        return [at]
    across = unit(bar.end - bar.start).turned()
    aside = across.dot(polar(turn))
    beside = (BAR_WIDTH + SLOT_WIDTH) / 4
    return [at + across * copysign(beside, aside)] if abs(aside) > _ALONG else []


def _list_leaders_to_rim(symbol: str, rim: Rim) -> list[Leader]:
    """Leaders outward from a little inside a rim; of a gear, from the bottom of its teeth."""
    if rim.ring:
        return []
    inside = min(_find_depth(rim), rim.radius)
    return [
        Leader(rim.at + polar(turn, rim.radius - inside), turn, reach + inside, symbol)
        for reach in _REACHES
        for turn in (pi / 6 * number for number in range(12))
    ]


def _find_depth(rim: Rim) -> float:
    """Millimetres within a rim at which a leader to its body ends."""
    match rim.kind:
        case "gear":
            return TOOTH_ROOT
        case "wheel" | "slot" | "cam" | "edge":
            return _INSIDE_RIM
        case _:
            assert_never(rim.kind)
