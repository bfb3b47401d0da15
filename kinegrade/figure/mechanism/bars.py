"""The straight parts of a body: links, slotted bars, bars in sleeves, faces, plates, rods in ground
guides.

All of this follows from the points of the body and from the lines on which other bodies act.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from itertools import pairwise
from typing import Literal

from kinegrade.figure.mechanism.plates import Plate, find_outward_direction, find_plate
from kinegrade.figure.mechanism.rims import Rim, find_touching_point, is_toothed
from kinegrade.figure.plane import (
    collinear,
    length,
    mean,
    nearest_of,
    on_line,
    same_line,
    unit,
)
from kinegrade.mechanics.joints import (
    GROUND,
    Contact,
    Line,
    Parallel,
    Roll,
    Sleeve,
    Slide,
)
from kinegrade.mechanics.mechanism import Body, Mechanism
from kinegrade.mechanics.vector import Vector

Use = Literal["link", "slot", "bar", "face", "rack"]

_OVERHANG = 8.0  # millimetres a bar continues beyond whatever slides on it
_ROD = 17.0  # millimetres of a translating rod that are shown at least
_NO_BACK = Vector(0.0, 0.0)
_THROUGH = (
    11.0  # millimetres a translating rod continues beyond its point when it has two free ends
)
_GUIDE_ROOM = 5.5  # millimetres between the middle of a rod's guide and any other bar


@dataclass(frozen=True)
class Bar:
    """One straight part; `free` are its ends without a marked point, `actions` the points where
    other bodies slide or rest on it.

    A rack has its pitch line as axis and its material in the direction `back`.
    """

    body: str
    start: Vector
    end: Vector
    use: Use = "link"
    free: tuple[Vector, ...] = ()
    actions: tuple[Vector, ...] = ()
    back: Vector = _NO_BACK


@dataclass(frozen=True)
class SlottedDisc:
    """A body whose slot passes beside its only point, drawn as a disc about that point."""

    body: str
    centre: Vector
    radius: float
    slot: tuple[Vector, Vector]


@dataclass(frozen=True)
class Rod:
    """A body that translates in a straight ground guide near its end; `free` are its ends without a
    marked point.
    """

    body: str
    start: Vector
    end: Vector
    free: tuple[Vector, ...]


@dataclass(frozen=True)
class _Feature:
    body: str
    line: Line
    action: Vector
    use: Use
    back: Vector = _NO_BACK


def find_straight_bodies(
    mechanism: Mechanism, shapes: Mapping[str, str], found: tuple[Rim, ...]
) -> tuple[Bar | Plate | SlottedDisc | Rod, ...]:
    """The straight parts of every body that is not a disc, wheel or gear."""
    round_ones = {rim.body for rim in found}
    features = tuple(_find_features(mechanism, shapes))
    parts = tuple(
        part
        for body in mechanism.bodies
        if body.name not in round_ones and not body.particle
        for part in _find_parts(
            mechanism, body, tuple(f for f in features if f.body == body.name), shapes
        )
    )
    return parts + _find_rods(
        mechanism, shapes, found, tuple(part for part in parts if isinstance(part, Bar))
    )


def tell_bar_from_carrier(mechanism: Mechanism, joint: Sleeve) -> tuple[str, str]:
    """Of two bodies sliding in each other, the bar and the sleeve: the bar is the one with more
    points on the line.
    """
    on_it = [
        sum(on_line(mechanism.points[name], joint.line) for name in _find_names(mechanism, body))
        for body in (joint.body, joint.of)
    ]
    return (
        (joint.of, joint.body)
        if on_it[1] > on_it[0] and joint.of != GROUND
        else (joint.body, joint.of)
    )


def find_sleeve_centre(mechanism: Mechanism, joint: Sleeve) -> Vector:
    """Where a sleeve is drawn: at its carrier's point on the line, else at the bar's."""
    bar, carrier = tell_bar_from_carrier(mechanism, joint)
    for body in (carrier, bar):
        for name in _find_names(mechanism, body):
            if on_line(mechanism.points[name], joint.line):
                return mechanism.points[name]
    return joint.line.point


def find_translating(mechanism: Mechanism) -> dict[str, tuple[Vector, Line]]:
    """The bodies that translate along a straight ground guide, each with its guided point and the
    guide.
    """
    fixed = {
        GROUND,
        *(
            joint.body
            for joint in mechanism.joints
            if isinstance(joint, Parallel) and joint.of == GROUND
        ),
    }
    found: dict[str, tuple[Vector, Line]] = {}
    for joint in mechanism.joints:
        if isinstance(joint, Slide) and joint.of == GROUND and joint.body in fixed:
            found[joint.body] = (mechanism.points[joint.point], joint.line)
        if isinstance(joint, Sleeve) and joint.of == GROUND:
            found[joint.body] = (find_sleeve_centre(mechanism, joint), joint.line)
    return found


def _find_rods(
    mechanism: Mechanism, shapes: Mapping[str, str], found: tuple[Rim, ...], bars: tuple[Bar, ...]
) -> tuple[Rod, ...]:
    """The translating rods, each pointing away from the other bodies and long enough to keep its
    guide clear of the bars.
    """
    parts = []
    for body, (start, line) in find_translating(mechanism).items():
        others = [
            at for name, at in mechanism.points.items() if name not in _find_names(mechanism, body)
        ]
        along = unit(line.direction)
        side = along.dot(mean(others + [rim.at for rim in found]) - start)
        toward = along * (-1.0 if side > 0.01 * _ROD else 1.0)
        reach = next(
            (
                more
                for more in range(0, 20, 2)
                if _stands_clear(start + toward * (_ROD - 5.0 + more), bars)
            ),
            0,
        )
        ends = (start, start + toward * (_ROD + reach))
        if shapes.get(body) == "through":
            ends = (start - toward * _THROUGH, ends[1])
        parts.append(Rod(body, *ends, tuple(end for end in reversed(ends) if end != start)))
    return tuple(parts)


def _stands_clear(guide: Vector, bars: tuple[Bar, ...]) -> bool:
    """Whether a guide about this point is clear of all bars."""
    return all(length(guide - nearest_of(guide, bar.start, bar.end)) > _GUIDE_ROOM for bar in bars)


def _find_names(mechanism: Mechanism, body: str) -> tuple[str, ...]:
    return () if body == GROUND else mechanism.body(body).points


def _find_features(mechanism: Mechanism, shapes: Mapping[str, str]) -> Iterator[_Feature]:
    for joint in mechanism.joints:
        if isinstance(joint, Slide) and joint.of != GROUND:
            use: Use = "bar" if joint.body == GROUND or shapes.get(joint.of) == "bar" else "slot"
            yield _Feature(joint.of, joint.line, mechanism.points[joint.point], use)
        if isinstance(joint, Sleeve):
            bar, carrier = tell_bar_from_carrier(mechanism, joint)
            if carrier != GROUND:
                yield _Feature(bar, joint.line, find_sleeve_centre(mechanism, joint), "bar")
        if isinstance(joint, Contact | Roll) and isinstance(joint.on, Line) and joint.of != GROUND:
            contact = find_touching_point(mechanism, joint)
            back = unit(contact - mechanism.points[joint.circle.centre])
            yield _Feature(
                joint.of, joint.on, contact, "rack" if is_toothed(joint, shapes) else "face", back
            )


def _find_parts(
    mechanism: Mechanism, body: Body, features: tuple[_Feature, ...], shapes: Mapping[str, str]
) -> Iterator[Bar | Plate | SlottedDisc]:
    points = [mechanism.points[name] for name in body.points]
    plate = find_plate(body, points, shapes)
    on_axis: list[set[Vector]] = []
    for group in _group_by_line(feature for feature in features if not _is_edge(feature, plate)):
        if group[0].use == "slot" and len(points) == 1 and not on_line(points[0], group[0].line):
            yield _find_slotted_disc(body.name, points[0], group)
            continue
        on_axis.append({point for point in points if on_line(point, group[0].line)})
        yield _lay_bar(body.name, points, group)
    if not any(set(points) <= covered for covered in on_axis):
        yield from [plate] if plate else _find_links(body.name, points, shapes)


def _is_edge(feature: _Feature, plate: Plate | None) -> bool:
    """Whether a feature is the edge of a plate, which is drawn with the plate."""
    return (
        plate is not None
        and feature.use in ("bar", "face")
        and find_outward_direction(plate, feature.line) is not None
    )


def _group_by_line(features: Iterable[_Feature]) -> list[list[_Feature]]:
    groups: list[list[_Feature]] = []
    for feature in features:
        home = next((group for group in groups if same_line(group[0].line, feature.line)), None)
        if home is None:
            groups.append([feature])
        else:
            home.append(feature)
    return groups


def _lay_bar(body: str, points: list[Vector], group: list[_Feature]) -> Bar:
    """From the outermost point to the outermost action on the line, and beyond the latter."""
    along = unit(group[0].line.direction)
    actions = tuple(feature.action for feature in group)
    stations = [*actions, *(point for point in points if on_line(point, group[0].line))]
    ends = []
    for side in (-1.0, 1.0):
        last = max(stations, key=lambda station: side * station.dot(along))
        acted = any(length(last - action) < 1e-6 for action in actions)
        ends.append(last + along * (side * _OVERHANG) if acted else last)
    free = tuple(end for end in ends if all(length(end - station) > 1e-6 for station in stations))
    return Bar(body, ends[0], ends[1], group[0].use, free, actions, group[0].back)


def _find_slotted_disc(body: str, centre: Vector, group: list[_Feature]) -> SlottedDisc:
    along = unit(group[0].line.direction)
    action = group[0].action
    radius = length(action - centre) + _OVERHANG
    across = (action - centre).dot(along.turned())
    half = (radius**2 - across**2) ** 0.5 - 2.0
    middle = centre + along.turned() * across
    return SlottedDisc(body, centre, radius, (middle - along * half, middle + along * half))


def _find_links(body: str, points: list[Vector], shapes: Mapping[str, str]) -> Iterator[Bar]:
    if len(points) < 2:
        return
    if shapes.get(body) == "bent":
        yield from (Bar(body, start, end) for start, end in pairwise(points))
    elif collinear(points):
        along = max((point - points[0] for point in points), key=length)
        ordered = sorted(points, key=along.dot)
        yield Bar(body, ordered[0], ordered[-1])
