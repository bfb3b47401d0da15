"""Points beyond the ends that words give to a slot: a block on the line CB of a bar CB is thought
of between C and B.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from kinegrade.expressions.tree import Call, Name
from kinegrade.language.message import Message
from kinegrade.mechanics.ground import GROUND
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.template import Template

_BEYOND = 1e-9  # of the slot's length: less is what doubles leave of an end


@dataclass(frozen=True)
class _Slot:
    """A point that slides on the line through two points of a body."""

    point: str
    body: str
    start: str
    end: str


def note_points_beyond_ends(template: Template, examples: Iterable[Solution]) -> Iterator[Message]:
    """A remark for each point that lies beyond the ends of its bar in some instances."""
    instances = tuple(examples)
    for slot in _find_slots(template):
        beyond = sum(_lies_beyond(slot, each) for each in instances)
        if beyond:
            yield Message(
                "template.beyond-its-bar",
                point=slot.point,
                start=slot.start,
                end=slot.end,
                body=slot.body,
                number=beyond,
                examined=len(instances),
            )


def _find_slots(template: Template) -> Iterator[_Slot]:
    """The slots of moving bodies that are named by the first and the last of their points."""
    ends = {body.name: {body.points[0], body.points[-1]} for body in template.scheme.bodies}
    for joint in template.scheme.joints:
        match joint.on:
            case Call(function="line", arguments=(Name(start), Name(end))) if joint.point:
                if joint.of != GROUND and ends[joint.of] == {start, end}:
                    yield _Slot(joint.point, joint.of, start, end)
            case _:
                continue  # a line by its direction has no ends


def _lies_beyond(slot: _Slot, solution: Solution) -> bool:
    """Whether the point lies on the line produced, not between the ends."""
    points = solution.doubles.points
    along, to = points[slot.end] - points[slot.start], points[slot.point] - points[slot.start]
    share = to.dot(along) / along.dot(along)
    return not -_BEYOND <= share <= 1 + _BEYOND
