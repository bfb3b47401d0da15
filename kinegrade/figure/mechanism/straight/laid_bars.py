"""Bars along the lines of a body on which other bodies slide or rest."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from kinegrade.figure.joints.symbol import Feature
from kinegrade.figure.mechanism.straight_parts import Bar
from kinegrade.figure.plane import length, on_line, same_line, unit
from kinegrade.mechanics.vector import Vector

_OVERHANG = 8.0  # millimetres a bar continues beyond whatever slides on it


def group_by_line(features: Iterable[Feature]) -> list[list[Feature]]:
    """The lines of a body, those in one line together."""
    groups: list[list[Feature]] = []
    for feature in features:
        home = next((group for group in groups if same_line(group[0].line, feature.line)), None)
        if home is None:
            groups.append([feature])
        else:
            home.append(feature)
    return groups


def lay_bar(body: str, points: Sequence[Vector], group: Sequence[Feature]) -> Bar:
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


def lay_arms(body: str, points: Sequence[Vector], group: Sequence[Feature]) -> Iterator[Bar]:
    """From the slot of a body the arm to its only point, where that lies beside it."""
    line = group[0].line
    if group[0].use == "slot" and len(points) == 1 and not on_line(points[0], line):
        along = unit(line.direction)
        foot = line.point + along * (points[0] - line.point).dot(along)
        yield Bar(body, foot, points[0])
