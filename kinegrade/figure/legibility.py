"""Whether a figure can be read as it is printed: everything on paper, no symbol crowded or nearer
to something else than to its own line, no part too small to be seen.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import combinations
from math import hypot
from operator import attrgetter

from kinegrade.figure.marks.lengths.measured_direction import find_measured_direction
from kinegrade.figure.mechanism.fitting import HEIGHT, WIDTH, measure_span
from kinegrade.figure.mechanism.view import crop_to_view
from kinegrade.figure.sketch import Sketcher, sketch
from kinegrade.language.message import Message
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.shapes import Circle
from kinegrade.problem.template.hints import FigureHints

SMALLEST = 4.0  # millimetres on paper of a crank, an eccentricity, the radius of a wheel
_LEAST = f"{SMALLEST:g}"  # as refusals say it
_NOTHING = 1e-6  # metres: points nearer than this are one


def find_illegible(
    mechanism: Mechanism, hints: FigureHints, sketcher: Sketcher = sketch
) -> Message | None:
    """Why the figure that `sketcher` draws of a mechanism (floats, metres) cannot be read well;
    None where it can.

    Nothing is drawn where a part would be too small even if the mechanism filled the paper. Raises
    TemplateError as `sketch` does.
    """
    parts = [part for part in _list_parts(mechanism, hints) if part.size > _NOTHING]
    smallest = min(parts, key=attrgetter("size"), default=None)
    width, height = measure_span(crop_to_view(mechanism, hints), hints)
    for room, span in ((WIDTH, width), (HEIGHT, height)):
        if smallest and smallest.size * room < SMALLEST * span:
            return smallest.refusal
    scene = sketcher(mechanism, hints)
    if scene.width > WIDTH or scene.height > HEIGHT:
        return Message("figure.too-large", width=f"{WIDTH:g}", height=f"{HEIGHT:g}")
    if smallest and smallest.size * scene.scale < SMALLEST:
        return smallest.refusal
    for symbol in (*scene.crowded, *scene.claimed):
        return Message("figure.symbol-crowded", symbol=symbol)
    return None


@dataclass(frozen=True)
class _Part:
    """The size in metres of what is drawn, and what is said of it where that is too small."""

    size: float
    refusal: Message


def _list_parts(mechanism: Mechanism, hints: FigureHints) -> Iterator[_Part]:
    """The distances between points of one body and of the ends of lengths with a symbol, and the
    radii.
    """
    at = mechanism.points
    marked = {frozenset((each.start, each.end)): each.symbol for each in hints.lengths}
    for body in mechanism.bodies:
        for start, end in combinations(body.points, 2):
            symbol = marked.get(frozenset((start, end)), "")
            yield _make_distance(hypot(*(at[start] - at[end])), start, end, symbol)
    for given in hints.lengths:
        tail, tip = at[given.start], at[given.end]
        along = find_measured_direction(given.along, tail, tip)
        size = abs((tip - tail).dot(along))
        yield _make_distance(size, given.start, given.end, given.symbol)
    for joint in mechanism.joints:
        for circle in joint.list_circles():
            symbol = _find_symbol(circle, mechanism, hints)
            kind = "named-radius" if symbol else "radius"
            parts = {"symbol": symbol} if symbol else {}
            yield _Part(
                circle.radius,
                Message(f"figure.{kind}-too-small", centre=circle.centre, least=_LEAST, **parts),
            )


def _find_symbol(circle: Circle, mechanism: Mechanism, hints: FigureHints) -> str:
    """The symbol of the mark at a radius; none where there is none, or it may be at another."""
    at, others = (
        mechanism.points,
        {
            each.radius
            for joint in mechanism.joints
            for each in joint.list_circles()
            if each.centre == circle.centre
        },
    )
    for mark in hints.radii:
        if mark.centre == circle.centre:
            through = at[mark.through] if mark.through else None
            size = circle.radius if through is None else hypot(*(through - at[mark.centre]))
            if abs(size - circle.radius) < _NOTHING and (through is not None or len(others) == 1):
                return mark.symbol
    return ""


def _make_distance(size: float, start: str, end: str, symbol: str) -> _Part:
    """The distance of two points, with its symbol where it has one."""
    kind = "length" if symbol else "distance"
    parts = {"symbol": symbol} if symbol else {}
    refusal = Message(f"figure.{kind}-too-small", start=start, end=end, least=_LEAST, **parts)
    return _Part(size, refusal)
