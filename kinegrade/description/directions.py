"""Points that only give a line its direction, as the end of an edge does: how far away one is drawn
is nobody's given.
"""

from __future__ import annotations

from collections.abc import Collection

from kinegrade.description.subject import Subject
from kinegrade.expressions.tree import Call, Expression, Name, Number, find_names, walk
from kinegrade.language.message import Message
from kinegrade.worked.construction_steps import Step
from kinegrade.worked.positions.polar import find_polar_way

_OF_CONSTRUCTIONS = frozenset({0, 1, 2})  # halves and doubles


def say_direction(step: Step, named: Collection[str], subject: Subject) -> Message | None:
    """In which direction such a point lies; None for any other, and where other constructions or
    marks have `named` it.
    """
    tree = step.tree
    if not isinstance(tree, Call) or tree.function != "polar" or step.point in named:
        return None
    centre, radius, angle = tree.arguments
    if not _is_drawn_only(radius) or _find_uses(step.point, subject) - _find_names(centre):
        return None
    way = find_polar_way((centre, radius, angle), subject.instance)
    if way.heading is not None or way.against:
        return None
    point = subject.instance.letter(step.point)
    return Message("description.direction", point=point, centre=way.centre, angle=way.angle)


def _is_drawn_only(distance: Expression) -> bool:
    """Whether a distance has a number that the template's author chose for the drawing."""
    numbers = [part.value for part in walk(distance) if isinstance(part, Number)]
    return not _OF_CONSTRUCTIONS.issuperset(numbers)


def _find_names(centre: Expression) -> frozenset[str]:
    return frozenset({centre.name} if isinstance(centre, Name) else ())


def _find_uses(point: str, subject: Subject) -> frozenset[str]:
    """With what a point makes lines in joints; itself where it is used in any other way."""
    scheme = subject.template.scheme
    uses: set[str] = set()
    for joint in scheme.joints:
        for shape in (joint.circle, joint.on):
            names = set(find_names(shape)) if shape is not None else set()
            if shape is not None and point in names:
                uses |= names - {point} if shape.function == "line" else {point}
    used = {joint.point for joint in scheme.joints}
    used |= {name for driver in scheme.drivers for name in (driver.point, driver.centre)}
    used |= {name for frame in subject.marks.frames for name in (frame.at, frame.start, frame.end)}
    asks = subject.template.asks.values()
    used |= {name for ask in asks for name in find_names(ask.quantity)}
    return frozenset(uses | ({point} & used))
