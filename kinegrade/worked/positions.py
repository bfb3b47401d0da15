"""The chapter on positions of a worked solution: where each point is at the instant, and the
distances and directions between points.

Everything follows the constructions of the template, in its order, with this paper's numbers.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable
from typing import assert_never

from kinegrade.exact.angle import Angle
from kinegrade.expression import Call, Expression, Name, Number, Operation
from kinegrade.language import Language
from kinegrade.problem.solving import Solution
from kinegrade.worked.constructions import chapter
from kinegrade.worked.coordinates import ZERO, length_of, needed
from kinegrade.worked.document import Block, Display, Prose
from kinegrade.worked.instance_formulas import DEGREE, METRE, RADIAN, Instance, instance_of
from kinegrade.worked.position_words import position_words


def positions(solution: Solution, wanted: Collection[str], language: Language) -> tuple[Block, ...]:
    """Where the points `wanted` are, and those they are constructed from: a sentence and equations
    for each.

    Coordinates in metres, x to the right, y upwards. Named lengths of the template come first.
    """
    instance = instance_of(solution)
    steps = needed(instance.steps, wanted)
    return named_lengths(instance, language) + chapter(steps, instance, language)


def named_lengths(instance: Instance, language: Language) -> tuple[Block, ...]:
    """The lengths that follow from the given quantities."""
    lines: tuple[str, ...] = ()
    for name, tree in instance.solution.template.scheme.lengths.items():
        unit = RADIAN if isinstance(instance.values[name], Angle) else METRE
        lines += instance.equation(instance.symbols[name], tree, unit)
    return (Prose(position_words(language).lengths), Display(lines)) if lines else ()


def lengths_and_directions(
    solution: Solution, pairs: Iterable[tuple[str, str]], language: Language
) -> tuple[Block, ...]:
    """The distance of each pair of points in metres, and the direction from the first to the
    second.

    Directions are counted counter-clockwise from the x axis, in degrees. Points that coincide have
    no direction.
    """
    instance = instance_of(solution)
    lines: tuple[str, ...] = ()
    for first, second in pairs:
        distance = Call("distance", (Name(first), Name(second)))
        lines += instance.equation(
            instance.symbolic(distance), length_formula(first, second, instance)
        )
        if instance.sign(distance):
            direction = Call("direction", (Name(first), Name(second)))
            lines += instance.equation(
                instance.symbolic(direction), direction_formula(first, second, instance), DEGREE
            )
    return (Prose(position_words(language).lengths_and_directions), Display(lines)) if lines else ()


def length_formula(first: str, second: str, instance: Instance) -> Expression:
    """How the distance of two points is known: by construction, or from their coordinates."""
    trees = {step.point: step.tree for step in instance.steps}
    for centre, point in ((first, second), (second, first)):
        radius = built_radius(centre, trees[point])
        if radius is not None and instance.sign(radius) > 0:
            return radius
    vector = instance.axes.pair(Operation("-", Name(second), Name(first))) or (ZERO, ZERO)
    return length_of(Call("", vector), instance.axes)


def built_radius(centre: str, tree: Expression) -> Expression | None:
    """The distance from a named centre at which a construction places its point; None for any other
    construction.
    """
    match tree:
        case Call(function="polar" | "circle", arguments=(Name(name), radius, *_)) if (
            name == centre
        ):
            return radius
        case Call(function="meet", arguments=(first, second, *_)):
            return (
                built_radius(centre, first)
                if is_circle(first, centre)
                else built_radius(centre, second)
                if is_circle(second, centre)
                else None
            )
        case Number() | Name() | Operation() | Call():
            return None
        case _:
            assert_never(tree)


def is_circle(shape: Expression, centre: str) -> bool:
    """Whether a shape is a circle about a named centre."""
    return (
        isinstance(shape, Call)
        and shape.function == "circle"
        and shape.arguments[0] == Name(centre)
    )


def direction_formula(first: str, second: str, instance: Instance) -> Expression:
    """How the direction from one point to another is known: as the angle of the construction, or
    from coordinates.
    """
    tree = next(step.tree for step in instance.steps if step.point == second)
    match tree:
        case Call(function="polar", arguments=(Name(name), radius, angle)) if name == first:
            if instance.sign(radius) > 0:
                return angle
    return Call("direction", (Name(first), Name(second)))
