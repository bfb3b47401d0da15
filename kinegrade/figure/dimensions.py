"""Dimensions, angles and radii: thin marks with a symbol, each in several ways to choose from."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from math import pi

from kinegrade.errors import TemplateError, did_you_mean
from kinegrade.figure.bars import Bar
from kinegrade.figure.layers import Drawing
from kinegrade.figure.mark import Mark, along_bow, direction, sampled
from kinegrade.figure.place import Wish, around, beside
from kinegrade.figure.plane import angle_of, length, on_line, polar, shorter_way, unit
from kinegrade.figure.rims import Rim
from kinegrade.figure.scene import THIN, Bow, Primitive, Strokes
from kinegrade.figure.symbols import HEAD_LENGTH, PIN, arrowhead
from kinegrade.mechanics.joints import Line
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.hints import Angle, Length, Radius

SMALLEST_ANGLE = pi / 180  # an angle below one degree shows no arc
SMALL_RADIUS = 8.0  # millimetres: a smaller circle has its radius marked from outside


def length_marks(at: Mapping[str, Vector], hint: Length) -> list[Mark]:
    start, end = at[hint.start], at[hint.end]
    measured = {"horizontal": Vector(1.0, 0.0), "vertical": Vector(0.0, 1.0)}.get(
        hint.along or "", unit(end - start)
    )
    across = measured.turned()
    found = []
    for offset in (5.5, -5.5, 8.0, -8.0, 10.5, -10.5, 13.0, -13.0, 16.0, -16.0):
        level = (
            max(across.dot(start), across.dot(end)) if offset > 0 else min(across.dot(start), across.dot(end))
        )
        feet = [point + across * (level + offset - across.dot(point)) for point in (start, end)]
        found.append(_dimension((start, end), (feet[0], feet[1]), hint.symbol, 0.3 * abs(offset)))
    return found


def _dimension(
    points: tuple[Vector, Vector], feet: tuple[Vector, Vector], symbol: str, demerit: float
) -> Mark:
    """Extension lines from the points to their feet, and the dimension line between the feet."""
    extensions = []
    for point, end in zip(points, feet, strict=True):
        away = unit(end - point)
        if length(end - point) > 2.5:
            extensions.append((point + away * 1.6, end + away * 1.2))
    along = unit(feet[1] - feet[0])
    room = length(feet[1] - feet[0])
    outside = room < 2 * HEAD_LENGTH + 1.5
    tails = 3.0 if outside else 0.0
    line = (feet[0] - along * tails, feet[1] + along * tails)
    inward = 1.0 if outside else -1.0
    heads = (arrowhead(feet[0], along * inward), arrowhead(feet[1], along * -inward))
    path = (*sampled(*line), *(point for extension in extensions for point in sampled(*extension)))
    return Mark(
        (Strokes((*extensions, line), THIN), *heads), path, Wish(symbol, beside(symbol, *line)), demerit
    )


def angle_marks(at: Mapping[str, Vector], hint: Angle, drawing: Drawing) -> Iterator[list[Mark]]:
    """Arcs of several radii; nothing when the angle is too small to be seen."""
    vertex = at[hint.at]
    start, end = (angle_of(direction(at, vertex, name)) for name in (hint.start, hint.end))
    sweep = shorter_way(end - start)
    if hint.sense is not None and abs(sweep) > SMALLEST_ANGLE:
        sweep = sweep % (2 * pi) if hint.sense == "ccw" else -((-sweep) % (2 * pi))
    legs = [
        (angle, length(at[name] - vertex) if name in at else 0.0)
        for angle, name in ((start, hint.start), (end, hint.end))
        if name not in at or not _on_one_bar(vertex, at[name], drawing)
    ]
    if abs(sweep) > SMALLEST_ANGLE:
        yield [_arc(vertex, radius, (start, sweep), legs, hint) for radius in (7.0, 8.5, 10.0, 5.5, 12.0)]


def _on_one_bar(one: Vector, other: Vector, drawing: Drawing) -> bool:
    """Whether a bar is drawn through both points, so that no thin line is needed between them."""
    axes = [Line(part.start, part.end - part.start) for part in drawing.parts if isinstance(part, Bar)]
    return any(on_line(one, axis) and on_line(other, axis) for axis in axes)


def _arc(
    vertex: Vector, radius: float, span: tuple[float, float], legs: list[tuple[float, float]], hint: Angle
) -> Mark:
    start, sweep = span
    bow = Bow(vertex, radius, start, sweep, THIN)
    references = tuple(
        (
            vertex + polar(angle, PIN + 0.15),
            vertex + polar(angle, max(reach, radius + 4.0 * (reach == 0.0) + 1.0)),
        )
        for angle, reach in legs
    )
    parts: tuple[Primitive, ...] = (Strokes(references, THIN),) if references else ()
    if hint.sense is not None and abs(sweep) * radius > 2 * HEAD_LENGTH:
        tangent = polar(start + sweep).turned() * (1.0 if sweep > 0 else -1.0)
        parts += (arrowhead(vertex + polar(start + sweep, radius), tangent),)
    wish = Wish(hint.symbol, along_bow(vertex, radius, start, sweep, hint.symbol))
    return Mark((*parts, bow), bow.path(), wish, 0.6 * abs(radius - 7.0))


def _rim_about(found: tuple[Rim, ...], hint: Radius) -> Rim:
    for rim in found:
        if rim.centre == hint.centre and hint.of in (None, rim.body):
            return rim
    of = f" of {hint.of!r}" if hint.of else ""
    centres = {rim.centre for rim in found}
    raise TemplateError(
        f"figure.radii: no circle{of} about {hint.centre!r}; circles come from the joints; "
        f"{did_you_mean(hint.centre, centres)}"
    )


def radius_marks(found: tuple[Rim, ...], hint: Radius) -> list[Mark]:
    """The radius of a circle: for a cam to the contact, for other circles wherever there is room.

    Raises TemplateError when no circle of the mechanism has that centre.
    """
    rim = _rim_about(found, hint)
    if rim.kind == "cam":
        angles = [angle_of(rim.touch - rim.at)]
    else:
        angles = [turn + pi / 24 * shift for shift in (0, 2, -2) for turn in _preferred()]
    way = _small_radius if rim.radius < SMALL_RADIUS else _large_radius
    return [way(rim, polar(angle), hint.symbol) for angle in angles]


def _large_radius(rim: Rim, toward: Vector, symbol: str) -> Mark:
    """An arrow from the centre to the rim."""
    end = rim.at + toward * rim.radius
    line = Strokes(((rim.at + toward * 1.3, end - toward * HEAD_LENGTH * 0.8),), THIN)
    path = sampled(rim.at + toward * 2.0, end - toward * min(3.0, rim.radius / 2))
    return Mark((line, arrowhead(end, toward)), path, Wish(symbol, beside(symbol, rim.at, end)))


def _small_radius(rim: Rim, toward: Vector, symbol: str) -> Mark:
    """An arrow that points at the rim from outside, where there is no room inside."""
    tip, tail = rim.at + toward * rim.radius, rim.at + toward * (rim.radius + 7.0)
    line = Strokes(((tip + toward * HEAD_LENGTH * 0.8, tail),), THIN)
    wish = Wish(symbol, around(symbol, tail, away=toward))
    return Mark((line, arrowhead(tip, -toward)), sampled(tip + toward * 1.2, tail), wish)


def _preferred() -> tuple[float, ...]:
    return tuple(turn * pi for turn in (0.75, 0.25, -0.75, -0.25, 0.5, 1.0, 0.0, -0.5))
