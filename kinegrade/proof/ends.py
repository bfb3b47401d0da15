"""Points beyond the ends of a bar: a block that slides on a bar CB is thought of between C and B,
and so are a sleeve through which the bar slides and a point that is placed on it from C toward B.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from kinegrade.expressions.tree import Call, Name
from kinegrade.language.message import Message
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.joints import Sleeve
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.template import Template

_BEYOND = 1e-9  # of the bar's length: less is what doubles leave of an end
_ENDS = 2


@dataclass(frozen=True)
class _Bar:
    """A point on the line through two points of a body; `between` says that it is beyond the
    others there by mistake even where it always is.
    """

    point: str
    body: str
    line: tuple[str, str]
    others: Sequence[str]
    between: bool

    def find_ends(self, solution: Solution) -> tuple[str, str] | None:
        """The outermost of the others on the line, if the point lies beyond them."""
        at = solution.doubles.points
        first, last = (at[name] for name in self.line)
        along = last - first
        places = {
            name: (at[name] - first).dot(along) / along.dot(along)
            for name in self.others
            if abs(along.cross(at[name] - first)) <= _BEYOND * along.dot(along)
        }
        if len(places) < _ENDS:
            return None
        least, most = min(places.values()), max(places.values())
        room, share = (
            _BEYOND * (most - least),
            (at[self.point] - first).dot(along) / along.dot(along),
        )
        if least - room <= share <= most + room or most == least:
            return None
        start, *_, end = (name for name, place in places.items() if place in {least, most})
        return start, end

    def is_behind_pivot(self, solution: Solution) -> bool:
        """Whether the fixed pin of the body is the nearest of its points: an arm on the one side
        of the pin goes with a slot on the other.
        """
        at = solution.doubles.points
        pivot = solution.assembly.mechanism.find_pivots().get(self.body)
        return pivot == min(self.others, key=lambda name: (at[name] - at[self.point]).squared())


def note_points_beyond_ends(template: Template, examples: Iterable[Solution]) -> Iterator[Message]:
    """A remark for each point that lies beyond the ends of its bar in some instances."""
    instances = tuple(examples)
    for bar in (*_find_slots(template), *_find_sleeves(template), *_find_marks(template)):
        beyond = [ends for each in instances if (ends := bar.find_ends(each)) is not None]
        by_design = len(beyond) == len(instances) and all(map(bar.is_behind_pivot, instances))
        if beyond and not by_design and (bar.between or len(beyond) < len(instances)):
            yield _describe(bar, beyond, len(instances))


def _describe(bar: _Bar, beyond: Sequence[tuple[str, str]], examined: int) -> Message:
    """The remark; where all instances are meant, a condition would leave none."""
    (start, end), point, body = beyond[0], bar.point, bar.body
    if len(beyond) == examined:
        return Message(
            "template.always-beyond-its-bar",
            point=point,
            start=start,
            end=end,
            body=body,
            examined=examined,
        )
    return Message(
        "template.beyond-its-bar",
        point=point,
        start=start,
        end=end,
        body=body,
        number=len(beyond),
        examined=examined,
    )


def _find_slots(template: Template) -> Iterator[_Bar]:
    """The points that slide on lines of moving bodies through two of their points."""
    points = {body.name: body.points for body in template.scheme.bodies}
    for joint in template.scheme.joints:
        match joint.on:
            case Call(function="line", arguments=(Name(start), Name(end))) if joint.point:
                if joint.of != GROUND and end in template.scheme.points:
                    others = [name for name in points[joint.of] if name != joint.point]
                    yield _Bar(joint.point, joint.of, (start, end), others, between=True)
            case _:
                continue  # a line by its direction has no ends


def _find_sleeves(template: Template) -> Iterator[_Bar]:
    """The points at which sleeves stand on the lines of rods that slide through them."""
    points = {body.name: body.points for body in template.scheme.bodies}
    for joint in template.scheme.joints:
        match joint.on:
            case Call(function="line", arguments=(Name(start), Name(end))) if (
                joint.stated is Sleeve
            ):
                rod = points[joint.body]
                known = points.get(joint.of, tuple(template.scheme.points))
                for name in (start, end):
                    if name in known and (joint.of != GROUND or name not in rod):
                        others = [each for each in rod if each != name]
                        yield _Bar(name, joint.body, (start, end), others, between=True)
            case _:
                continue  # a line by its direction names no place of the sleeve


def _find_marks(template: Template) -> Iterator[_Bar]:
    """The points of bodies that are placed from one toward another of their points."""
    for body in template.scheme.bodies:
        for name in body.points:
            match template.scheme.points.get(name):
                case Call(function="toward", arguments=(Name(start), Name(end), _)):
                    if {start, end} <= set(body.points):
                        others = [point for point in body.points if point in {start, end}]
                        first, last = map(body.points.index, others)
                        between = first < body.points.index(name) < last
                        yield _Bar(name, body.name, (start, end), others, between)
                case _:
                    continue  # nothing says where it ought to lie
