"""Radii of circles: an arrow from the centre to the rim, or from outside for a small circle."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from functools import partial
from math import cos, pi
from typing import assert_never

from msgspec.structs import replace

from kinegrade.errors import TemplateError, suggest
from kinegrade.figure.joints.symbol import Rim
from kinegrade.figure.marks.radius_arrows import FROM_OUTSIDE, RadiusFromCentre, RadiusFromOutside
from kinegrade.figure.marks.radius_crossings import rate_crossings
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.placing.obstacles import COST_BOLD, Obstacles
from kinegrade.figure.plane import NEAR, angle_of, length, nearest_of, polar, unit
from kinegrade.figure.scene import THIN, Bow
from kinegrade.figure.symbols.arrows import HEAD_LENGTH
from kinegrade.figure.symbols.ground import list_round_hatching
from kinegrade.figure.teeth import find_tooth_angle
from kinegrade.language.message import Fault, Message, Quoted
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import Radius

_SMALL_RADIUS = 8.0  # millimetres: a smaller circle has its radius marked from outside
_PREFERRED = tuple(turn * pi for turn in (0.75, 0.25, -0.75, -0.25, 0.5, 1.0, 0.0, -0.5))
_PAST, _SEEN = 1.6, 4.0  # millimetres from a centre to a line past it, and to its farther end
_LEANING, _LEAST_ANGLE = 6.0, cos(pi / 10)  # cost of an arrow nearer than that to another line
# Cost of an arrow nearer than that to a line's prolongation, as both would read as a diameter
_PROLONGING, _STRAIGHT = 12.0, -cos(pi / 9)
_WITHIN_ANGLE = 12.0  # cost of an arrow between the sides of an angle, as if it were one of them
# Cost of an arrow that reads as the distance of two circles, and millimetres from its tail to the
# outer one
_SPANNING, _AT_OUTER = 60.0, 2.6
_NARROW = HEAD_LENGTH + 1.0  # millimetres of a ring that a head across it would fill
# Cost of an arrow with its tail at another wheel, and millimetres between the two
_FOREIGN, _AT_ANOTHER = 15.0, 2.0
_INWARD = 9.0  # cost of an arrow at a large circle from outside, less than one firm line
_AT_POINT = 3.0  # cost of a tip that hides a point on the rim
# Millimetres beyond a rim in which a bar leaves a narrow wedge, and the cost of a tip beside one
_WEDGE, _BESIDE_BAR = 2.2, 8.0
# Parts of an arc from its start
_ALONG_ARC = (0.06, 0.94, 0.12, 0.88, 0.2, 0.8, 0.28, 0.72, 0.36, 0.64)
_SHIFTS = tuple(shift * pi / 24 for shift in (0, 2, -2))


def add_radii(
    layout: Layout, at: Mapping[str, Vector], found: tuple[Rim, ...], hints: Iterable[Radius]
) -> Layout:
    """The layout with the radii of circles, first those of small ones, which have the least room.

    Raises TemplateError when no circle of the mechanism has one of those centres.
    """
    pairs = [
        (find_marked_rim(found, hint, at[hint.through] if hint.through else None), hint)
        for hint in hints
    ]
    for rim, hint in sorted(pairs, key=lambda pair: pair[0].radius >= _SMALL_RADIUS):
        layout = _add_radius(layout, at, found, rim, hint.symbol)
    return layout


def _add_radius(
    layout: Layout, at: Mapping[str, Vector], found: tuple[Rim, ...], rim: Rim, symbol: str
) -> Layout:
    """The layout with the radius of a circle: for a cam to the contact, for other circles wherever
    there is room, beside other wheels, at an angle to the lines that are drawn from the centre, and
    not across the arc of an angle there.
    """
    lines = _list_lines_from(rim.at, layout.obstacles)
    arcs = [each for each in layout.lines if isinstance(each, Bow) and each.pen == THIN]
    sectors = [arc for arc in arcs if length(arc.centre - rim.at) < NEAR]
    marks: list[RadiusFromCentre | RadiusFromOutside] = []
    for angle in _list_angles(rim):
        toward, outside = _seat_in_tooth(rim, angle), _seat_in_gap(rim, angle)
        leaning = _LEANING * any(toward.dot(line) > _LEAST_ANGLE for line in lines)
        inward = partial(RadiusFromOutside, rim.at, rim.radius, outside, symbol)
        foreign = _FOREIGN * _starts_at_another(rim, outside, found)
        if rim.radius < _SMALL_RADIUS:
            spanning = _SPANNING * _spans_ring(rim, found)
            marks.append(inward(leaning + spanning + foreign, rim.kind == "gear"))
            if not spanning:
                continue
        demerit = leaning + _WITHIN_ANGLE * any(_lies_within(angle, arc) for arc in sectors)
        demerit += _PROLONGING * any(toward.dot(line) < _STRAIGHT for line in lines)
        demerit += _BESIDE_BAR * _ends_beside_bar(rim, toward, layout.obstacles)
        marks.append(_draw_from_centre(rim, found, at.values(), symbol, (toward, demerit)))
        large = rim.radius >= _SMALL_RADIUS
        if large and not rim.ring and rim.kind != "cam" and rim.find_arc() is None:
            marks.append(inward(leaning + _INWARD + foreign, rim.kind == "gear"))
    rated = zip(marks, rate_crossings(marks, layout), strict=True)
    return layout.marked([replace(mark, demerit=mark.demerit + worse) for mark, worse in rated])


def _spans_ring(rim: Rim, found: Iterable[Rim]) -> bool:
    """Whether an arrow from outside would go from a larger circle about the same centre to this
    one, as if their distance were meant, or its head would fill the ring between them.
    """
    outer = (other.radius for other in found if length(other.at - rim.at) < NEAR)
    rings = [radius - rim.radius for radius in outer if radius > rim.radius + NEAR]
    return any(abs(ring - FROM_OUTSIDE) < _AT_OUTER or ring < _NARROW for ring in rings)


def _starts_at_another(rim: Rim, toward: Vector, found: Iterable[Rim]) -> bool:
    """Whether an arrow from outside would start at another wheel, as if it were its radius."""
    tail = rim.at + toward * (rim.radius + FROM_OUTSIDE)
    others = (other for other in found if not other.ring and length(other.at - rim.at) > NEAR)
    return any(length(tail - other.at) < other.radius + _AT_ANOTHER for other in others)


def _list_angles(rim: Rim) -> list[float]:
    """The directions that the arrow of a circle may have, the preferred ones first."""
    match rim.kind:
        case "cam":
            return [angle_of(rim.touch - rim.at)]
        case "wheel" | "gear" | "slot" | "edge":
            arc = rim.find_arc()
            if arc:
                return [arc[0] + share * arc[1] for share in _ALONG_ARC]
            return [turn + shift for shift in _SHIFTS for turn in _PREFERRED]
        case _:
            assert_never(rim.kind)


def _seat_in_tooth(rim: Rim, angle: float) -> Vector:
    """The direction of an arrow from the centre near an angle, whose head crosses no flank of a
    gear: in the middle of a tooth; of a ring, between two of its teeth.
    """
    return _seat(rim, angle, 0.5 if rim.ring else 0.0)


def _seat_in_gap(rim: Rim, angle: float) -> Vector:
    """The direction of an arrow from outside near an angle, whose head crosses no flank."""
    return _seat(rim, angle, 0.5)


def _seat(rim: Rim, angle: float, share: float) -> Vector:
    """The direction nearest to an angle at a share of the pitch from a gear's tooth; of other
    circles the angle itself.
    """
    match rim.kind:
        case "gear":
            step = find_tooth_angle(rim.radius)
            first = angle_of(rim.tooth - rim.at) + share * step
            return polar(first + round((angle - first) / step) * step)
        case "wheel" | "slot" | "cam" | "edge":
            return polar(angle)
        case _:
            assert_never(rim.kind)


def _draw_from_centre(
    rim: Rim,
    found: Iterable[Rim],
    points: Iterable[Vector],
    symbol: str,
    rated: tuple[Vector, float],
) -> RadiusFromCentre:
    """The arrow in a direction, whose demerit grows where it meets points and other circles."""
    toward, demerit = rated
    tip = rim.at + toward * rim.radius
    hides = any(length(point - tip) < 2 * HEAD_LENGTH for point in points)
    others = tuple(other for other in found if length(other.at - rim.at) > NEAR)
    fixed = rim.body == GROUND and rim.kind != "gear"
    rough, hatched = rim.kind == "gear" or fixed, fixed and rim.kind != "edge" and not rim.ring
    strokes = list_round_hatching(rim.at, rim.radius, outward=False, arc=rim.find_arc())
    hatching = tuple(strokes) if hatched else ()
    arrow = RadiusFromCentre(rim.at, rim.radius, toward, symbol, demerit, others, rough, hatching)
    arrow = replace(arrow, hatched_arc=bool(hatching and rim.find_arc()))
    return replace(arrow, demerit=demerit + _AT_POINT * hides + arrow.rate_meetings())


def _ends_beside_bar(rim: Rim, toward: Vector, drawn: Obstacles) -> bool:
    """Whether a bar passes just beyond the tip of an arrow, which would seem to end on that."""
    tip = rim.at + toward * rim.radius
    beyond = (tip, tip + toward * _WEDGE)
    return Obstacles(drawn.lines, ()).along((beyond,), shared=False) >= COST_BOLD


def _lies_within(angle: float, arc: Bow) -> bool:
    """Whether a direction (radians) lies between the sides of an angle, by its arc."""
    turned = angle - arc.start if arc.sweep > 0 else arc.start - angle
    return turned % (2 * pi) < abs(arc.sweep)


def _list_lines_from(centre: Vector, drawn: Obstacles) -> list[Vector]:
    """The directions in which lines lead from a centre, or from within a millimetre of it, far
    enough to be seen beside an arrow.
    """
    (x, y), found = centre, []
    about = (x - _PAST, y - _PAST, x + _PAST, y + _PAST)
    for _, _, _, _, (start_x, start_y, dx, dy, *_) in drawn.near(about).lines:
        start, end = Vector(start_x, start_y), Vector(start_x + dx, start_y + dy)
        if length(nearest_of(centre, start, end) - centre) < _PAST:
            found += [other - centre for other in (start, end)]
    return [unit(line) for line in found if length(line) > _SEEN]


def find_marked_rim(found: tuple[Rim, ...], hint: Radius, through: Vector | None) -> Rim:
    """The circle that a hint means; circles that joints have come before edges.

    Raises TemplateError where there is none, or where several have different radii.
    """
    meant = [rim for rim in found if _is_meant(rim, hint, through)]
    jointed = [rim for rim in meant if rim.kind != "edge"] or meant
    if not jointed:
        near = suggest(hint.centre, {rim.centre for rim in found})
        what = Message("figure.no-such-circle", circle=_describe_circle(hint), hint=near)
        raise TemplateError(Fault("figure.radii", what))
    first, *others = jointed
    if any(abs(rim.radius - first.radius) > NEAR * (1 + first.radius) for rim in others):
        symbol, centre = Quoted(hint.symbol), Quoted(hint.centre)
        what = Message("figure.several-circles", symbol=symbol, centre=centre)
        by_body = hint.of is None and _tell_apart(jointed)
        do = Message("figure.name-circle" if by_body else "figure.name-circle-through")
        raise TemplateError(Fault("figure.radii", what, do=do))
    return first


def _tell_apart(rims: Sequence[Rim]) -> bool:
    """Whether the circles of some body are all alike, so that to name it is enough."""
    radii = {rim.body: [each.radius for each in rims if each.body == rim.body] for rim in rims}
    return any(max(each) - min(each) <= NEAR * (1 + max(each)) for each in radii.values())


def _is_meant(rim: Rim, hint: Radius, through: Vector | None) -> bool:
    if rim.centre != hint.centre or hint.of not in (None, rim.body):
        return False
    return through is None or abs(length(through - rim.at) - rim.radius) < NEAR * (1 + rim.radius)


def _describe_circle(hint: Radius) -> Message:
    centre = Quoted(hint.centre)
    match hint:
        case Radius(of=str() as body, through=str() as point):
            return Message(
                "figure.circle-of-through", body=Quoted(body), point=Quoted(point), centre=centre
            )
        case Radius(of=str() as body):
            return Message("figure.circle-of", body=Quoted(body), centre=centre)
        case Radius(through=str() as point):
            return Message("figure.circle-through", point=Quoted(point), centre=centre)
        case _:
            return Message("figure.circle-about", centre=centre)
