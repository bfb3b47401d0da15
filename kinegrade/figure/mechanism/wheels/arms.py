"""Arms of round bodies: the bars from a wheel, gear or cam to the points of its body outside it,
and the necks that tell that they are rigid with it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise

from msgspec import Struct

from kinegrade.figure.joints.symbol import Feature, Rim, Symbol, find_fixed_pin
from kinegrade.figure.mechanism.straight.laid_bars import group_by_line, lay_bar
from kinegrade.figure.mechanism.straight_parts import Bar, Part, is_slender
from kinegrade.figure.mechanism.wheels.outlines import find_outer_radius, trace_outlines
from kinegrade.figure.plane import length, nearest_of, on_line, unit
from kinegrade.mechanics.joints import GROUND, Line
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector

_ON_RIM = 0.2  # millimetres, half the line of a rim, up to which a point beyond it lies on it
# Millimetres of a bar along its neck, and the share of what is outside at most
_NECK, _SHARE = 5.0, 0.6
# Millimetres: half the width of a neck at the wheel and at its end, and how far it begins within
_HALF_FOOT, _HALF_END, _WITHIN = 2.2, 0.3, 2.6
_Outline = tuple[Vector, ...]


class Wheel(Struct, frozen=True):
    """A moving body that is round: where its bars begin, how far from there, and its outlines
    (convex, counter-clockwise), that about its largest circle first.
    """

    body: str
    hub: Vector
    hollow: float
    outlines: tuple[_Outline, ...]

    def covers(self, at: Vector) -> bool:
        """Whether a point lies within an outline or on it."""
        return any(_holds(outline, at) for outline in self.outlines)


class Neck(Struct, frozen=True):
    """What a bar of a wheel is welded to it with: a plate that reaches out from under the wheel."""

    body: str
    corners: _Outline


def find_wheels(
    mechanism: Mechanism, shapes: Mapping[str, str], symbols: Sequence[Symbol], rims: Sequence[Rim]
) -> Iterator[Wheel]:
    """The moving bodies that have circles and may reach out of these."""
    for body in dict.fromkeys(rim.body for rim in rims if rim.body != GROUND):
        own = sorted((rim for rim in rims if rim.body == body), key=lambda rim: -rim.radius)
        points = [mechanism.points[name] for name in mechanism.body(body).points]
        actions = [each.action for each in _list_features(body, shapes, symbols)]
        if _reaches_out(own, [*points, *actions]):
            outlines = tuple(trace_outlines(mechanism, shapes, symbols, own))
            largest, pin = own[0], find_fixed_pin(symbols, body)
            if largest.ring or largest.kind == "slot":
                yield Wheel(body, largest.at, find_outer_radius(largest), outlines)
            else:
                pivot = mechanism.points[pin] if pin else largest.at
                within = any(_holds(outline, pivot) for outline in outlines)
                yield Wheel(body, pivot if within else largest.at, 0.0, outlines)


def _reaches_out(own: Sequence[Rim], points: Sequence[Vector]) -> bool:
    """Whether a point is outside the largest circle, or a further circle has its centre there; as
    most wheels have neither, their outlines need not be traced.
    """
    reach = find_outer_radius(own[0]) + _ON_RIM
    places = [*points, *(rim.at for rim in own)]
    return any(length(at - own[0].at) > reach for at in places)


def find_arms(
    mechanism: Mechanism, shapes: Mapping[str, str], symbols: Sequence[Symbol], rims: Sequence[Rim]
) -> Iterator[Bar]:
    """The bars from each wheel to its points and its further circles outside it; those of a bent
    rod lead through its points in order.
    """
    for wheel in find_wheels(mechanism, shapes, symbols, rims):
        points = [mechanism.points[name] for name in mechanism.body(wheel.body).points]
        if shapes.get(wheel.body) == "bent":
            yield from (
                Bar(wheel.body, start, end)
                for start, end in pairwise(points)
                if not (wheel.covers(start) and wheel.covers(end))
            )
        else:
            laid = list(_lay_bars(wheel, points, _list_features(wheel.body, shapes, symbols)))
            yield from laid
            centres = [rim.at for rim in rims if rim.body == wheel.body]
            apart = [at for at in centres if not _holds(wheel.outlines[0], at)]
            outside = [*(at for at in points if not wheel.covers(at)), *apart]
            axes = [Line(bar.start, bar.end - bar.start) for bar in laid]
            reached = [axis for axis in axes if on_line(wheel.hub, axis)]
            yield from _reach_out(
                wheel, [at for at in outside if not any(on_line(at, axis) for axis in reached)]
            )


def _list_features(
    body: str, shapes: Mapping[str, str], symbols: Sequence[Symbol]
) -> list[Feature]:
    """The lines of a body on which others act, but for the flanks of a cam."""
    if shapes.get(body) == "cam":
        return []
    features = (feature for symbol in symbols for feature in symbol.features)
    return [feature for feature in features if feature.body == body]


def _lay_bars(wheel: Wheel, points: Sequence[Vector], features: Sequence[Feature]) -> Iterator[Bar]:
    """The bars on which others slide or rest outside the wheel, from its hub where they lead to
    it.
    """
    ends = points if wheel.hollow else [wheel.hub, *points]
    for group in group_by_line(features):
        if not all(wheel.covers(feature.action) for feature in group):
            yield lay_bar(wheel.body, ends, group)


def find_necks(wheels: Sequence[Wheel], parts: Sequence[Part]) -> Iterator[Neck]:
    """The necks of the slender bars that leave wheels; through a slot one would be seen."""
    for wheel in wheels:
        for bar in parts:
            if is_slender(bar) and bar.body == wheel.body:
                inner = nearest_of(wheel.hub, bar.start, bar.end)
                for end in (bar.start, bar.end):
                    if wheel.covers(inner) and not wheel.covers(end):
                        yield Neck(wheel.body, _trace_neck(wheel, inner, end))


def _reach_out(wheel: Wheel, targets: Sequence[Vector]) -> Iterator[Bar]:
    """One bar for each line through the hub; two where its middle is hollow."""
    seen: list[Line] = []
    for target in targets:
        line = Line(wheel.hub, unit(target - wheel.hub))
        if any(on_line(target, other) for other in seen):
            continue
        seen.append(line)
        steps = [(at - line.point).dot(line.direction) for at in targets if on_line(at, line)]
        low, high = min(steps), max(steps)
        places = [(low, high)] if low < 0 < high else [(0.0, low if low < 0 else high)]
        if wheel.hollow:
            edge = wheel.hollow
            places = [(edge, high)] * (high > 0) + [(-edge, low)] * (low < 0)
        for start, end in places:
            first, last = (line.point + line.direction * step for step in (start, end))
            yield Bar(wheel.body, first, last)


def _trace_neck(wheel: Wheel, inner: Vector, end: Vector) -> _Outline:
    """From within the outline that a bar leaves last to narrow about the bar."""
    toward = unit(end - inner)
    across = toward.turned()
    ahead = max(
        _find_exit(outline, inner, toward) for outline in wheel.outlines if _holds(outline, inner)
    )
    foot = inner + toward * (ahead - _WITHIN)
    tip = inner + toward * (ahead + min(_NECK, _SHARE * (length(end - inner) - ahead)))
    wide, narrow = across * _HALF_FOOT, across * _HALF_END
    return (foot + wide, tip + narrow, tip - narrow, foot - wide)


def _find_exit(outline: _Outline, inner: Vector, toward: Vector) -> float:
    """How far from a point within an outline a direction leads out of it."""
    ways: list[float] = []
    for start, end in pairwise((*outline, outline[0])):
        edge = unit(end - start)
        leaving = edge.cross(toward)
        if leaving < 0:
            ways.append(edge.cross(start - inner) / leaving)
    return min(ways)


def _holds(outline: _Outline, at: Vector) -> bool:
    """Whether a point lies within a convex outline or on it."""
    return all(
        (end - start).cross(at - start) > -_ON_RIM * length(end - start)
        for start, end in pairwise((*outline, outline[0]))
    )
