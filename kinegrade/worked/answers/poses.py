"""How an answer about a pose follows from coordinates: coordinates, distances, components and
angles.

The last line ends with the answer from the key: its value is not worked out a second time.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from typing import assert_never

from kinegrade.expressions.expression import Call, Expression, Name, Number, Operation
from kinegrade.language import Language
from kinegrade.language.message import Message
from kinegrade.numbers.units import Unit
from kinegrade.problem.quantities.functions import find_motion_calls
from kinegrade.problem.quantity import LONGEST_CLOSED_FORM, Quantity
from kinegrade.problem.solving import Solution
from kinegrade.problem.template.template import Ask
from kinegrade.worked.document import Block, Display, say
from kinegrade.worked.formulas.coordinates import (
    ONE,
    ZERO,
    Pair,
    Step,
    cross,
    dot,
    find_line,
    length_of,
    minus,
    over,
    times,
    unnest,
)
from kinegrade.worked.formulas.instance import (
    AREA,
    DEGREE,
    METRE,
    PURE,
    Instance,
    Part,
    add_steps,
    drop_repetition,
    make_instance,
    write_result,
)
from kinegrade.worked.formulas.pieces import write_operator
from kinegrade.worked.formulas.width import chain_lines
from kinegrade.worked.positions.constructions import write_chapter, write_length_lines

_AXIS_X, _AXIS_Y = (ONE, ZERO), (ZERO, ONE)
_AXES: Mapping[Pair, Message] = {
    _AXIS_X: Message("solution.x-axis"),
    _AXIS_Y: Message("solution.y-axis"),
}
_QUADRANTS: Mapping[tuple[int, int], Message] = {  # by the signs of the cosine and of the sine
    (1, 1): Message("solution.first-quadrant"),
    (-1, 1): Message("solution.second-quadrant"),
    (-1, -1): Message("solution.third-quadrant"),
    (1, -1): Message("solution.fourth-quadrant"),
    (1, 0): Message("solution.angle-zero"),
    (-1, 0): Message("solution.angle-straight"),
    (0, 1): Message("solution.angle-right"),
    (0, -1): Message("solution.angle-minus-right"),
}


def is_positional(ask: Ask) -> bool:
    """Whether an answer follows from positions alone."""
    return not any(find_motion_calls(ask.quantity))


def explain_pose_answers(
    solution: Solution, ask_names: Iterable[str], language: Language
) -> tuple[Block, ...]:
    """The workings of answers for which `is_positional` holds, in order, from coordinates to each
    answer as it stands in the key; a length that two of them need is found once.

    In the units of the asks; angles counter-clockwise. Raises KeyError for an ask that was not
    solved.
    """
    blocks: tuple[Block, ...] = ()
    found: frozenset[Expression] = frozenset()
    plain = False
    for name in ask_names:
        more, found = _explain_one_answer(solution, name, language, found)
        single = len(more) == 1
        blocks = _join_blocks(blocks, more) if plain and single else blocks + more
        plain = single
    return blocks


def _explain_one_answer(
    solution: Solution, name: str, language: Language, found: frozenset[Expression]
) -> tuple[tuple[Block, ...], frozenset[Expression]]:
    """The working of one answer given the known lengths `found`, and the lengths known after it."""
    ask, answer, instance = (
        solution.template.asks[name],
        solution.answers[name],
        make_instance(solution),
    )
    inner: list[Step] = []
    tree = unnest(
        ask.quantity,
        inner,
        len(instance.steps) - len(solution.template.scheme.points),
        set(instance.values),
    )
    symbol = ask.symbol if isinstance(tree, Call) else ""
    start = _Working(add_steps(instance, inner), language, symbol, found)
    final, working = start.reduced(tree)
    last = (Display(_write_last_line(ask.symbol, final, answer, working.instance)),)
    return write_chapter(inner, start.instance, language) + _join_blocks(
        working.blocks, last
    ), working.found


def _join_blocks(blocks: tuple[Block, ...], more: tuple[Block, ...]) -> tuple[Block, ...]:
    """Blocks in order; two adjacent displays become one."""
    if blocks and isinstance(blocks[-1], Display) and isinstance(more[0], Display):
        return (*blocks[:-1], Display(blocks[-1].lines + more[0].lines), *more[1:])
    return blocks + more


def _write_last_line(
    symbol: str, tree: Expression, answer: Quantity, instance: Instance
) -> tuple[str, ...]:
    """symbol = formula = numbers = the answer."""
    worked = instance.worked_out(symbol, tree, answer.measure.degrees)
    if answer.at_infinity:
        return chain_lines(symbol, (*worked, ("=", r"\infty")))
    return chain_lines(
        symbol, drop_repetition(worked, _write_in_both_units(tree, answer, instance))
    )


def _write_in_both_units(
    tree: Expression, answer: Quantity, instance: Instance
) -> tuple[Part, ...]:
    """The answer, a length in centimetres or millimetres also in metres, and an angle in radians
    also in degrees.
    """
    written, unit = write_result(answer, LONGEST_CLOSED_FORM), answer.measure
    if answer.is_zero or not (
        unit.text == "rad" or (unit.length == 1 and unit.factor != METRE.factor)
    ):
        return written
    other = write_result(
        instance.quantity(answer.number * unit.factor, DEGREE if unit.text == "rad" else METRE)
    )[0]
    return (
        (other, *written)
        if other[0] == "="
        else (*written[:-1], other, (r"\approx", written[-1][1]))
    )


@dataclass(frozen=True)
class _Working:
    """The blocks written so far, and the lengths found.

    `symbol` is that of the answer where the answer is itself the quantity worked out, else "".
    """

    instance: Instance
    language: Language
    symbol: str
    found: frozenset[Expression] = frozenset()
    blocks: tuple[Block, ...] = ()

    def said(self, sentence: Message) -> _Working:
        """The working with one more sentence."""
        return replace(self, blocks=(*self.blocks, say(sentence, self.language)))

    def shown(self, lines: tuple[str, ...]) -> _Working:
        """The working with some more equations, or none."""
        return replace(self, blocks=(*self.blocks, Display(lines))) if lines else self

    def pair(self, vector: Expression) -> Pair:
        """The coordinates of a vector as formulas."""
        return self.instance.axes.pair(vector) or (ZERO, ZERO)

    def reduced(self, tree: Expression) -> tuple[Expression, _Working]:
        """The expression in coordinates, lengths and angles, and what had to be worked out for
        it.
        """
        match tree:
            case Operation():
                left, working = self.reduced(tree.left)
                right, working = working.reduced(tree.right)
                return Operation(tree.sign, left, right), working
            case Call(function="x" | "y", arguments=(vector,)):
                return self.pair(vector)[0 if tree.function == "x" else 1], self
            case Call(function="distance", arguments=(point, other)):
                return self.distance(point, other)
            case Call(function="magnitude", arguments=(vector,)):
                return self.length(vector)
            case Call(function="along", arguments=(vector, direction)):
                return self.component(vector, direction)
            case Call(function="angle", arguments=(first, second)):
                return self.angle(first, second)
            case Call(function="direction", arguments=(start, end)):
                return self.angle(Call("", _AXIS_X), Operation("-", end, start))
            case Call(function="between", arguments=(first, second)):
                return self.between(first, second)
            case Call():
                return self.function(tree)
            case Number() | Name():
                return tree, self
            case _:
                assert_never(tree)

    def function(self, tree: Call) -> tuple[Expression, _Working]:
        """An elementary function of its worked-out arguments."""
        parts: list[Expression] = []
        working = replace(self, symbol="")
        for argument in tree.arguments:
            part, working = working.reduced(argument)
            parts.append(part)
        return Call(tree.function, tuple(parts)), working

    def distance(self, point: Expression, other: Expression) -> tuple[Expression, _Working]:
        """The distance of two points, or of a point from a line."""
        if not (isinstance(other, Call) and other.function == "line"):
            return self.length(Operation("-", other, point))
        (base, along), place = find_line(other, self.instance.axes), self.pair(point)
        apart = minus(place[0], base[0]), minus(place[1], base[1])
        given_by_angle = not self.instance.axes.is_vector(other.arguments[1])
        size = ONE if given_by_angle else length_of(Call("", along), self.instance.axes)
        return over(Call("abs", (cross(along, apart),)), size), self

    def length(self, vector: Expression) -> tuple[Expression, _Working]:
        """The length of a vector: as a formula where it is the answer, else worked out before."""
        size = length_of(vector, self.instance.axes)
        if self.symbol:
            return length_of(Call("", self.pair(vector)), self.instance.axes), self
        lines, working = self.sized(size)
        return size, working.shown(lines)

    def component(self, vector: Expression, direction: Expression) -> tuple[Expression, _Working]:
        """The scalar product divided by the length of the second vector."""
        size = length_of(direction, self.instance.axes)
        axis = {_AXIS_X: "x", _AXIS_Y: "y"}.get(self.pair(vector))
        towards = self._phrase(direction)
        if axis is None:
            along = self._phrase(vector)
            sentence = Message("solution.component", vector=along, direction=towards)
        else:
            sentence = Message("solution.axis-component", axis=axis, direction=towards)
        product = dot(self.pair(vector), self.pair(direction))
        lines, working = self.sized(size) if product != ZERO else ((), self)
        return over(product, size), working.said(sentence).shown(lines)

    def sized(self, *sizes: Expression) -> tuple[tuple[str, ...], _Working]:
        """The equations of lengths that are not known yet."""
        fresh = [size for size in dict.fromkeys(sizes) if size not in self.found]
        lines = tuple(line for size in fresh for line in write_length_lines(size, self.instance))
        return lines, replace(self, found=self.found | set(fresh))

    def _phrase(self, vector: Expression, letter: str = "") -> Message:
        """A vector in a sentence, with the letter that denotes it."""
        axis = _AXES.get(self.pair(vector))
        if axis is not None and isinstance(vector, Call) and not vector.function:
            return axis
        if isinstance(vector, Call) and vector.function == "turned":
            written = Message("solution.vector-turned", vector=self._phrase(vector.arguments[0]))
        else:
            written = Message("solution.vector", vector=self.instance.symbolic(vector))
        if not letter:
            return written
        return Message("solution.vector-called", vector=written, letter=letter)

    def lettered(self, letter: str, vector: Expression) -> tuple[Pair, tuple[str, ...], Instance]:
        """The components of a vector under a new letter, and their equations."""
        instance, names, lines = self.instance, list[Expression](), list[str]()
        for axis, part in zip("xy", self.pair(vector), strict=True):
            name = instance.free(f"{letter}_{axis}")
            instance = instance.named(name, f"{letter}_{{{axis}}}", instance.value(part))
            lines += instance.equation(f"{letter}_{{{axis}}}", part)
            names.append(Name(name))
        return (names[0], names[1]), tuple(lines), instance

    def angle(self, first: Expression, second: Expression) -> tuple[Expression, _Working]:
        """The angle from one vector to another: its cosine and sine up to a factor, its tangent,
        its quadrant.
        """
        if self.pair(first) in (_AXIS_X, _AXIS_Y):
            return self.angle_from_axis(first, second)
        start, lines, instance = self.lettered("u", first)
        end, more, instance = replace(self, instance=instance).lettered("v", second)
        sentence = Message(
            "solution.angle-of-vectors",
            first=self._phrase(first, "u"),
            second=self._phrase(second, "v"),
        )
        label = self.symbol or r"\angle(\boldsymbol{u}, \boldsymbol{v})"
        return replace(self, instance=instance).settled(
            label, sentence, lines + more, (start, end), AREA
        )

    def angle_from_axis(self, first: Expression, second: Expression) -> tuple[Expression, _Working]:
        """The angle from an axis: cosine and sine are proportional to coordinates of the other
        vector.
        """
        start, end = self.pair(first), self.pair(second)
        axis = "x" if start == _AXIS_X else "y"
        simple = (
            isinstance(second, Operation)
            and isinstance(second.left, Name)
            and isinstance(second.right, Name)
        )
        other = self.instance.symbolic(second) if simple else r"\boldsymbol{v}"
        phrase = self._phrase(second, "" if simple or self.symbol else "v")
        sentence = Message("solution.angle-from-axis", first=self._phrase(first), second=phrase)
        return self.settled(
            self.symbol or rf"\angle({axis}, {other})", sentence, (), (start, end), METRE
        )

    def settled(
        self,
        label: str,
        sentence: Message,
        lines: tuple[str, ...],
        vectors: tuple[Pair, Pair],
        unit: Unit,
    ) -> tuple[Expression, _Working]:
        """The angle from one vector to another, whose products have the given unit."""
        cosine, sine = dot(*vectors), cross(*vectors)
        lines += self.instance.proportion(write_operator(r"\cos", label), cosine, unit)
        lines += self.instance.proportion(write_operator(r"\sin", label), sine, unit)
        signs = self.instance.sign(cosine), self.instance.sign(sine)
        if signs[0] and signs[1]:
            lines += self._tangent(label, cosine, sine)
        name = self.instance.free("angle")
        instance = self.instance.named(
            name, label, self.instance.value(Call("atan2", (sine, cosine)))
        )
        working = replace(self, instance=instance).said(sentence).shown(lines)
        return Name(name), working.said(_QUADRANTS[signs])

    def _tangent(self, label: str, cosine: Expression, sine: Expression) -> tuple[str, ...]:
        """The tangent of an angle, from its sine and cosine up to their common factor."""
        names = self.instance.free("sine"), self.instance.free("cosine")
        instance = self.instance.named(
            names[0], write_operator(r"\sin", label), self.instance.value(sine)
        )
        instance = instance.named(
            names[1], write_operator(r"\cos", label), self.instance.value(cosine)
        )
        return instance.equation(
            write_operator(r"\tan", label), over(Name(names[0]), Name(names[1])), PURE
        )

    def between(self, first: Expression, second: Expression) -> tuple[Expression, _Working]:
        """The angle between two vectors, from its cosine."""
        pairs = self.pair(first), self.pair(second)
        sizes = [length_of(vector, self.instance.axes) for vector in (first, second)]
        product, area = dot(*pairs), Call("abs", (cross(*pairs),))
        label = self.symbol or r"\angle(\boldsymbol{u}, \boldsymbol{v})"
        letters = ("", "") if self.symbol else ("u", "v")
        lines, working = self.sized(*sizes)
        lines += self.instance.equation(
            write_operator(r"\cos", label), over(product, times(*sizes)), PURE
        )
        sentence = Message(
            "solution.angle-between",
            first=self._phrase(first, letters[0]),
            second=self._phrase(second, letters[1]),
        )
        name = self.instance.free("angle")
        instance = self.instance.named(
            name, label, self.instance.value(Call("atan2", (area, product)))
        )
        return Name(name), replace(working, instance=instance).said(sentence).shown(lines)
