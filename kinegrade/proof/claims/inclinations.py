"""Claims of angles whose line is not named by letters: `stands at the angle {{ theta }} to the
vertical`, `at the angle {{ phi }} above $OC$`.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import permutations
from math import cos, pi, sin

from kinegrade.expressions.tree import find_names
from kinegrade.figure.plane import angle_of, length
from kinegrade.language.message import Message
from kinegrade.mechanics.shapes import Line
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.template import Parameter, Template
from kinegrade.proof.claims.reading import DIFFERENT, find_points, measure_angle, read_claims

_UPRIGHT = {"from-horizontal": 0.0, "from-vertical": pi / 2}
_NAMED = ("angle-with-horizontal", "angle-with-vertical")  # of a line by its letters
_SIDES = {"angle-above": 1, "angle-below": -1}


def find_wrong_inclinations(template: Template, examples: Sequence[Solution]) -> Iterator[Message]:
    """The angles that no line of the mechanism has in some instance."""
    with_letters = [claim["said"] for kind in _NAMED for claim in read_claims(template, kind)]
    for kind, upright in _UPRIGHT.items():
        for claim in read_claims(template, kind):
            given = _find_angle(template, claim["given"])
            if any(claim["said"] in said for said in with_letters):
                continue
            if given and not all(_has_line(each, given, upright) for each in examples):
                yield Message("template.lies-otherwise", said=claim["said"])
    for kind, side in _SIDES.items():
        for claim in read_claims(template, kind):
            given = _find_angle(template, claim["given"])
            ends = find_points(template, claim["start"], claim["end"])
            if given and ends and not all(_rises(each, given, ends, side) for each in examples):
                yield Message("template.lies-otherwise", said=claim["said"])


def _find_angle(template: Template, name: str) -> Parameter | None:
    """The given angle of that name; None for another, or the direction of an input."""
    given = template.parameters.get(name)
    if given is None or not given.unit.angle or given.unit.time:
        return None
    driven = (sentence.along for sentence in template.scheme.drivers if sentence.along)
    return None if any(name in find_names(along) for along in driven) else given


def _has_line(each: Solution, given: Parameter, upright: float) -> bool:
    """Whether some line has an angle with the horizontal or vertical, on whatever side it is."""
    stated = abs(sin(measure_angle(each, given)))
    return any(
        abs(abs(sin(angle_of(step) - upright)) - stated) <= DIFFERENT
        for step in _list_directions(each)
    )


def _list_directions(each: Solution) -> Iterator[Vector]:
    """The lines through any two points, and those on which anything slides or rolls."""
    at = each.doubles.points.values()
    yield from (end - start for start, end in permutations(at, 2) if length(end - start) > 0)
    for joint in each.assembly.mechanism.map(float).joints:
        yield from (shape.direction for shape in joint.list_shapes() if isinstance(shape, Line))


def _rises(each: Solution, given: Parameter, ends: Sequence[str], side: int) -> bool:
    """Whether some point is seen from an end of a line at an angle above or below that line."""
    at = each.doubles.points
    start, end = (at[name] for name in ends)
    along = end - start if end.x >= start.x else start - end
    stated = measure_angle(each, given)
    return any(
        _fits(angle_of(point - corner) - angle_of(along), stated, side)
        for corner in (start, end)
        for point in at.values()
        if length(point - corner) > 0
    )


def _fits(seen: float, stated: float, side: int) -> bool:
    """Whether an angle from a line that runs to the right is as stated, on that side of it, from
    either end.
    """
    near = abs(abs(cos(seen)) - abs(cos(stated))) <= DIFFERENT
    turned = -1 if sin(stated) < 0 else 1  # an angle beyond half a turn, or a negative one
    return near and side * turned * sin(seen) >= -DIFFERENT
