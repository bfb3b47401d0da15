"""Intersections of lines and circles, and feet of perpendiculars: the equations and how they are
solved.

A line along an axis gives a coordinate at once; a slanting one is parametrised by the distance s
from its given point. Two circles are in `kinegrade.worked.positions.meetings.circles_meeting`.
"""

from __future__ import annotations

from kinegrade.expressions.tree import Call, Expression, Name, Operation, list_parts
from kinegrade.language.math.tree import Row
from kinegrade.language.message import Message
from kinegrade.worked.construction_steps import Step
from kinegrade.worked.document import Block, Display
from kinegrade.worked.formulas.atoms import AXES
from kinegrade.worked.formulas.equation import Equation, equate
from kinegrade.worked.positions.algebra import (
    ZERO,
    Pair,
    cross,
    dot,
    minus,
    over,
    plus,
    root,
    square,
    times,
)
from kinegrade.worked.positions.axes import find_line
from kinegrade.worked.positions.chord_triangles import find_triangle
from kinegrade.worked.positions.instance import METRE, PURE, Instance
from kinegrade.worked.positions.meetings.along_lines import (
    Line,
    Way,
    is_unit,
    make_unit_line,
    name_coordinate_of,
    name_distance_along,
    solve_along_line,
)
from kinegrade.worked.positions.meetings.circles_meeting import explain_circles
from kinegrade.worked.positions.shapes import describe_chord_end, describe_line, describe_side
from kinegrade.worked.positions.vectors import describe_vector

_NOTHING: Pair = (ZERO, ZERO)


def explain_meeting(step: Step, instance: Instance) -> tuple[Block, ...]:
    """The point in which two lines, a line and a circle, or two circles meet."""
    first, second, *branch = list_parts(step.tree)
    side = describe_side(branch[0], instance) if branch else None
    if not (isinstance(first, Call) and isinstance(second, Call)):
        return ()
    circles = [shape for shape in (first, second) if shape.function == "circle"]
    lines = [shape for shape in (first, second) if shape.function == "line"]
    if len(circles) == 2:
        return explain_circles(step.point, (first, second), instance)
    if len(lines) == 2:
        return _explain_two_lines(step.point, (first, second), instance)
    sentence = describe_chord_end(step.point, lines[0], circles[0], side, instance)
    if ZERO in find_line(lines[0], instance.axes)[1]:
        return instance.say(sentence), *_solve_straight(step.point, lines[0], circles[0], instance)
    distance, solved = _solve_slanting_chord(step.point, lines[0], circles[0], instance)
    return instance.say(Message("solution.sentences", first=sentence, next=distance)), solved


def _explain_two_lines(
    point: str, lines: tuple[Call, Call], instance: Instance
) -> tuple[Block, ...]:
    """The point in which two lines meet; of two slanting lines the first is parametrised."""
    sentence = Message(
        "solution.lines-meet",
        point=instance.letter(point),
        first=describe_line(lines[0], instance),
        second=describe_line(lines[1], instance),
    )
    first, second = (find_line(line, instance.axes) for line in lines)
    if ZERO in first[1] + second[1]:
        solved = Display(_solve_two_lines(point, first, second, instance))
        return instance.say(sentence), solved
    share, start = name_distance_along(lines[0], instance)
    distance = Message("solution.lines-meet-distance", share=share, start=start)
    return instance.say(Message("solution.sentences", first=sentence, next=distance)), Display(
        _solve_two_slanting_lines(point, make_unit_line(first, instance), second, instance)
    )


def _solve_two_lines(point: str, first: Line, second: Line, instance: Instance) -> tuple[Row, ...]:
    """Both coordinates, from a line along an axis and the other line."""
    (base, along), (other, across) = (first, second) if ZERO in first[1] else (second, first)
    level = along[1] == ZERO
    known, sought = reversed(AXES) if level else AXES
    place, slope = (1, over(across[0], across[1])) if level else (0, over(across[1], across[0]))
    rise = minus(_write_coordinate_formula(instance, known, point), other[place])
    return (
        *instance.equation(name_coordinate_of(instance, known, point), base[place]),
        *instance.equation(
            name_coordinate_of(instance, sought, point),
            plus(other[1 - place], _multiply_by_slope(rise, slope)),
        ),
    )


def _multiply_by_slope(rise: Expression, slope: Expression) -> Expression:
    """rise * slope, the slope a quotient, as one fraction."""
    if isinstance(slope, Operation) and slope.sign == "/":
        return over(times(rise, slope.left), slope.right)
    return times(rise, slope)


def _solve_two_slanting_lines(
    point: str, first: Line, second: Line, instance: Instance
) -> tuple[Row, ...]:
    """The distance s along the first line from its point, then both coordinates."""
    (base, along), (other, across) = first, second
    apart = minus(other[0], base[0]), minus(other[1], base[1])
    share = over(cross(apart, across), cross(along, across))
    unit = METRE if is_unit(along) else PURE
    return solve_along_line(point, Way(base, along, unit), share, instance)


def _solve_straight(
    point: str, line: Call, circle: Call, instance: Instance
) -> tuple[Display, ...]:
    """The equation of the circle, and its solution on a line along an axis."""
    base, along = find_line(line, instance.axes)
    centre = instance.axes.pair(circle.arguments[0]) or _NOTHING
    equation = _write_circle_equation(point, circle, instance)
    level = along[1] == ZERO
    known, sought = reversed(AXES) if level else AXES
    place = 1 if level else 0
    rise = minus(_write_coordinate_formula(instance, known, point), centre[place])
    reach = root(minus(square(circle.arguments[1]), square(rise)))
    beyond = instance.sign(minus(Call(sought, (Name(point),)), centre[1 - place]))
    solved = (minus if beyond < 0 else plus)(centre[1 - place], reach)
    return Display((equation,)), Display(
        (
            *instance.equation(name_coordinate_of(instance, known, point), base[place]),
            *instance.equation(name_coordinate_of(instance, sought, point), solved),
        )
    )


def _solve_slanting_chord(
    point: str, line: Call, circle: Call, instance: Instance
) -> tuple[Message, Display]:
    """The distance along the line: in the triangle of its start, the centre and the point by the
    angle at this one, else from the projection of the centre and half the chord; then both
    coordinates.
    """
    base, along = make_unit_line(find_line(line, instance.axes), instance)
    middle, radius = circle.arguments
    centre = instance.axes.pair(middle) or _NOTHING
    away = minus(centre[0], base[0]), minus(centre[1], base[1])
    apart, middle_share = cross(away, along), dot(away, along)
    place = Call("x", (Name(point),)), Call("y", (Name(point),))
    beyond = dot((minus(place[0], centre[0]), minus(place[1], centre[1])), along)
    before = instance.sign(beyond) < 0
    triangle = None if before else find_triangle(point, line, circle, away, instance)
    if triangle is not None:
        share = plus(middle_share, times(radius, Call("cos", (Name(triangle.name),))))
        way = Way(base, along, side=triangle.side)
        solved = solve_along_line(point, way, share, triangle.instance)
        return triangle.explain(), Display((*triangle.solve(), *solved))
    half = root(minus(square(radius), square(apart))) if instance.sign(apart) else radius
    letter, start = name_distance_along(line, instance)
    vector = describe_vector(Operation("-", middle, line.arguments[0]), instance)
    names = {"share": letter, "start": start, "vector": vector}
    said = Message("solution.chord-before" if before else "solution.chord-beyond", **names)
    run = (minus if before else plus)(middle_share, half)
    return said, Display(solve_along_line(point, Way(base, along), run, instance))


def _write_circle_equation(point: str, circle: Call, instance: Instance) -> Row:
    """(x - a)^2 + (y - b)^2 = r^2 in symbols."""
    centre = instance.axes.pair(circle.arguments[0]) or _NOTHING
    left = plus(
        square(minus(_write_coordinate_formula(instance, "x", point), centre[0])),
        square(minus(_write_coordinate_formula(instance, "y", point), centre[1])),
    )
    right = instance.formula(square(circle.arguments[1]))
    return instance.case.print_line(Equation(instance.formula(left), equate(right)))


def explain_foot(step: Step, instance: Instance) -> tuple[Block, ...]:
    """The foot of a perpendicular, by the projection on the line."""
    source, line = list_parts(step.tree)
    if not isinstance(line, Call):
        return ()
    base, along = make_unit_line(find_line(line, instance.axes), instance)
    place = instance.axes.pair(source) or _NOTHING
    sentence = Message(
        "solution.foot",
        point=instance.letter(step.point),
        source=instance.text(source),
        line=describe_line(line, instance),
    )
    letter, start = name_distance_along(line, instance)
    vector = describe_vector(Operation("-", source, line.arguments[0]), instance)
    distance = Message("solution.foot-distance", share=letter, start=start, vector=vector)
    share = dot((minus(place[0], base[0]), minus(place[1], base[1])), along)
    return (
        instance.say(Message("solution.sentences", first=sentence, next=distance)),
        Display(solve_along_line(step.point, Way(base, along), share, instance)),
    )


def _write_coordinate_formula(instance: Instance, axis: str, point: str) -> Expression:
    """A coordinate of a named point as a formula."""
    return instance.axes.coordinate(axis, point)
