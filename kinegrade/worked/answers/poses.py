"""How an answer about a pose follows from coordinates: coordinates, distances, components and
angles.

The last line ends with the answer from the key: its value is not worked out a second time.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import assert_never

from kinegrade.expressions.tree import Call, Expression, Name, Number, Operation
from kinegrade.language.math.tree import Row
from kinegrade.language.message import Message
from kinegrade.problem.quantities.functions import find_coordinate, find_motion_calls
from kinegrade.problem.quantity import Quantity
from kinegrade.problem.template.template import Ask
from kinegrade.worked.answers.pose_angles import find_angle, find_angle_between
from kinegrade.worked.answers.pose_working import AXIS_X, AXIS_Y, Working
from kinegrade.worked.case import Case
from kinegrade.worked.construction_steps import Step, unnest
from kinegrade.worked.document import Block, Display
from kinegrade.worked.formulas.atoms import Symbol
from kinegrade.worked.formulas.equation import Link, drop_repetition, equate
from kinegrade.worked.formulas.numbers import state_quantity
from kinegrade.worked.formulas.symbols import (
    INFINITY,
    join_letters,
    name_coordinate,
    read_symbol,
)
from kinegrade.worked.positions.algebra import ONE, cross, dot, minus, over
from kinegrade.worked.positions.algebra import ZERO as NOTHING
from kinegrade.worked.positions.axes import find_line, length_of
from kinegrade.worked.positions.constructions import write_chapter
from kinegrade.worked.positions.instance import DEGREE, METRE, Instance, add_steps, make_instance
from kinegrade.worked.positions.leaning_lengths import measure_along
from kinegrade.worked.vectors.arms import find_length_tree


def is_positional(ask: Ask) -> bool:
    """Whether an answer follows from positions alone."""
    return not any(find_motion_calls(ask.quantity))


def explain_pose_answers(case: Case, ask_names: Iterable[str]) -> tuple[Block, ...]:
    """The workings of answers for which `is_positional` holds, in order, from coordinates to each
    answer as it stands in the key; a length that two of them need is found once.

    In the units of the asks; angles counter-clockwise. Raises KeyError for an ask that was not
    solved.
    """
    blocks: tuple[Block, ...] = ()
    found: frozenset[Expression] = frozenset()
    plain = False
    for name in ask_names:
        if _has_been_placed(case.template.asks[name], case):
            continue
        more, found = _explain_one_answer(case, name, found)
        single = len(more) == 1
        blocks = _join_blocks(blocks, more) if plain and single else blocks + more
        plain = single
    return blocks


def _has_been_placed(ask: Ask, case: Case) -> bool:
    """Whether an answer is a length or a coordinate that the positions have given in its own
    letters.
    """
    lengths = (case.symbols[name] for name in case.template.scheme.lengths)
    if any(length.looks_like(read_symbol(ask.symbol)) for length in lengths):
        return True
    coordinate = find_coordinate(ask.quantity)
    if coordinate is None:
        return False
    axis, point = coordinate
    return name_coordinate(axis, case.naming.letter(point)).looks_like(read_symbol(ask.symbol))


def _explain_one_answer(
    case: Case, name: str, found: frozenset[Expression]
) -> tuple[tuple[Block, ...], frozenset[Expression]]:
    """The working of one answer given the known lengths `found`, and the lengths known after it."""
    ask, answer, instance = (
        case.template.asks[name],
        case.solution.answers[name],
        make_instance(case),
    )
    inner: list[Step] = []
    before = len(instance.steps) - len(case.template.scheme.points)
    tree = unnest(ask.quantity, inner, before, set(instance.values))
    symbol = read_symbol(ask.symbol)
    start = Working(add_steps(instance, inner), symbol if isinstance(tree, Call) else None, found)
    final, working = _reduce(tree, start)
    last = (Display(_write_last_line(symbol, final, answer, working.instance)),)
    blocks = write_chapter(inner, start.instance) + _join_blocks(working.blocks, last)
    return blocks, working.found


def _join_blocks(blocks: tuple[Block, ...], more: tuple[Block, ...]) -> tuple[Block, ...]:
    """Blocks in order; two adjacent displays become one."""
    if blocks and isinstance(blocks[-1], Display) and isinstance(more[0], Display):
        return (*blocks[:-1], Display(blocks[-1].lines + more[0].lines), *more[1:])
    return blocks + more


def _write_last_line(
    symbol: Symbol, tree: Expression, answer: Quantity, instance: Instance
) -> tuple[Row, ...]:
    """symbol = formula = numbers = the answer."""
    angular = answer.unit in ("deg", "rad")
    working = instance.worked_out(symbol, tree, angular)
    if answer.at_infinity:
        return instance.lines(symbol, (*working, *equate(INFINITY)))
    value = _state_in_both_units(answer, instance)
    return instance.lines(symbol, drop_repetition(working, value))


def _state_in_both_units(answer: Quantity, instance: Instance) -> tuple[Link, ...]:
    """The answer, a length in centimetres or millimetres also in metres, and an angle in radians
    also in degrees.
    """
    value, unit = state_quantity(answer), answer.measure
    prefixed = unit.length == 1 and not unit.is_si
    if answer.is_zero or not (unit.text == "rad" or prefixed):
        return value
    other = DEGREE if unit.text == "rad" else METRE
    *_, first = state_quantity(instance.quantity(answer.number * unit.scale.rational, other))
    if first.relation == "=":
        return (first, *value)
    return (*value[:-1], first, Link(r"\approx", value[-1].right))


def _reduce(tree: Expression, working: Working) -> tuple[Expression, Working]:
    """The expression in coordinates, lengths and angles, and what had to be worked out for it."""
    match tree:
        case Operation():
            left, working = _reduce(tree.left, working)
            right, working = _reduce(tree.right, working)
            return Operation(tree.sign, left, right), working
        case Call(function="x" | "y", arguments=(vector,)):
            return working.pair(vector)[0 if tree.function == "x" else 1], working
        case Call(function="distance", arguments=(point, other)):
            return _reduce_distance(point, other, working)
        case Call(function="magnitude", arguments=(vector,)):
            return _reduce_length(vector, working)
        case Call(function="along", arguments=(vector, direction)):
            return _reduce_component(vector, direction, working)
        case Call(function="angle", arguments=(first, second)):
            return find_angle(first, second, working)
        case Call(function="direction", arguments=(start, end)):
            return find_angle(Call("", AXIS_X), Operation("-", end, start), working)
        case Call(function="between", arguments=(first, second)):
            return find_angle_between(first, second, working)
        case Call():
            return _reduce_function(tree, working)
        case Number() | Name():
            return tree, working
        case _:
            assert_never(tree)


def _reduce_function(tree: Call, working: Working) -> tuple[Expression, Working]:
    """An elementary function of its worked-out arguments."""
    parts: list[Expression] = []
    working = replace(working, symbol=None)
    for argument in tree.arguments:
        part, working = _reduce(argument, working)
        parts.append(part)
    return Call(tree.function, tuple(parts)), working


def _reduce_distance(
    point: Expression, other: Expression, working: Working
) -> tuple[Expression, Working]:
    """The distance of two points, or of a point from a line."""
    if not (isinstance(other, Call) and other.function == "line"):
        return _reduce_length(Operation("-", other, point), working)
    axes = working.instance.axes
    (base, along), place = find_line(other, axes), working.pair(point)
    apart = minus(place[0], base[0]), minus(place[1], base[1])
    given_by_angle = not axes.is_vector(other.arguments[1])
    size = ONE if given_by_angle else length_of(Call("", along), axes)
    return over(Call("abs", (cross(along, apart),)), size), working


def _reduce_length(vector: Expression, working: Working) -> tuple[Expression, Working]:
    """The length of a vector: as a formula where it is the answer, else worked out before."""
    size = length_of(vector, working.instance.axes)
    if working.symbol:
        return _measure_vector(vector, working), working
    lines, working = working.sized(size)
    return size, working.shown(lines)


def _measure_vector(vector: Expression, working: Working) -> Expression:
    """The length that is the answer itself: by its name where the template has one, by an angle of
    the line where one is given.
    """
    instance = working.instance
    match vector:
        case Operation("-", Name(end), Name(start)) if {start, end} <= {
            *instance.case.motion.points
        }:
            letters = join_letters(map(instance.case.naming.letter, (start, end)))
            if working.symbol and working.symbol.looks_like(letters):
                instance.note_distance(Call("distance", (Name(start), Name(end))))
            named = find_length_tree(start, end, instance.case)
            if isinstance(named, Name) and named.name in instance.case.template.scheme.lengths:
                return named
            along = measure_along(start, end, instance)
        case Operation() | Call() | Name() | Number():
            along = None
        case _:
            assert_never(vector)
    return along or instance.measure(working.pair(vector))


def _reduce_component(
    vector: Expression, direction: Expression, working: Working
) -> tuple[Expression, Working]:
    """The scalar product divided by the length of the second vector."""
    size = length_of(direction, working.instance.axes)
    axis = {AXIS_X: "x", AXIS_Y: "y"}.get(working.pair(vector))
    towards = working.phrase(direction)
    if axis is None:
        along = working.phrase(vector)
        sentence = Message("solution.component", vector=along, direction=towards)
    else:
        sentence = Message("solution.axis-component", axis=axis, direction=towards)
    product = dot(working.pair(vector), working.pair(direction))
    lines, working = working.sized(size) if product != NOTHING else ((), working)
    return over(product, size), working.said(sentence).shown(lines)
