"""The straight parts of a body: links, slotted bars, bars in sleeves, faces, plates, rods in ground
guides.

All of this follows from the points of the body and from the lines on which other bodies act.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence, Set
from itertools import pairwise

from msgspec.structs import replace

from kinegrade.figure.joints.symbol import Feature, Rim, Symbol, find_fixed_pin, find_pins
from kinegrade.figure.mechanism.geneva_wheels import find_geneva_wheels
from kinegrade.figure.mechanism.plates import Plate, find_outward_direction, find_plate
from kinegrade.figure.mechanism.slotted_discs import find_slotted_disc
from kinegrade.figure.mechanism.straight.laid_bars import group_by_line, lay_arms, lay_bar
from kinegrade.figure.mechanism.straight.racks import find_racks
from kinegrade.figure.mechanism.straight.resting_faces import rest_faces
from kinegrade.figure.mechanism.straight.rods import find_rods
from kinegrade.figure.mechanism.straight.welded_rods import weld_rods
from kinegrade.figure.mechanism.straight_parts import (
    Bar,
    GenevaWheel,
    Part,
    SlottedDisc,
    find_guided_rack,
)
from kinegrade.figure.mechanism.wheels.arms import find_arms
from kinegrade.figure.plane import NEAR, collinear, length, mean, on_line, unit
from kinegrade.mechanics.mechanism import Body, Mechanism
from kinegrade.mechanics.vector import Vector


def find_straight_parts(
    mechanism: Mechanism,
    shapes: Mapping[str, str],
    symbols: Sequence[Symbol],
    found: Sequence[Rim],
) -> tuple[Part, ...]:
    """The straight parts of every body; those of a disc, wheel or gear lead to what is outside
    it.
    """
    round_ones = {rim.body for rim in found}
    ropes = {symbol.hanging.body for symbol in symbols if symbol.hanging}
    features = [feature for symbol in symbols for feature in symbol.features]
    parts: list[Part] = [
        *find_geneva_wheels(mechanism, symbols, shapes),
        *find_arms(mechanism, shapes, symbols, found),
    ]
    wheels = {part.body for part in parts if isinstance(part, GenevaWheel)}
    for body in mechanism.bodies:
        if body.name not in round_ones | ropes | wheels and not body.particle:
            parts += _find_parts(mechanism, body, symbols, shapes)
    pins = find_pins(mechanism, symbols)
    parts = [_round_off(part, pins, features) for part in parts]
    parts = [
        _shape_jaw(part, mechanism, symbols)
        if isinstance(part, Bar) and shapes.get(part.body) == "jaw"
        else part
        for part in parts
    ]
    parts = [*_tell_apart(parts, symbols), *find_racks(mechanism, shapes, symbols)]
    bars = [part for part in parts if isinstance(part, Bar)]
    rods = tuple(find_rods(mechanism, shapes, symbols, found, bars))
    return rest_faces(weld_rods(parts, rods))


def _find_parts(
    mechanism: Mechanism, body: Body, symbols: Sequence[Symbol], shapes: Mapping[str, str]
) -> Iterator[Bar | Plate | SlottedDisc]:
    features = [each for symbol in symbols for each in symbol.features if each.body == body.name]
    points = [mechanism.points[name] for name in body.points]
    plate = find_plate(body, points, shapes)
    on_axis: list[set[Vector]] = []
    for group in group_by_line(feature for feature in features if not _is_edge(feature, plate)):
        disc = find_slotted_disc(mechanism, body, group, symbols, shapes)
        if disc:
            yield disc
            continue
        on_axis.append({point for point in points if on_line(point, group[0].line)})
        arms = list(lay_arms(body.name, points, group))
        yield lay_bar(body.name, [*points, *(arm.start for arm in arms)], group)
        yield from arms
    if not any(set(points) <= covered for covered in on_axis):
        yield from [plate] if plate else _find_links(body.name, points, shapes)


def _round_off(part: Part, pins: Set[Vector], features: Sequence[Feature]) -> Part:
    """A plate whose corners all are pins, and on whose edges nothing acts, is round about them."""
    if isinstance(part, Plate) and set(part.corners) <= pins:
        acted = any(edge.body == part.body and _is_edge(edge, part) for edge in features)
        return replace(part, rounded=not acted)
    return part


def _tell_apart(parts: Sequence[Part], symbols: Sequence[Symbol]) -> list[Part]:
    """The parts, of which a rack that slides in a guide has no eyes, as nothing is pinned to it,
    and a slotted bar in front of a disc is white.
    """
    sliding = [find_guided_rack(symbol.guide, parts) for symbol in symbols if symbol.guide]
    parts = [
        replace(part, free=(part.start, part.end))
        if isinstance(part, Bar) and part in sliding
        else part
        for part in parts
    ]
    discs = [part for part in parts if isinstance(part, SlottedDisc)]
    return [
        replace(part, fill="white") if isinstance(part, Bar) and _is_in_front(part, discs) else part
        for part in parts
    ]


def _is_in_front(bar: Bar, discs: Sequence[SlottedDisc]) -> bool:
    """Whether a slotted bar would not be told from a disc behind it."""
    return bar.use == "slot" and any(
        length(bar.start - disc.centre) < disc.radius for disc in discs
    )


def _is_edge(feature: Feature, plate: Plate | None) -> bool:
    """Whether a feature is the edge of a plate, which is drawn with the plate."""
    return (
        plate is not None
        and feature.use in ("bar", "face")
        and find_outward_direction(plate, feature.line) is not None
    )


def _find_links(body: str, points: list[Vector], shapes: Mapping[str, str]) -> Iterator[Bar]:
    if len(points) < 2:
        return
    if shapes.get(body) == "bent":
        yield from (Bar(body, start, end) for start, end in pairwise(points))
    elif collinear(points):
        along = max((point - points[0] for point in points), key=length)
        ordered = sorted(points, key=along.dot)
        yield Bar(body, ordered[0], ordered[-1])


def _shape_jaw(bar: Bar, mechanism: Mechanism, symbols: Sequence[Symbol]) -> Bar:
    """A bar as the jaw of a crusher: from its fixed pin on, with its back to what moves it."""
    pin = find_fixed_pin(symbols, bar.body)
    start, end = bar.start, bar.end
    if pin is not None and length(mechanism.points[pin] - end) < NEAR:
        start, end = end, start
    across = unit(end - start).turned()
    rest = mean(mechanism.points.values()) - start
    back = across if rest.dot(across) > 0 else -across
    return replace(bar, start=start, end=end, use="jaw", back=back)
