"""Intersections of lines and circles, and feet of perpendiculars: the equations and how they are
solved.

A line along an axis gives a coordinate at once; a slanting one is parametrised by the distance s
from its given point. Two circles are solved in the triangle of their centres and the point.
"""

from __future__ import annotations

from collections.abc import Mapping

from kinegrade.expression import Call, Expression, Name, Operation, list_parts
from kinegrade.language import Language
from kinegrade.problem.notation import write_symbol
from kinegrade.worked.coordinates import (
    ONE,
    TWO,
    ZERO,
    Pair,
    Step,
    cross,
    dot,
    find_line,
    length_of,
    minus,
    over,
    plus,
    root,
    square,
    times,
)
from kinegrade.worked.document import Block, Display, Prose
from kinegrade.worked.formula_text import count_quarter_turns
from kinegrade.worked.instance_formulas import AREA, DEGREE, METRE, PURE, Instance
from kinegrade.worked.position_words import PositionWords, load_position_words, write_sense
from kinegrade.worked.vector_words import describe_vector

_Line = tuple[Pair, Pair]  # a point and a direction
_NOTHING: Pair = (ZERO, ZERO)
_BETWEEN: Mapping[str, str] = {"en": " ", "zh": ""}


def explain_meeting(step: Step, instance: Instance, language: Language) -> tuple[Block, ...]:
    """The point in which two lines, a line and a circle, or two circles meet."""
    first, second, *branch = list_parts(step.tree)
    side = branch[0].name if branch and isinstance(branch[0], Name) else ""
    if not (isinstance(first, Call) and isinstance(second, Call)):
        return ()
    circles = [shape for shape in (first, second) if shape.function == "circle"]
    lines = [shape for shape in (first, second) if shape.function == "line"]
    if len(circles) == 2:
        return _explain_circles(step.point, (first, second), instance, language)
    words = load_position_words(language)
    if len(lines) == 2:
        return _explain_two_lines(step.point, (first, second), instance, language)
    sentence = words.line_meets_circle.format(
        point=instance.symbols[step.point],
        side=words.sides.get(side, ""),
        line=_describe_line(lines[0], instance, words),
        circle=_describe_circle(circles[0], instance, words),
    )
    if ZERO not in find_line(lines[0], instance.axes)[1]:
        sentence += _write_between_sentences(language) + _describe_distance_along(
            words.quadratic, lines[0], instance
        )
    return Prose(sentence), *_solve_line_and_circle(step.point, lines[0], circles[0], instance)


def _explain_two_lines(
    point: str, lines: tuple[Call, Call], instance: Instance, language: Language
) -> tuple[Block, ...]:
    """The point in which two lines meet; of two slanting lines the first is parametrised."""
    words = load_position_words(language)
    sentence = words.lines_meet.format(
        point=instance.symbols[point],
        first=_describe_line(lines[0], instance, words),
        second=_describe_line(lines[1], instance, words),
    )
    first, second = (find_line(line, instance.axes) for line in lines)
    if ZERO in first[1] + second[1]:
        return Prose(sentence), Display(_solve_two_lines(point, first, second, instance))
    sentence += _write_between_sentences(language) + _describe_distance_along(
        words.along_first, lines[0], instance
    )
    return Prose(sentence), Display(
        _solve_two_slanting_lines(point, _make_unit_line(first, instance), second, instance)
    )


def _describe_distance_along(sentence: str, line: Call, instance: Instance) -> str:
    """A sentence on the distance along a line from its given point."""
    return sentence.format(
        share=_choose_letter("s", instance), start=instance.symbolic(line.arguments[0])
    )


def _describe_line(line: Call, instance: Instance, words: PositionWords) -> str:
    """A line in a sentence."""
    start, toward = line.arguments
    texts = {"point": instance.symbolic(start), "angle": instance.symbolic(toward, degrees=True)}
    if instance.axes.is_vector(toward):
        return words.line_between.format(first=texts["point"], second=instance.symbolic(toward))
    quarters, place = count_quarter_turns(toward), instance.axes.pair(start)
    if quarters is None:
        return words.slanting_line.format(**texts)
    level = quarters % 2 == 0
    if place is not None and place[1 if level else 0] == ZERO:
        return words.x_axis if level else words.y_axis
    return (words.level_line if level else words.upright_line).format(**texts)


def _describe_circle(circle: Call, instance: Instance, words: PositionWords) -> str:
    """A circle in a sentence."""
    centre, radius = circle.arguments
    return words.circle.format(centre=instance.symbolic(centre), radius=instance.symbolic(radius))


def _solve_two_lines(
    point: str, first: _Line, second: _Line, instance: Instance
) -> tuple[str, ...]:
    """Both coordinates, from a line along an axis and the other line."""
    (base, along), (other, across) = (first, second) if ZERO in first[1] else (second, first)
    level = along[1] == ZERO
    known, sought = ("y", "x") if level else ("x", "y")
    place, slope = (1, over(across[0], across[1])) if level else (0, over(across[1], across[0]))
    rise = minus(_write_coordinate_formula(instance, known, point), other[place])
    return (
        *instance.equation(_write_label(instance, known, point), base[place]),
        *instance.equation(
            _write_label(instance, sought, point),
            plus(other[1 - place], _multiply_by_slope(rise, slope)),
        ),
    )


def _multiply_by_slope(rise: Expression, slope: Expression) -> Expression:
    """rise * slope, the slope a quotient, as one fraction."""
    if isinstance(slope, Operation) and slope.sign == "/":
        return over(times(rise, slope.left), slope.right)
    return times(rise, slope)


def _solve_two_slanting_lines(
    point: str, first: _Line, second: _Line, instance: Instance
) -> tuple[str, ...]:
    """The distance s along the first line from its point, then both coordinates."""
    (base, along), (other, across) = first, second
    apart = minus(other[0], base[0]), minus(other[1], base[1])
    share = over(cross(apart, across), cross(along, across))
    return _solve_along_line(point, base, along, share, instance)


def _choose_letter(name: str, instance: Instance) -> str:
    """The symbol of an auxiliary quantity, numbered where the template already uses that letter."""
    return write_symbol(instance.free(name))


def _solve_along_line(
    point: str, base: Pair, along: Pair, share: Expression, instance: Instance
) -> tuple[str, ...]:
    """s worked out, then the coordinates of the point at s from the line's given point."""
    name = instance.free("s")
    further = instance.named(name, write_symbol(name), instance.value(share))
    step = Name(name)
    lines = further.equation(further.symbolic(step), share)
    for axis, start, part in zip("xy", base, along, strict=True):
        lines += further.equation(
            _write_label(further, axis, point), plus(start, times(step, part))
        )
    return lines


def _solve_line_and_circle(
    point: str, line: Call, circle: Call, instance: Instance
) -> tuple[Display, ...]:
    """The circle's equation and its solution on the line, each aligned separately."""
    (base, along), centre = (
        find_line(line, instance.axes),
        instance.axes.pair(circle.arguments[0]) or _NOTHING,
    )
    radius = circle.arguments[1]
    equation = _write_circle_equation(point, circle, instance)
    if ZERO in along:
        level = along[1] == ZERO
        known, sought, place = ("y", "x", 1) if level else ("x", "y", 0)
        rise = minus(_write_coordinate_formula(instance, known, point), centre[place])
        reach = root(minus(square(radius), square(rise)))
        beyond = instance.sign(minus(Call(sought, (Name(point),)), centre[1 - place]))
        solved = (minus if beyond < 0 else plus)(centre[1 - place], reach)
        return Display((equation,)), Display(
            (
                *instance.equation(_write_label(instance, known, point), base[place]),
                *instance.equation(_write_label(instance, sought, point), solved),
            )
        )
    quadratic, *solution = _solve_slanting_chord(point, (base, along), (centre, radius), instance)
    return Display((equation,)), Display((quadratic,)), Display(tuple(solution))


def _solve_slanting_chord(
    point: str, line: _Line, circle: tuple[Pair, Expression], instance: Instance
) -> tuple[str, ...]:
    """s from s^2 + 2ps + q = 0, then both coordinates."""
    (base, along), (centre, radius) = _make_unit_line(line, instance), circle
    offset = minus(base[0], centre[0]), minus(base[1], centre[1])
    middle, rest = (
        dot(offset, along),
        minus(plus(square(offset[0]), square(offset[1])), square(radius)),
    )
    first, second = instance.free("p"), instance.free("q")
    further = instance.named(first, write_symbol(first), instance.value(middle))
    further = further.named(second, write_symbol(second), instance.value(rest))
    place = Call("x", (Name(point),)), Call("y", (Name(point),))
    run = dot((minus(place[0], base[0]), minus(place[1], base[1])), along)
    ahead = further.sign(plus(run, middle))
    reach = root(minus(square(Name(first)), Name(second)))
    share = (minus if ahead < 0 else plus)(minus(ZERO, Name(first)), reach)
    return (
        rf"{_choose_letter('s', instance)}^{{2}} + "
        rf"2\,{write_symbol(first)}\,{_choose_letter('s', instance)} + "
        rf"{write_symbol(second)} &= 0",
        *further.equation(write_symbol(first), middle),
        *further.equation(write_symbol(second), rest, AREA),
        *_solve_along_line(point, base, along, share, further),
    )


def _make_unit_line(line: _Line, instance: Instance) -> _Line:
    """A line with a unit direction vector: as it is where given by an angle, else divided by its
    length.
    """
    base, along = line
    if (
        ONE in along
        or minus(ZERO, ONE) in along
        or (isinstance(along[0], Call) and along[0].function == "cos")
    ):
        return line
    size = length_of(Call("", along), instance.axes)
    return base, (over(along[0], size), over(along[1], size))


def _write_circle_equation(point: str, circle: Call, instance: Instance) -> str:
    """(x - a)^2 + (y - b)^2 = r^2 in symbols."""
    centre = instance.axes.pair(circle.arguments[0]) or _NOTHING
    left = plus(
        square(minus(_write_coordinate_formula(instance, "x", point), centre[0])),
        square(minus(_write_coordinate_formula(instance, "y", point), centre[1])),
    )
    return f"{instance.symbolic(left)} &= {instance.symbolic(square(circle.arguments[1]))}"


def _explain_circles(
    point: str, circles: tuple[Call, Call], instance: Instance, language: Language
) -> tuple[Block, ...]:
    """The third corner of a triangle with known sides, by the law of cosines."""
    words = load_position_words(language)
    (first, radius), (second, _) = (circle.arguments for circle in circles)
    left = _turns_left(point, first, second, instance)
    texts = {
        "point": instance.symbols[point],
        "first": instance.symbolic(first),
        "second": instance.symbolic(second),
    }
    sentence = words.circles_meet.format(
        point=texts["point"],
        first=_describe_circle(circles[0], instance, words),
        second=_describe_circle(circles[1], instance, words),
        side=(words.on_the_left if left else words.on_the_right).format(**texts),
    )
    axis = Call("distance", (first, second))
    corner = instance.free("corner")
    cosine = _solve_for_cosine(radius, circles[1].arguments[1], axis)
    opened = instance.named(
        corner,
        rf"\angle {texts['second']}{texts['first']}{texts['point']}",
        instance.value(Call("acos", (cosine,))),
    )
    towards = Call("direction", (first, second))
    heading = (plus if left else minus)(towards, Name(corner))
    return (
        Prose(sentence + _write_between_sentences(language) + words.triangle.format(**texts)),
        Display(_solve_triangle(axis, cosine, corner, opened)),
        Prose(words.reached_along.format(sense=write_sense(language, left), **texts)),
        Display(
            (
                *_write_direction(towards, opened),
                *_write_placed_point(point, first, radius, heading, opened),
            )
        ),
    )


def _write_between_sentences(language: Language) -> str:
    """The separator between two sentences."""
    return _BETWEEN[language]


def _solve_for_cosine(radius: Expression, opposite: Expression, axis: Expression) -> Expression:
    """The law of cosines, solved for the cosine of the angle between `radius` and `axis`."""
    above = minus(plus(square(radius), square(axis)), square(opposite))
    return over(above, times(times(TWO, radius), axis))


def _solve_triangle(
    axis: Call, cosine: Expression, corner: str, instance: Instance
) -> tuple[str, ...]:
    """The side between the centres, the cosine, and the angle."""
    vector = instance.axes.pair(Operation("-", axis.arguments[1], axis.arguments[0])) or _NOTHING
    angle = instance.symbols[corner]
    return (
        *instance.equation(
            instance.symbolic(axis), length_of(Call("", vector), instance.axes), METRE
        ),
        *instance.equation(rf"\cos{angle}", cosine, PURE),
        *instance.equation(angle, Name(corner), DEGREE),
    )


def _write_direction(towards: Call, instance: Instance) -> tuple[str, ...]:
    """The direction from one centre to the other."""
    return instance.equation(instance.symbolic(towards), towards, DEGREE)


def _write_placed_point(
    point: str, centre: Expression, radius: Expression, heading: Expression, instance: Instance
) -> tuple[str, ...]:
    """The coordinates of a point at a distance from a centre in a direction."""
    pair = instance.axes.pair(Call("polar", (centre, radius, heading))) or _NOTHING
    return tuple(
        line
        for axis, tree in zip("xy", pair, strict=True)
        for line in instance.equation(_write_label(instance, axis, point), tree)
    )


def _turns_left(point: str, first: Expression, second: Expression, instance: Instance) -> bool:
    """Whether a point lies to the left of the directed line from the first to the second."""
    axes = instance.axes
    axis, arm = (
        axes.pair(Operation("-", second, first)),
        axes.pair(Operation("-", Name(point), first)),
    )
    return instance.sign(cross(axis or _NOTHING, arm or _NOTHING)) >= 0


def explain_foot(step: Step, instance: Instance, language: Language) -> tuple[Block, ...]:
    """The foot of a perpendicular, by the projection on the line."""
    words = load_position_words(language)
    source, line = list_parts(step.tree)
    if not isinstance(line, Call):
        return ()
    base, along = _make_unit_line(find_line(line, instance.axes), instance)
    place = instance.axes.pair(source) or _NOTHING
    sentence = words.foot.format(
        point=instance.symbols[step.point],
        from_=instance.symbolic(source),
        line=_describe_line(line, instance, words),
    )
    vector = describe_vector(Operation("-", source, line.arguments[0]), instance, words)
    reached = words.foot_reached.format(
        share=_choose_letter("s", instance),
        start=instance.symbolic(line.arguments[0]),
        vector=vector,
    )
    share = dot((minus(place[0], base[0]), minus(place[1], base[1])), along)
    return (
        Prose(sentence + _write_between_sentences(language) + reached),
        Display(_solve_along_line(step.point, base, along, share, instance)),
    )


def _write_coordinate_formula(instance: Instance, axis: str, point: str) -> Expression:
    """A coordinate of a named point as a formula."""
    return instance.axes.coordinate(axis, point)


def _write_label(instance: Instance, axis: str, point: str) -> str:
    """x_B or y_B, the left side of an equation."""
    return f"{axis}_{{{instance.symbols[point]}}}"
