"""From the rates to the answers: the last lines of a solution, with the values of the key."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any, assert_never

from kinegrade.expressions.expression import Call, Expression, Name, Number, Operation, evaluate
from kinegrade.language.message import Message
from kinegrade.mechanics.joints import GROUND
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.kinds.kinds import Scalar
from kinegrade.problem.quantities.functions import find_motion_calls, make_quantities
from kinegrade.problem.quantities.motion_functions import MOTION_FUNCTIONS
from kinegrade.problem.quantities.reader import MotionReader, find_body_names
from kinegrade.problem.template.template import Ask
from kinegrade.worked.answers.asked_vectors import (
    Facts,
    explain_prerequisites,
    find_level,
    is_rotation_call,
    is_vector_call,
)
from kinegrade.worked.answers.centrodes import explain_centrode
from kinegrade.worked.answers.stated_values import explain_value
from kinegrade.worked.document import Block, Display, Result
from kinegrade.worked.formulas.expression import collect_symbols, write_latex
from kinegrade.worked.formulas.numbers import (
    DIGITS,
    bearing,
    double,
    length,
    tidy,
    write_absolute_value,
    write_angle,
    write_bracketed,
    write_number,
    write_quantity,
    write_short,
    write_with_unit,
)
from kinegrade.worked.steps.deductions import write_with_cosine
from kinegrade.worked.steps.findings import Fact, Findings, Piece
from kinegrade.worked.steps.poles import explain_pole, name_pole
from kinegrade.worked.steps.scalars import find_rotation_value, write_rotation
from kinegrade.worked.steps.summands import NUMBER, write_component
from kinegrade.worked.words.senses import (
    describe_direction,
    find_rotation_sense,
    is_zero,
    write_beside_value,
)
from kinegrade.worked.words.solution_case import Case

_RIGHT = 1e-7  # degrees from a right angle that count as a right angle
_PREFIXED = re.compile(r"[cm]m(?=$|/|\^)")  # centimetres and millimetres, also per second
_MEASURES = frozenset({"magnitude", "x", "y", "along", "angle", "between"})


@dataclass(frozen=True)
class _Written:
    """A number in symbols, and with numbers substituted where that adds something."""

    symbols: str
    numbers: str = ""


def explain_answer(ask: Ask, case: Case, findings: Findings) -> Iterator[Block]:
    """How an answer follows from the results of the steps; not for answers that positions alone
    decide.
    """
    calls = tuple(find_motion_calls(ask.quantity))
    derivations = {MOTION_FUNCTIONS[call.function].derivation for call in calls}
    facts = Facts(case, findings, MotionReader(case.motion, case.arithmetic))
    if "centrode" in derivations:
        yield from explain_centrode(ask, case, findings)
        return
    if "value" in derivations:
        yield from explain_value(ask, calls, facts)
        return
    for call in calls:
        if call.function == "pole" and isinstance(call.arguments[0], Name):
            yield from explain_pole(call.arguments[0].name, case, findings)
    yield from explain_prerequisites(ask.quantity, facts)
    writer = _Writer(case, facts)
    written = writer.write(ask.quantity)
    if written.symbols == write_absolute_value(ask.symbol):
        yield Display((f"{written.symbols} &= {write_quantity(case.solution.answers[ask.name])}",))
    elif written.symbols == f"-{ask.symbol}":
        if double(case.solution.answers[ask.name].number):
            yield Display((_count_as_asked(ask, case),))
    elif written.symbols != ask.symbol:  # else a step has already given it
        yield Display((_write_last_line(ask, written, writer),))


def _count_as_asked(ask: Ask, case: Case) -> str:
    """An answer that a step has given under the same symbol with the opposite positive sense."""
    answer = case.solution.answers[ask.name]
    sign = "-" if double(answer.number) < 0 else ""
    return (
        f"{ask.symbol} &= {sign}{write_absolute_value(ask.symbol)} = {write_quantity(answer)}"
        f"{write_beside_value(Message('solution.as-asked'), case)}"
    )


def _write_last_line(ask: Ask, written: _Written, writer: _Writer) -> str:
    """The answer's symbol, its formula, its numbers and its value from the key; in SI first where
    the numbers give a value in centimetres or millimetres.
    """
    answer = writer.case.solution.answers[ask.name]
    between = [
        text for text in (written.symbols, written.numbers) if text not in ("", "0", ask.symbol)
    ]
    values = [write_quantity(answer)]
    if between and _PREFIXED.match(answer.unit):
        base = write_number(writer.value(ask.quantity), _PREFIXED.sub("m", answer.unit))
        values = [base, write_with_unit(answer.decimal(DIGITS), answer.unit)]
    return f"{ask.symbol} &= " + " = ".join([*between, *values])


@dataclass(frozen=True)
class _Writer:
    """Writes the quantity of an ask as a formula of quantities found before."""

    case: Case
    facts: Facts

    def write(self, tree: Expression) -> _Written:
        """An expression that is a number."""
        if isinstance(tree, Call):
            if tree.function in _MEASURES and tree.arguments and is_vector_call(tree.arguments[0]):
                return self.measured(tree)
            if is_rotation_call(tree):
                return self.rotation(tree)
        if isinstance(tree, Operation) and not isinstance(tree.left, Number):
            return self.combined(tree)
        if isinstance(tree, Operation) and tree.sign == "-":
            inner = self.write(tree.right)
            return _Written(f"-{inner.symbols}", f"-{inner.numbers}" if inner.numbers else "")
        return _Written(self._placed(tree))

    def measured(self, tree: Call) -> _Written:
        """The magnitude, a component or the direction of a vector of the motion."""
        fact = self.fact(tree.arguments[0])
        match tree.function:
            case "magnitude":
                return self.magnitude(fact)
            case "x" | "y":
                return self.axis(fact, tree.function)
            case "along":
                return self.along(fact, self.value(tree.arguments[1]))
            case "angle" | "between":
                return self.angle(tree)
            case _:
                raise ValueError(f"{tree.function} does not measure a vector")

    def fact(self, tree: Expression) -> Fact:
        """A vector that the solution has already found."""
        finding = self.facts.find(tree)
        while True:
            try:
                next(finding)
            except StopIteration as found:
                fact: Fact = found.value
                return fact

    def magnitude(self, fact: Fact) -> _Written:
        """The magnitude of a vector, from its components or its normal and tangential parts."""
        if fact.symbol in self.facts.findings.sized:
            return _Written(fact.symbol)
        if fact.by_components:
            shown = [axis for axis, number in zip("xy", fact.value, strict=True) if double(number)]
            names = [write_component(fact.symbol, axis) for axis in shown]
            if len(names) < 2:
                sign = "-" if double(sum(fact.value)) < 0 else ""
                return _Written(f"{sign}{names[0]}" if names else "0")
            numbers = [write_bracketed(write_short(number)) for number in fact.value]
            return _Written(
                rf"\sqrt{{{names[0]}^{{2}}+{names[1]}^{{2}}}}",
                rf"\sqrt{{{numbers[0]}^{{2}}+{numbers[1]}^{{2}}}}",
            )
        pieces = [piece for piece in fact.parts if double(piece.value.squared())] or fact.parts[:1]
        if len(pieces) > 1:
            return _Written(
                _write_root(piece.symbol for piece in pieces),
                _write_root(write_bracketed(_write_signed(piece, self.case)) for piece in pieces),
            )
        piece = pieces[0]
        negative = double(piece.value.dot(piece.positive)) < 0
        return _Written(write_absolute_value(piece.symbol) if negative else piece.symbol)

    def axis(self, fact: Fact, axis: str) -> _Written:
        """A component along an axis of the frame."""
        if fact.by_components:
            return _Written(write_component(fact.symbol, axis))
        return self.along(fact, Vector(*((1, 0) if axis == "x" else (0, 1))))

    def along(self, fact: Fact, direction: Vector) -> _Written:
        """The component along a direction: from the components, or each magnitude times a
        cosine.
        """
        pieces = _list_components(fact) if fact.by_components else fact.parts
        return _project_pieces(pieces, bearing(direction), self.case)

    def angle(self, tree: Call) -> _Written:
        """The angle from one vector to another, or between them, from their directions."""
        first, second = (bearing(self.value(argument)) for argument in tree.arguments)
        if tree.function == "between" and second < first:
            first, second = second, first
        difference = f"{write_angle(second)} - {write_angle(first)}"
        return _Written(
            difference
            if tree.function == "angle" or second - first <= 180
            else rf"360^\circ - ({difference})"
        )

    def rotation(self, tree: Call) -> _Written:
        """An angular velocity or acceleration, absolute or relative."""
        level = find_level(tree)
        names = [argument.name for argument in tree.arguments if isinstance(argument, Name)]
        if len(names) == 1 or names[1] == GROUND:
            return _Written(write_rotation(names[0], self.case, level))
        symbols = " - ".join(write_rotation(name, self.case, level) for name in names)
        rates = [find_rotation_value(name, self.case, level) for name in names]
        return _Written(
            symbols,
            f"{write_short(rates[0])} - {write_bracketed(write_short(rates[1]))}"
            if any(map(double, rates))
            else "",
        )

    def combined(self, tree: Operation) -> _Written:
        """A formula of two numbers."""
        left, right = self.write(tree.left), self.write(tree.right)
        numbers = [self.number(side) for side in (tree.left, tree.right)]
        symbols = [
            part.symbols or self._component_symbol(side)
            for part, side in ((left, tree.left), (right, tree.right))
        ]
        match tree.sign:
            case "/":
                sides = rf"\frac{{{symbols[0]}}}{{{symbols[1]}}}"
                return _Written(sides, rf"\frac{{{numbers[0]}}}{{{numbers[1]}}}")
            case "+" | "-" | "**":
                return _write_beside(tree.sign, symbols, numbers)
            case "*":
                return _write_beside(r"\cdot", symbols, numbers)
            case _:
                assert_never(tree.sign)

    def number(self, tree: Expression) -> str:
        """The value of a side; a literal as it is."""
        match tree:
            case Number(value=value):
                return write_short(value)
            case Name() | Operation() | Call():
                return write_short(self.value(tree))
            case _:
                assert_never(tree)

    def _component_symbol(self, tree: Expression) -> str:
        """The symbol of a component that the solution has already given."""
        if isinstance(tree, Call) and tree.function in ("x", "y"):
            return write_component(self.fact(tree.arguments[0]).symbol, tree.function)
        return ""

    def _placed(self, tree: Expression) -> str:
        """A length, coordinate or constant in symbols, poles by their letters."""
        symbols = collect_symbols(self.case.template)
        named = _name_poles(tree, self.case)
        letters = {name: name for name in self.facts.findings.poles.values()}
        return write_latex(
            named, {**symbols, **letters}, points=(*self.case.motion.points, *letters)
        )

    def value(self, tree: Expression) -> Any:
        """The exact value of a part of the quantity."""
        arithmetic = self.case.arithmetic.fork()
        assembly = self.case.solution.assembly
        values = {**find_body_names(assembly.mechanism), **assembly.values}
        return evaluate(
            tree,
            values,
            {**assembly.functions, **make_quantities(self.case.motion, arithmetic)},
            arithmetic,
        )


def _project_pieces(pieces: Sequence[Piece], axis: float, case: Case) -> _Written:
    """The sum of pieces along the axis at an angle in degrees; those normal to it add nothing."""
    symbols, numbers = "", ""
    for piece in pieces:
        angle = abs((bearing(piece.positive) - axis + 180) % 360 - 180)
        if abs(angle - 90) > _RIGHT and double(piece.positive.squared()):
            sign = "+" if angle < 90 else "-"
            acute = tidy(min(angle, 180 - angle))
            symbols += sign + write_with_cosine(piece.symbol, acute)
            size = _write_signed(piece, case)
            if size != "0":
                minus = (sign == "-") != size.startswith("-")
                numbers += ("-" if minus else "+") + write_with_cosine(
                    size.removeprefix("-"), acute
                )
    numbers = numbers.removeprefix("+")
    return _Written(symbols.removeprefix("+") or "0", "" if NUMBER.fullmatch(numbers) else numbers)


def _list_components(fact: Fact) -> tuple[Piece, ...]:
    """A vector known by its components, as the sum of these."""
    axes = Vector(1, 0), Vector(0, 1)
    return tuple(
        Piece(write_component(fact.symbol, name), axis, axis * number)
        for name, axis, number in zip("xy", axes, fact.value, strict=True)
    )


def _write_signed(piece: Piece, case: Case) -> str:
    """The number of a piece, negative where it points against its positive sense."""
    size = write_short(length(piece.value, case.arithmetic))
    return f"-{size}" if double(piece.value.dot(piece.positive)) < 0 else size


def _write_root(numbers: Iterable[str]) -> str:
    """The root of a sum of squares."""
    squares = (
        rf"\left({number}\right)^{{2}}" if "^" in number else f"{number}^{{2}}"
        for number in numbers
    )
    return rf"\sqrt{{{'+'.join(squares)}}}"


def _write_beside(sign: str, symbols: Sequence[str], numbers: Sequence[str]) -> _Written:
    """Two sides joined by a sign; the second number in brackets where it is negative."""
    return _Written(
        f"{symbols[0]} {sign} {symbols[1]}", f"{numbers[0]} {sign} {write_bracketed(numbers[1])}"
    )


def _name_poles(tree: Expression, case: Case) -> Expression:
    """The expression with every velocity pole as a named point."""
    match tree:
        case Call(function="pole", arguments=(Name(body), *_)):
            return Name(name_pole(body, case))
        case Call(function=function, arguments=arguments):
            return Call(function, tuple(_name_poles(argument, case) for argument in arguments))
        case Operation(sign=sign, left=left, right=right):
            return Operation(sign, _name_poles(left, case), _name_poles(right, case))
        case Number() | Name():
            return tree
        case _:
            assert_never(tree)


def state_result(ask: Ask, case: Case) -> Result:
    """An answer as the list at the end states it."""
    answer, sense = case.solution.answers[ask.name], _find_sense(ask, case)
    decimal, exact = answer.decimal(6), answer.closed_form
    return Result(
        ask.symbol,
        None if exact == decimal else exact,
        decimal,
        answer.unit,
        case.write(sense) if sense else "",
        answer.equals(decimal),
    )


def _find_sense(ask: Ask, case: Case) -> Message | None:
    """The sense or direction of an answer, None where there is none."""
    tree = ask.quantity
    if not isinstance(tree, Call):
        return None
    if tree.function in MOTION_FUNCTIONS and isinstance(
        MOTION_FUNCTIONS[tree.function].gives, Scalar
    ):
        return find_rotation_sense(case.solution.answers[ask.name].value)
    if tree.function == "magnitude" and is_vector_call(tree.arguments[0]):
        facts = Facts(case, Findings(), MotionReader(case.motion, case.arithmetic))
        value = _Writer(case, facts).value(tree.arguments[0])
        return None if is_zero(value) else describe_direction(value)
    return None
