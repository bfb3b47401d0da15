"""Intersections of lines and circles, and feet of perpendiculars: the equations and how they are
solved.

A line along an axis gives a coordinate at once; a slanting one is parametrised by the distance s
from its given point. Two circles are solved in the triangle of their centres and the point.
"""

from __future__ import annotations

from collections.abc import Mapping

from kinegrade.expression import Call, Expression, Name, Operation, parts
from kinegrade.language import Language
from kinegrade.problem.notation import symbol
from kinegrade.worked.coordinates import (
    ONE,
    TWO,
    ZERO,
    Pair,
    Step,
    cross,
    dot,
    length_of,
    line_of,
    minus,
    over,
    plus,
    root,
    square,
    times,
)
from kinegrade.worked.document import Block, Display, Prose
from kinegrade.worked.formula_text import quarter_turns
from kinegrade.worked.instance_formulas import AREA, DEGREE, METRE, PURE, Instance
from kinegrade.worked.position_words import PositionWords, position_words, sense
from kinegrade.worked.vector_words import vector_words

Line = tuple[Pair, Pair]  # a point and a direction
NOTHING: Pair = (ZERO, ZERO)
BETWEEN: Mapping[Language, str] = {"en": " ", "zh": ""}


def meeting_blocks(step: Step, instance: Instance, language: Language) -> tuple[Block, ...]:
    """The point in which two lines, a line and a circle, or two circles meet."""
    first, second, *branch = parts(step.tree)
    side = branch[0].name if branch and isinstance(branch[0], Name) else ""
    if not (isinstance(first, Call) and isinstance(second, Call)):
        return ()
    circles = [shape for shape in (first, second) if shape.function == "circle"]
    lines = [shape for shape in (first, second) if shape.function == "line"]
    if len(circles) == 2:
        return circles_blocks(step.point, (first, second), instance, language)
    words = position_words(language)
    if len(lines) == 2:
        return two_lines_blocks(step.point, (first, second), instance, language)
    sentence = words.line_meets_circle.format(
        point=instance.symbols[step.point],
        side=words.sides.get(side, ""),
        line=line_words(lines[0], instance, words),
        circle=circle_words(circles[0], instance, words),
    )
    if ZERO not in line_of(lines[0], instance.axes)[1]:
        sentence += between_sentences(language) + along_words(words.quadratic, lines[0], instance)
    return Prose(sentence), *line_and_circle(step.point, lines[0], circles[0], instance)


def two_lines_blocks(
    point: str, lines: tuple[Call, Call], instance: Instance, language: Language
) -> tuple[Block, ...]:
    """The point in which two lines meet; of two slanting lines the first is parametrised."""
    words = position_words(language)
    sentence = words.lines_meet.format(
        point=instance.symbols[point],
        first=line_words(lines[0], instance, words),
        second=line_words(lines[1], instance, words),
    )
    first, second = (line_of(line, instance.axes) for line in lines)
    if ZERO in first[1] + second[1]:
        return Prose(sentence), Display(two_lines(point, first, second, instance))
    sentence += between_sentences(language) + along_words(words.along_first, lines[0], instance)
    return Prose(sentence), Display(
        two_slanting(point, unit_line(first, instance), second, instance)
    )


def along_words(sentence: str, line: Call, instance: Instance) -> str:
    """A sentence on the distance along a line from its given point."""
    return sentence.format(share=letter("s", instance), start=instance.symbolic(line.arguments[0]))


def line_words(line: Call, instance: Instance, words: PositionWords) -> str:
    """A line in a sentence."""
    start, toward = line.arguments
    texts = {"point": instance.symbolic(start), "angle": instance.symbolic(toward, degrees=True)}
    if instance.axes.is_vector(toward):
        return words.line_between.format(first=texts["point"], second=instance.symbolic(toward))
    quarters, place = quarter_turns(toward), instance.axes.pair(start)
    if quarters is None:
        return words.slanting_line.format(**texts)
    level = quarters % 2 == 0
    if place is not None and place[1 if level else 0] == ZERO:
        return words.x_axis if level else words.y_axis
    return (words.level_line if level else words.upright_line).format(**texts)


def circle_words(circle: Call, instance: Instance, words: PositionWords) -> str:
    """A circle in a sentence."""
    centre, radius = circle.arguments
    return words.circle.format(centre=instance.symbolic(centre), radius=instance.symbolic(radius))


def two_lines(point: str, first: Line, second: Line, instance: Instance) -> tuple[str, ...]:
    """Both coordinates, from a line along an axis and the other line."""
    (base, along), (other, across) = (first, second) if ZERO in first[1] else (second, first)
    level = along[1] == ZERO
    known, sought = ("y", "x") if level else ("x", "y")
    place, slope = (1, over(across[0], across[1])) if level else (0, over(across[1], across[0]))
    rise = minus(coordinate(instance, known, point), other[place])
    return (
        *instance.equation(label(instance, known, point), base[place]),
        *instance.equation(
            label(instance, sought, point), plus(other[1 - place], product(rise, slope))
        ),
    )


def product(rise: Expression, slope: Expression) -> Expression:
    """rise * slope, the slope a quotient, as one fraction."""
    if isinstance(slope, Operation) and slope.sign == "/":
        return over(times(rise, slope.left), slope.right)
    return times(rise, slope)


def two_slanting(point: str, first: Line, second: Line, instance: Instance) -> tuple[str, ...]:
    """The distance s along the first line from its point, then both coordinates."""
    (base, along), (other, across) = first, second
    apart = minus(other[0], base[0]), minus(other[1], base[1])
    share = over(cross(apart, across), cross(along, across))
    return run_along(point, base, along, share, instance)


def letter(name: str, instance: Instance) -> str:
    """The symbol of an auxiliary quantity, numbered where the template already uses that letter."""
    return symbol(instance.free(name))


def run_along(
    point: str, base: Pair, along: Pair, share: Expression, instance: Instance
) -> tuple[str, ...]:
    """s worked out, then the coordinates of the point at s from the line's given point."""
    name = instance.free("s")
    further = instance.named(name, symbol(name), instance.value(share))
    step = Name(name)
    lines = further.equation(further.symbolic(step), share)
    for axis, start, part in zip("xy", base, along, strict=True):
        lines += further.equation(label(further, axis, point), plus(start, times(step, part)))
    return lines


def line_and_circle(
    point: str, line: Call, circle: Call, instance: Instance
) -> tuple[Display, ...]:
    """The circle's equation and its solution on the line, each aligned separately."""
    (base, along), centre = (
        line_of(line, instance.axes),
        instance.axes.pair(circle.arguments[0]) or NOTHING,
    )
    radius = circle.arguments[1]
    equation = circle_equation(point, circle, instance)
    if ZERO in along:
        level = along[1] == ZERO
        known, sought, place = ("y", "x", 1) if level else ("x", "y", 0)
        rise = minus(coordinate(instance, known, point), centre[place])
        reach = root(minus(square(radius), square(rise)))
        beyond = instance.sign(minus(Call(sought, (Name(point),)), centre[1 - place]))
        solved = (minus if beyond < 0 else plus)(centre[1 - place], reach)
        return Display((equation,)), Display(
            (
                *instance.equation(label(instance, known, point), base[place]),
                *instance.equation(label(instance, sought, point), solved),
            )
        )
    quadratic, *solution = slanting_chord(point, (base, along), (centre, radius), instance)
    return Display((equation,)), Display((quadratic,)), Display(tuple(solution))


def slanting_chord(
    point: str, line: Line, circle: tuple[Pair, Expression], instance: Instance
) -> tuple[str, ...]:
    """s from s^2 + 2ps + q = 0, then both coordinates."""
    (base, along), (centre, radius) = unit_line(line, instance), circle
    offset = minus(base[0], centre[0]), minus(base[1], centre[1])
    middle, rest = (
        dot(offset, along),
        minus(plus(square(offset[0]), square(offset[1])), square(radius)),
    )
    first, second = instance.free("p"), instance.free("q")
    further = instance.named(first, symbol(first), instance.value(middle))
    further = further.named(second, symbol(second), instance.value(rest))
    place = Call("x", (Name(point),)), Call("y", (Name(point),))
    run = dot((minus(place[0], base[0]), minus(place[1], base[1])), along)
    ahead = further.sign(plus(run, middle))
    reach = root(minus(square(Name(first)), Name(second)))
    share = (minus if ahead < 0 else plus)(minus(ZERO, Name(first)), reach)
    return (
        rf"{letter('s', instance)}^{{2}} + 2\,{symbol(first)}\,{letter('s', instance)} + "
        rf"{symbol(second)} &= 0",
        *further.equation(symbol(first), middle),
        *further.equation(symbol(second), rest, AREA),
        *run_along(point, base, along, share, further),
    )


def unit_line(line: Line, instance: Instance) -> Line:
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


def circle_equation(point: str, circle: Call, instance: Instance) -> str:
    """(x - a)^2 + (y - b)^2 = r^2 in symbols."""
    centre = instance.axes.pair(circle.arguments[0]) or NOTHING
    left = plus(
        square(minus(coordinate(instance, "x", point), centre[0])),
        square(minus(coordinate(instance, "y", point), centre[1])),
    )
    return f"{instance.symbolic(left)} &= {instance.symbolic(square(circle.arguments[1]))}"


def circles_blocks(
    point: str, circles: tuple[Call, Call], instance: Instance, language: Language
) -> tuple[Block, ...]:
    """The third corner of a triangle with known sides, by the law of cosines."""
    words = position_words(language)
    (first, radius), (second, _) = (circle.arguments for circle in circles)
    left = turns_left(point, first, second, instance)
    texts = {
        "point": instance.symbols[point],
        "first": instance.symbolic(first),
        "second": instance.symbolic(second),
    }
    sentence = words.circles_meet.format(
        point=texts["point"],
        first=circle_words(circles[0], instance, words),
        second=circle_words(circles[1], instance, words),
        side=(words.on_the_left if left else words.on_the_right).format(**texts),
    )
    axis = Call("distance", (first, second))
    corner = instance.free("corner")
    cosine = cosine_at(radius, circles[1].arguments[1], axis)
    opened = instance.named(
        corner,
        rf"\angle {texts['second']}{texts['first']}{texts['point']}",
        instance.value(Call("acos", (cosine,))),
    )
    towards = Call("direction", (first, second))
    heading = (plus if left else minus)(towards, Name(corner))
    return (
        Prose(sentence + between_sentences(language) + words.triangle.format(**texts)),
        Display(triangle_lines(axis, cosine, corner, opened)),
        Prose(words.reached_along.format(sense=sense(language, left), **texts)),
        Display((*direction_line(towards, opened), *placed(point, first, radius, heading, opened))),
    )


def between_sentences(language: Language) -> str:
    """The separator between two sentences."""
    return BETWEEN[language]


def cosine_at(radius: Expression, opposite: Expression, axis: Expression) -> Expression:
    """The law of cosines, solved for the cosine of the angle between `radius` and `axis`."""
    above = minus(plus(square(radius), square(axis)), square(opposite))
    return over(above, times(times(TWO, radius), axis))


def triangle_lines(
    axis: Call, cosine: Expression, corner: str, instance: Instance
) -> tuple[str, ...]:
    """The side between the centres, the cosine, and the angle."""
    vector = instance.axes.pair(Operation("-", axis.arguments[1], axis.arguments[0])) or NOTHING
    angle = instance.symbols[corner]
    return (
        *instance.equation(
            instance.symbolic(axis), length_of(Call("", vector), instance.axes), METRE
        ),
        *instance.equation(rf"\cos{angle}", cosine, PURE),
        *instance.equation(angle, Name(corner), DEGREE),
    )


def direction_line(towards: Call, instance: Instance) -> tuple[str, ...]:
    """The direction from one centre to the other."""
    return instance.equation(instance.symbolic(towards), towards, DEGREE)


def placed(
    point: str, centre: Expression, radius: Expression, heading: Expression, instance: Instance
) -> tuple[str, ...]:
    """The coordinates of a point at a distance from a centre in a direction."""
    pair = instance.axes.pair(Call("polar", (centre, radius, heading))) or NOTHING
    return tuple(
        line
        for axis, tree in zip("xy", pair, strict=True)
        for line in instance.equation(label(instance, axis, point), tree)
    )


def turns_left(point: str, first: Expression, second: Expression, instance: Instance) -> bool:
    """Whether a point lies to the left of the directed line from the first to the second."""
    axes = instance.axes
    axis, arm = (
        axes.pair(Operation("-", second, first)),
        axes.pair(Operation("-", Name(point), first)),
    )
    return instance.sign(cross(axis or NOTHING, arm or NOTHING)) >= 0


def foot_blocks(step: Step, instance: Instance, language: Language) -> tuple[Block, ...]:
    """The foot of a perpendicular, by the projection on the line."""
    words = position_words(language)
    source, line = parts(step.tree)
    if not isinstance(line, Call):
        return ()
    base, along = unit_line(line_of(line, instance.axes), instance)
    place = instance.axes.pair(source) or NOTHING
    sentence = words.foot.format(
        point=instance.symbols[step.point],
        from_=instance.symbolic(source),
        line=line_words(line, instance, words),
    )
    vector = vector_words(Operation("-", source, line.arguments[0]), instance, words)
    reached = words.foot_reached.format(
        share=letter("s", instance), start=instance.symbolic(line.arguments[0]), vector=vector
    )
    share = dot((minus(place[0], base[0]), minus(place[1], base[1])), along)
    return (
        Prose(sentence + between_sentences(language) + reached),
        Display(run_along(step.point, base, along, share, instance)),
    )


def coordinate(instance: Instance, axis: str, point: str) -> Expression:
    """A coordinate of a named point as a formula."""
    return instance.axes.coordinate(axis, point)


def label(instance: Instance, axis: str, point: str) -> str:
    """x_B or y_B, the left side of an equation."""
    return f"{axis}_{{{instance.symbols[point]}}}"
