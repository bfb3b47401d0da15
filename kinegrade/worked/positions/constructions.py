"""The construction of a point in textbook words and equations: where it lies, and how its
coordinates are worked out.

Lines, circles and feet of perpendiculars are in
`kinegrade.worked.positions.meetings.intersections`.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import assert_never

from kinegrade.expressions.tree import Call, Expression, Name, Number, Operation, list_parts, walk
from kinegrade.language.math.tree import Row
from kinegrade.language.message import Message
from kinegrade.worked.case import Case
from kinegrade.worked.construction_steps import Step
from kinegrade.worked.document import Block
from kinegrade.worked.formulas.atoms import Symbol
from kinegrade.worked.formulas.measures import is_zero
from kinegrade.worked.positions.algebra import ZERO, minus, over, plus
from kinegrade.worked.positions.axes import length_of, scale
from kinegrade.worked.positions.instance import Instance
from kinegrade.worked.positions.meetings.circles_meeting import find_direction
from kinegrade.worked.positions.meetings.intersections import explain_foot, explain_meeting
from kinegrade.worked.positions.parts import Coordinates, Derived, Part, Stated, write_parts
from kinegrade.worked.positions.polar import (
    derive_inclination,
    describe_inclination,
    find_parallelogram,
    find_polar_way,
    write_positive,
)
from kinegrade.worked.positions.vectors import describe_vector, negate, write_way


def write_chapter(steps: Iterable[Step], instance: Instance) -> tuple[Block, ...]:
    """The blocks of all steps."""
    return write_parts(explain_constructions(steps, instance), instance.case)


def explain_constructions(steps: Iterable[Step], instance: Instance) -> tuple[Part, ...]:
    """A part of the chapter for each step, the origin first."""
    ordered = sorted(steps, key=lambda step: instance.axes.pair(step.tree) != (ZERO, ZERO))
    return tuple(_explain_construction(step, instance) for step in ordered)


def _explain_construction(step: Step, instance: Instance) -> Part:
    """The part of one step: its coordinates alone where these are all there is to write."""
    tree = step.tree
    if isinstance(tree, Call) and tree.function == "meet":
        return explain_meeting(step, instance)
    if isinstance(tree, Call) and tree.function == "foot":
        return explain_foot(step, instance)
    if isinstance(tree, Call) and tree.function == "toward":
        return _explain_toward(step, instance)
    pair = instance.axes.pair(tree) or (ZERO, ZERO)
    if pair == (ZERO, ZERO):
        return Stated(_name_origin(step.point, instance), ())
    sentence = _join(_describe_track(step, instance), _describe_place(step, instance))
    found = instance.coordinates(step.point, pair)
    if sentence is None:
        reasoned = (_add_reason(one, tree, instance) for one, tree in zip(found, pair, strict=True))
        return Coordinates((instance.letter(step.point),), tuple(reasoned))
    return Stated(sentence, found, tuple(_find_used(tree, instance)))


def _add_reason(coordinate: Derived, tree: Expression, instance: Instance) -> Derived:
    """A coordinate with how the inclination follows that its sine or cosine takes."""
    calls = (part for part in walk(tree) if isinstance(part, Call))
    angles = (call.arguments[0] for call in calls if call.function in ("sin", "cos"))
    reasons = (derive_inclination(angle, instance) for angle in angles)
    return replace(coordinate, reason=next(filter(None, reasons), None))


def _describe_track(step: Step, instance: Instance) -> Message | None:
    """That a point slides along an axis, where its construction does not say that it lies there."""
    point, pair = instance.letter(step.point), instance.axes.pair(step.tree) or (ZERO, ZERO)
    if instance.axes.x(step.point) == ZERO != pair[0]:
        return Message("solution.on-axis", point=point, axis=Message("solution.y-axis"))
    if instance.axes.y(step.point) == ZERO != pair[1]:
        return Message("solution.on-axis", point=point, axis=Message("solution.x-axis"))
    return None


def _join(first: Message | None, following: Message | None) -> Message | None:
    """Two sentences, or the one that there is."""
    if first is None or following is None:
        return first or following
    return Message("solution.sentences", first=first, next=following)


def _name_origin(point: str, instance: Instance) -> Message:
    """The point at the origin: the coordinates do not move with one that moves."""
    letter = instance.letter(point)
    if _moves(point, instance.case):
        return Message("solution.moving-origin", point=letter)
    return Message("solution.origin", point=letter)


def _moves(point: str, case: Case) -> bool:
    """Whether a point is one of a moving body, and of none in which it rests at this instant."""
    motion = case.motion
    if not motion.rates:
        return False
    bodies = motion.frames.mechanism.bodies
    owners = [body.name for body in bodies if point in body.points]
    moving = (not is_zero(motion.velocity(point, owner)) for owner in owners)
    return bool(owners) and all(moving)


def _find_used(tree: Expression, instance: Instance) -> Iterator[Derived]:
    """The distances of points, and the directions from one to another, that place a point at a
    distance in a direction.
    """
    if not (isinstance(tree, Call) and tree.function == "polar"):
        return
    for part in dict.fromkeys(one for one in walk(tree) if isinstance(one, Call)):
        if part.function in ("distance", "direction"):
            away = part.function == "distance"
            lines = (write_length_lines if away else find_direction)(part, instance)
            yield Derived(Symbol(instance.formula(part).print()), lines)


def _describe_place(step: Step, instance: Instance) -> Message | None:
    """Where the point of a step lies, for constructions whose coordinates follow at once; None
    where the coordinates alone are enough.
    """
    point, tree = instance.letter(step.point), step.tree
    match tree:
        case Name():
            return Message("solution.coincides", point=point, other=instance.letter(tree.name))
        case Call(function="polar", arguments=(centre, radius, angle)):
            parts = (centre, radius, angle)
            inclined = describe_inclination(step.point, parts, instance)
            place = inclined or _describe_polar_place(point, parts, instance)
            reason = find_parallelogram(step.point, (centre, radius), instance)
            if reason is None:
                return place
            return Message("solution.sentences", first=reason, next=place)
        case Call(function="midpoint", arguments=(Name(first), Name(second))):
            return Message(
                "solution.midpoint",
                point=point,
                first=instance.letter(first),
                second=instance.letter(second),
            )
        case Operation(sign="+" | "-", left=Name(base), right=right):
            vector = {"+": right, "-": negate(right, instance)}[tree.sign]
            return Message(
                "solution.displaced",
                point=point,
                base=instance.letter(base),
                vector=describe_vector(vector, instance),
            )
        case Number() | Operation() | Call():
            return None
        case _:
            assert_never(tree)


def _describe_polar_place(
    point: str, parts: tuple[Expression, Expression, Expression], instance: Instance
) -> Message:
    """Distance and direction from a centre."""
    way = find_polar_way(parts, instance)
    named = {"point": point, "centre": way.centre, "radius": way.distance}
    if way.heading is not None:
        return Message(f"solution.towards-{way.heading}", **named)
    if way.against:
        return Message("solution.polar-against", **named, angle=way.angle)
    return Message("solution.polar", **named, angle=way.angle)


def _explain_toward(step: Step, instance: Instance) -> Part:
    """A point at a distance from one point towards another, or along a vector."""
    start, end, distance = list_parts(step.tree)
    vector = write_way(start, end, instance)
    size, direction = length_of(vector, instance.axes), instance.axes.pair(vector)
    base = instance.axes.pair(start)
    sentence = _describe_reached_place(step, vector, instance)
    if base is None or direction is None:
        return (instance.say(sentence),)
    signs = instance.sign(direction[0]), instance.sign(direction[1])
    if 0 in signs:  # along an axis no length is needed
        along = _move(base[0], signs[0], distance), _move(base[1], signs[1], distance)
        return Stated(sentence, instance.coordinates(step.point, along))
    lines = write_length_lines(size, instance)
    reached = scale(direction, over(distance, size)) or (ZERO, ZERO)
    pair = plus(base[0], reached[0]), plus(base[1], reached[1])
    before = (Derived(Symbol(instance.formula(size).print()), lines),) if lines else ()
    return Stated(sentence, instance.coordinates(step.point, pair), before)


def _move(coordinate: Expression, sign: int, distance: Expression) -> Expression:
    """A coordinate after so far along its axis, against it or across it."""
    moved = {-1: minus, 1: plus}
    return moved[sign](coordinate, distance) if sign else coordinate


def _describe_reached_place(step: Step, vector: Expression, instance: Instance) -> Message:
    """Where a point lies that is reached along a vector: on the way to another point, or not."""
    start, end, distance = list_parts(step.tree)
    size, against = write_positive(distance, instance)
    named = {
        "point": instance.letter(step.point),
        "start": instance.text(start),
        "distance": size,
    }
    match end:
        case Name():
            ray = "on-opposite-ray" if against else "on-ray"
            return Message(f"solution.{ray}", **named, end=instance.text(end))
        case Number() | Operation() | Call():
            way = describe_vector(negate(vector, instance) if against else vector, instance)
            return Message("solution.along-vector", **named, vector=way)
        case _:
            assert_never(end)


def write_length_lines(size: Expression, instance: Instance) -> tuple[Row, ...]:
    """AB = the root of the sum of squares, worked out; nothing for a length that is not the
    distance of two points.
    """
    if not isinstance(size, Call) or size.function != "distance":
        return ()
    instance.note_distance(size)
    first, second = size.arguments
    vector = instance.axes.pair(Operation("-", second, first)) or (ZERO, ZERO)
    return instance.equation(instance.formula(size), instance.measure(vector))
