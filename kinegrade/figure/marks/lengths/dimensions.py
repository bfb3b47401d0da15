"""Distances between points: dimension lines at several distances, or the symbol next to a drawn
line or at the end of a leader.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import partial
from math import copysign, inf, pi

from msgspec.structs import replace

from kinegrade.figure.marks.lengths.claims import list_rates
from kinegrade.figure.marks.lengths.dimension_company import DimensionCompany, list_beside
from kinegrade.figure.marks.lengths.dimension_lines import DimensionLine, SymbolBeside
from kinegrade.figure.marks.lengths.extension_gaps import Around, Gap, find_gap
from kinegrade.figure.marks.lengths.length_leaders import list_leaders
from kinegrade.figure.marks.lengths.measured_direction import find_measured_direction
from kinegrade.figure.placing.joining import Join, divides, find_join, part_line
from kinegrade.figure.placing.layout import Layout, no_others
from kinegrade.figure.placing.mark import Mark
from kinegrade.figure.placing.obstacles import Obstacles, Segment
from kinegrade.figure.plane import NEAR, angle_of, length
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import Length

# Millimetres, of dimension lines
_OFFSETS = tuple(
    side * offset
    for offset in (5.5, 8.0, 10.5, 13.0, 16.0, 19.5, 23.0, 26.5)
    for side in (1.0, -1.0)
)
_LIKELY = 3.5  # demerit below which a dimension is judged before those farther off
_HIDDEN = 1.0  # demerit of a millimetre in which nothing leads to an extension line
# Millimetres, of a dimension line close to its points, short of what is farther, its demerit
_CLOSE_BY, _CLOSER = 4.6, 6.0
_SHORT = 4.0  # millimetres of a gap that still leave room for a line of the least offset
# Demerits of a symbol alone beside a part of a bar that runs on, and beside a thin line
_PART, _LEG = 20.0, 3.0
# Demerits of a symbol alone beside the line that joins two points, if any does
_JOINED: Mapping[Join, float] = {"whole": 0.0, "part": _PART, "none": inf}
Gaps = tuple[Gap, Gap]
_REACH = 30.0  # millimetres of a line that a dimension may need at a point
_DRAWN_GAP = 2.5  # millimetres by which a line between two points may miss either of them


def add_length(
    layout: Layout,
    at: Mapping[str, Vector],
    hint: Length,
    around: Around,
    others: Iterable[Length] = (),
) -> Layout:
    """The layout with a dimension line that stands well apart from earlier ones, or the symbol
    alone where a line is drawn exactly between the two points of the mechanism `around` it, or
    where one of the `others` takes the rest of that line.
    """
    start, end = at[hint.start], at[hint.end]
    company = DimensionCompany.of(layout, around.ground, list_beside(at, hint))
    dimensions = _list_dimensions(at, hint, around)
    join = find_join(around.drawn, start, end, _DRAWN_GAP)
    shares = join == "part" and any(_share_line(at, hint, each, around.drawn) for each in others)
    demerit = _JOINED["whole" if shares else join]
    if find_join(layout.obstacles, start, end, _DRAWN_GAP) == "whole":
        demerit = min(demerit, _LEG)
    half = around.find_half_width(start, end)
    letters = _list_letters(at, hint, 0.0 if half else demerit, half, layout.obstacles)
    outward, rates = around.find_outward(start, end), list_rates(layout)
    letters = [replace(each, outward=outward, rates=rates) for each in letters]
    led = demerit < _PART and letters
    leaders = partial(list_leaders, layout, (start, end), hint.symbol) if led else no_others
    close = [company.rate(mark) for mark in dimensions if mark.demerit < _LIKELY]
    far = [mark for mark in dimensions if mark.demerit >= _LIKELY]
    least = min((mark.demerit for mark in far), default=inf)
    usual: list[Mark] = [*close, *letters]
    if any(mark.demerit < least for mark in usual):
        found = layout.marked(usual, (), leaders)
        if found.costs[-1] < least and found.crowded == layout.crowded:
            return found  # none that is farther off can be better
    return layout.marked([*close, *map(company.rate, far), *letters], (), leaders)


def _list_dimensions(at: Mapping[str, Vector], hint: Length, around: Around) -> list[DimensionLine]:
    start, end = at[hint.start], at[hint.end]
    measured = find_measured_direction(hint.along, start, end)
    backwards = hint.signed and measured.dot(end - start) < 0
    symbol = rf"\left|{hint.symbol}\right|" if backwards else hint.symbol
    gaps = {
        side: (
            find_gap(start, measured.turned() * side, around),
            find_gap(end, measured.turned() * side, around),
        )
        for side in (1.0, -1.0)
    }
    close = [
        _draw_close_dimension((start, end), measured, side, symbol, gaps[side])
        for side in (1.0, -1.0)
        if all(gap.close for gap in gaps[side])
    ]
    pins = tuple(at[name] for name in at if name not in (hint.start, hint.end))
    farther = [
        _draw_dimension((start, end), measured, offset, symbol, gaps[copysign(1.0, offset)])
        for offset in _OFFSETS
    ]
    return [replace(each, pins=pins) for each in (*close, *farther)]


def _draw_close_dimension(
    points: Segment, measured: Vector, side: float, symbol: str, gaps: Gaps
) -> DimensionLine:
    """The dimension line just beside the broad body that its points are on, short of a guide or
    another bar that stands farther out on that side.
    """
    across = measured.turned() * side
    level = max(across.dot(point) for point in points) + _CLOSE_BY
    feet = [point + across * (level - across.dot(point)) for point in points]
    return DimensionLine(points, (feet[0], feet[1]), symbol, _CLOSER, _measure(gaps))


def _list_letters(
    at: Mapping[str, Vector], hint: Length, demerit: float, half: float, drawn: Obstacles
) -> list[SymbolBeside]:
    """The symbol beside the line between the two points, or the link of that half width; nothing
    where no line joins the points, or a part of it could be meant.
    """
    start, end = at[hint.start], at[hint.end]
    points = [point for name, point in at.items() if name not in (hint.start, hint.end)]
    if hint.along is not None or demerit == inf or divides(start, end, points):
        return []
    return [SymbolBeside(start, end, hint.symbol, demerit, half, drawn)]


def find_extension_angles(
    at: Mapping[str, Vector], hints: Iterable[Length], point: Vector, drawn: Obstacles
) -> tuple[float, ...]:
    """The directions (radians) in which the dimension lines of some lengths may need a line from a
    point; none where a symbol beside a bar may do.
    """
    found = []
    for hint in hints:
        start, end = at[hint.start], at[hint.end]
        ends_here = min(length(start - point), length(end - point)) < NEAR
        if ends_here and _needs_dimension(hint, start, end, drawn):
            across = angle_of(find_measured_direction(hint.along, start, end).turned())
            found += [across, across - pi]
    return tuple(found)


def list_likely_extensions(
    at: Mapping[str, Vector], hints: Iterable[Length], drawn: Obstacles
) -> tuple[Segment, ...]:
    """The lines that the dimensions of some lengths may need at their points."""
    found = []
    for hint in hints:
        start, end = at[hint.start], at[hint.end]
        if _needs_dimension(hint, start, end, drawn):
            across = find_measured_direction(hint.along, start, end).turned() * _REACH
            found += [(point, point + way) for point in (start, end) for way in (across, -across)]
    return tuple(found)


def _needs_dimension(hint: Length, start: Vector, end: Vector, drawn: Obstacles) -> bool:
    """Whether a length may need a dimension line, as no bar leads from one point to the other."""
    return hint.along is not None or find_join(drawn, start, end, _DRAWN_GAP) != "whole"


def _share_line(at: Mapping[str, Vector], one: Length, other: Length, drawn: Obstacles) -> bool:
    """Whether two lengths with one symbol are the parts of one line, so that a symbol beside either
    cannot be meant for all of it.
    """
    if one.symbol != other.symbol or one.along or other.along:
        return False
    part, rest = ((at[each.start], at[each.end]) for each in (one, other))
    return part_line(drawn, part, rest, _DRAWN_GAP)


def _draw_dimension(
    points: Segment, measured: Vector, offset: float, symbol: str, gaps: Gaps
) -> DimensionLine:
    """The dimension line at an offset from the outer one of the two points, outside supports."""
    across = measured.turned()
    offset += copysign(max(0.0, max(gap.reach for gap in gaps) - _SHORT), offset)
    outer = max if offset > 0 else min
    level = outer(across.dot(point) for point in points) + offset
    feet = [point + across * (level - across.dot(point)) for point in points]
    hidden = sum(gap.hidden for gap in gaps)
    demerit = 0.3 * abs(offset) + _HIDDEN * hidden
    return DimensionLine(points, (feet[0], feet[1]), symbol, demerit, _measure(gaps))


def _measure(gaps: Gaps) -> tuple[float, float]:
    return gaps[0].reach, gaps[1].reach
