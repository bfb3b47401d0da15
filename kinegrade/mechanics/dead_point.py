"""Dead points: positions at which a complete mechanism cannot be solved because some of its links
are in line.

A mechanism whose relations determine its motion at all other positions is not loose: no joint and
no driver is missing.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import replace
from itertools import combinations
from typing import Any, assert_never

from kinegrade.language.message import Message, list_all
from kinegrade.mechanics.frames import Frames, build_frames
from kinegrade.mechanics.laws import (
    Condition,
    EqualRotation,
    GuidedBody,
    GuidedPoint,
    SharedPoint,
)
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.shapes import Line
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.elimination import find_null_vectors
from kinegrade.numbers.number import Arithmetic

_PARTS = 9973  # points are moved by whole multiples of 1/PARTS metre, each by different ones


def describe_dead_point(
    frames: Frames, bodies: Collection[str], arithmetic: Arithmetic
) -> Message | None:
    """What is in line at a dead point, such as "C, D and O6 are in line"; None where nothing is, or
    a body is loose.

    `bodies` are those that could turn.
    """
    found = find_alignment(frames.mechanism, bodies, arithmetic)
    return found if found and _is_determined_elsewhere(frames.mechanism, arithmetic) else None


def find_alignment(
    mechanism: Mechanism, bodies: Collection[str], arithmetic: Arithmetic
) -> Message | None:
    """The first thing that is in line, or at a right angle to its guide, among the joints of
    `bodies`; None where nothing is.
    """
    return next(_find_alignments(mechanism, bodies, arithmetic), None)


def _find_alignments(
    mechanism: Mechanism, bodies: Collection[str], arithmetic: Arithmetic
) -> Iterator[Message]:
    """Two bodies pinned together whose joints are in line, and a body at right angles to the line
    that guides it.
    """
    ends = {body: _list_joint_points(mechanism, body) for body in bodies}
    for shared in mechanism.shared_points:
        for first, second in combinations([body for body in shared.bodies if body in ends], 2):
            yield from _find_aligned_chains(
                mechanism, ends[first], shared.point, ends[second], arithmetic
            )
    for condition in mechanism.list_conditions():
        match condition:
            case GuidedPoint(point=point, body=body, track=Line() as slot, in_slot=True):
                joints = ends.get(body, ())
                yield from _find_right_angles(mechanism, point, slot, joints, arithmetic)
            case GuidedPoint() | GuidedBody() | SharedPoint() | EqualRotation():
                pass  # no pin in a straight slot
            case _:
                assert_never(condition)


def _find_aligned_chains(
    mechanism: Mechanism,
    first: Collection[str],
    middle: str,
    second: Collection[str],
    arithmetic: Arithmetic,
) -> Iterator[Message]:
    """Joints of two bodies that are in line with the pin between these."""
    points = mechanism.points
    for start in first:
        for end in second:
            arms = (points[start] - points[middle], points[end] - points[middle])
            if len({start, middle, end}) == 3 and arithmetic.is_zero(arms[0].cross(arms[1])):
                yield Message("mechanics.in-line", points=list_all(sorted((start, middle, end))))


def _find_right_angles(
    mechanism: Mechanism, point: str, slot: Line, ends: Collection[str], arithmetic: Arithmetic
) -> Iterator[Message]:
    """A body, with its joints at `ends`, that stands at right angles to the slot of its point."""
    for end in ends:
        arm: Vector = mechanism.points[end] - mechanism.points[point]
        if end != point and arithmetic.is_zero(arm.dot(slot.direction)):
            yield Message("mechanics.at-right-angles", arm=f"{end}{point}", point=point)


def _list_joint_points(mechanism: Mechanism, body: str) -> tuple[str, ...]:
    """The points at which a body is pinned or guided."""
    found = (_find_joint_point(condition, body) for condition in mechanism.list_conditions())
    return tuple(dict.fromkeys(point for point in found if point is not None))


def _find_joint_point(condition: Condition, body: str) -> str | None:
    """The point at which a condition pins or guides a body; None where it does not."""
    match condition:
        case SharedPoint(point=point, bodies=bodies):
            return point if body in bodies else None
        case GuidedPoint(point=point, body=guided, in_slot=in_slot):
            return point if in_slot and body == guided else None
        case GuidedBody() | EqualRotation():
            return None
        case _:
            assert_never(condition)


def _is_determined_elsewhere(mechanism: Mechanism, arithmetic: Arithmetic) -> bool:
    """Whether the relations determine the motion when every point lies a little elsewhere."""
    moved = {
        name: Vector(
            place.x + arithmetic.number(7 * number * number + 3) / _PARTS,
            place.y + arithmetic.number(11 * number + 5) / _PARTS,
        )
        for number, (name, place) in enumerate(mechanism.points.items())
    }
    relations = build_frames(replace(mechanism, points=moved), arithmetic).relations
    rates = list(dict.fromkeys(rate for relation in relations for rate in relation.unknowns()))
    rows = [
        [make_numeral(row.get(rate, 0), arithmetic) for rate in rates]
        for relation in relations
        for row in relation.equations()
    ]
    return not find_null_vectors(rows, len(rates), arithmetic.is_zero)


def make_numeral(entry: Any, arithmetic: Arithmetic) -> Any:
    """An entry as a number of the arithmetic: plain integers would divide into floats."""
    return arithmetic.number(entry) if isinstance(entry, int) else entry
