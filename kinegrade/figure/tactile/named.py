"""What has a label on tactile sheets: points, bodies, axes and all that is given."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import assert_never

from kinegrade.figure.marks.names import write_point_symbol
from kinegrade.figure.marks.radii import find_marked_rim
from kinegrade.figure.marks.turning.pivots import find_turning_centre
from kinegrade.figure.mechanism.straight.broad_links import find_frame_place
from kinegrade.figure.mechanism.straight_parts import Bar, Rod, SlottedDisc
from kinegrade.figure.scene import Box
from kinegrade.figure.tactile.givens import (
    list_angle_ways,
    list_axes_ways,
    list_length_ways,
    list_moving_ways,
    list_radius_ways,
    list_right_angle_ways,
    list_turning_ways,
)
from kinegrade.figure.tactile.labels import (
    AngleName,
    AxesNames,
    BodyLabel,
    LengthName,
    MovingName,
    Named,
    PointName,
    RadiusName,
    TurningName,
)
from kinegrade.figure.tactile.letters import list_led_ways, list_letter_ways
from kinegrade.figure.tactile.parts import Skeleton
from kinegrade.figure.tactile.piece import Piece
from kinegrade.figure.tactile.sizes import EDGE_OF_PAGE
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import Angle, Axes, Moving, Turning

_IN_CORNER = 16.0  # millimetres from the margin to axes that stand aside
_SHARES = (0.5, 0.35, 0.65)  # of a bar, where the line to its name begins
Cells = Callable[[str], str]  # the Braille of a symbol


def list_letters(skeleton: Skeleton, cells: Cells) -> Iterator[Named]:
    """The letters of points."""
    for name, at in skeleton.list_named():
        symbol = skeleton.anatomy.hints.labels.get(name, write_point_symbol(name))
        if symbol:
            written = cells(symbol)
            ways = tuple(list_letter_ways(written, at, skeleton.draw_dot(at).radius))
            yield Named(PointName(symbol), Piece(ways, (written,), (at,), is_mark=True))


def list_body_names(skeleton: Skeleton, cells: Cells) -> Iterator[Named]:
    """The names of bodies, each led to its circle or its bar."""
    points = skeleton.anatomy.mechanism.points
    for body, symbol in skeleton.anatomy.hints.labels.items():
        if symbol and body not in points:
            written = cells(symbol)
            ends = list(_list_places(skeleton, body))
            ways = tuple(way for at in ends for way in list_led_ways(written, at))
            yield Named(BodyLabel(body, symbol), Piece(ways, (written,), is_mark=True))


def _list_places(skeleton: Skeleton, body: str) -> Iterator[Vector]:
    """Where the line to a name may begin: on the rim of a circle, or along a bar."""
    anatomy = skeleton.anatomy
    for rim in anatomy.rims:
        if rim.body == body:
            for toward in (Vector(0.6, 0.8), Vector(-0.6, 0.8), Vector(0.6, -0.8)):
                yield rim.at + toward * rim.radius
    for part in anatomy.parts:
        if isinstance(part, SlottedDisc) and part.body == body:
            yield part.centre + Vector(0.6, 0.8) * part.radius
        if isinstance(part, Bar | Rod) and part.body == body:
            yield from (part.start + (part.end - part.start) * share for share in _SHARES)


def list_given_pieces(skeleton: Skeleton, page: Box, cells: Cells) -> Iterator[Named]:
    """All that is given, in the order in which the author names it."""
    hints, at = skeleton.anatomy.hints, skeleton.anatomy.mechanism.points
    for given in hints.lengths:
        ends = (at[given.start], at[given.end])
        label = cells(given.symbol)
        ways = tuple(list_length_ways(at, given, label))
        name = LengthName(given.symbol, given.start, given.end, given.along)
        yield Named(name, Piece(ways, (label,), ends, is_mark=True))
    for angle in hints.angles:
        label = cells(angle.symbol)
        ways = tuple(list_angle_ways(at, angle, label))
        corner = AngleName(angle.symbol, angle.at)
        yield Named(corner, Piece(ways, (label,), _list_corners(at, angle), is_mark=True))
    for radius in hints.radii:
        through = at[radius.through] if radius.through else None
        rim = find_marked_rim(skeleton.anatomy.rims, radius, through)
        label = cells(radius.symbol)
        circle = RadiusName(radius.symbol, radius.centre)
        yield Named(
            circle, Piece(tuple(list_radius_ways(rim, label)), (label,), (rim.at,), is_mark=True)
        )
    for arrow in hints.arrows:
        yield _make_arrow(skeleton, arrow, cells(arrow.symbol))
    yield from _list_axes(skeleton, page, cells)


def list_right_angles(skeleton: Skeleton) -> Iterator[Piece]:
    """The marks of right angles, which have no label."""
    at = skeleton.anatomy.mechanism.points
    for points in skeleton.anatomy.hints.right_angles:
        yield Piece(tuple(list_right_angle_ways(at, points)), at=(at[points[1]],), is_mark=True)


def _list_corners(at: Mapping[str, Vector], angle: Angle) -> tuple[Vector, ...]:
    """The vertex of an angle and the points towards which its legs go."""
    return tuple(at[name] for name in (angle.at, angle.start, angle.end) if name in at)


def _make_arrow(skeleton: Skeleton, arrow: Turning | Moving, label: str) -> Named:
    mechanism = skeleton.anatomy.mechanism
    name: TurningName | MovingName
    match arrow:
        case Turning():
            name = TurningName(arrow.symbol, arrow.level)
            at = find_turning_centre(mechanism, arrow, skeleton.drawing)
            ways = tuple(list_turning_ways(skeleton, arrow, label))
        case Moving():
            name = MovingName(arrow.symbol, arrow.point, arrow.level)
            at = mechanism.points[arrow.point]
            ways = tuple(list_moving_ways(skeleton, arrow, label))
        case _:
            assert_never(arrow)
    return Named(name, Piece(ways, (label,), (at,), is_mark=True))


def _list_axes(skeleton: Skeleton, page: Box, cells: Cells) -> Iterator[Named]:
    hints, at = skeleton.anatomy.hints, skeleton.anatomy.mechanism.points
    for frame in hints.frames:
        labels = (cells(frame.x), cells(frame.y))
        ways = tuple(list_axes_ways([find_frame_place(at, frame)], labels))
        yield Named(
            AxesNames(frame.x, frame.y, frame), Piece(ways, labels, (at[frame.at],), is_mark=True)
        )
    if hints.axes is not None:
        labels = (cells("x"), cells("y"))
        origins = _list_origins(page, hints.axes)
        yield Named(
            AxesNames("x", "y"), Piece(tuple(list_axes_ways(origins, labels)), labels, is_mark=True)
        )


def _list_origins(page: Box, place: Axes) -> Sequence[tuple[Vector, Vector]]:
    """Where the axes may stand: at the origin, or in a corner of the page."""
    right = Vector(1.0, 0.0)
    match place:
        case "origin":
            return [(Vector(0.0, 0.0), right)]
        case "aside":
            return [(corner, right) for corner in _list_page_corners(page)]
        case _:
            assert_never(place)


def _list_page_corners(page: Box) -> list[Vector]:
    margin = EDGE_OF_PAGE + _IN_CORNER
    return [
        Vector(page.left + margin, page.bottom + margin),
        Vector(page.right - 3 * margin, page.bottom + margin),
        Vector(page.right - 3 * margin, page.top - 3 * margin),
        Vector(page.left + margin, page.top - 3 * margin),
    ]
