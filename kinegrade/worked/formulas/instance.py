"""Formulas of a solved instance: symbols on one side, this paper's numbers on the other.

x_{A} &= r \\cos\\varphi = 0.25 \\cos 60^\\circ = 0.125\\,\\mathrm{m}
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from typing import Any

from kinegrade.expressions.expression import (
    Call,
    Expression,
    Name,
    Number,
    evaluate,
    make_elementary_functions,
)
from kinegrade.mechanics.geometry import make_constructions
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.angle import Angle, Inexact
from kinegrade.numbers.balls import PRECISIONS, Balls
from kinegrade.numbers.text import LATEX, write_decimal, write_exact
from kinegrade.numbers.units import Unit, read_unit
from kinegrade.problem.quantity import Quantity, express_in_unit
from kinegrade.problem.solving import Solution
from kinegrade.worked.formulas.coordinates import Axes, Pair, Step, choose_axes, list_steps
from kinegrade.worked.formulas.expression import Writer, collect_symbols, make_symbol_writer
from kinegrade.worked.formulas.pieces import INVERSE, TRIGONOMETRY, Piece, make_numeral
from kinegrade.worked.formulas.width import chain_lines

_DIGITS = 4  # significant digits of every rounded decimal
_LONGEST_SUBSTITUTED = (
    12  # characters of plain text: longer exact numbers, and parts of roots, become decimals
)
_LONGEST_EXACT = (
    30  # characters of plain text: a longer exact number is left out on the way to an answer
)
STRUCTURAL = frozenset({*TRIGONOMETRY, *INVERSE, "sqrt", "abs"})
Part = tuple[str, str]  # a relation sign and what follows it

METRE, RADIAN, DEGREE, PURE = read_unit("m"), read_unit("rad"), read_unit("deg"), read_unit("1")
AREA = read_unit("m^2")


@dataclass(frozen=True)
class Instance:
    """What the formulas of a solved instance need: its steps and axes, symbols of names, and values
    in SI.
    """

    solution: Solution
    steps: tuple[Step, ...]
    axes: Axes
    symbols: Mapping[str, str]
    values: Mapping[str, Any]
    arithmetic: Any

    def named(self, name: str, symbol: str, value: Any) -> Instance:
        """The instance with one more name that formulas may use."""
        return replace(
            self, symbols={**self.symbols, name: symbol}, values={**self.values, name: value}
        )

    def free(self, letter: str) -> str:
        """A name for an auxiliary quantity that the template does not use."""
        return next(
            name
            for name in (letter, *(f"{letter}{count}" for count in range(1, 1000)))
            if name not in self.values
        )

    def value(self, tree: Expression) -> Any:
        """The value of an expression in SI: exact where a small field holds it, otherwise a
        certified enclosure.
        """
        try:
            with self.arithmetic.context():
                return _evaluate_in(tree, self.values, self.arithmetic)
        except Inexact:
            balls = Balls(PRECISIONS[0])
            with balls.context():
                return _evaluate_in(
                    tree,
                    {name: _enclose(value, balls) for name, value in self.values.items()},
                    balls,
                )

    def sign(self, tree: Expression) -> int:
        """The sign of an expression's value: -1, 0 or 1."""
        value = self.value(tree)
        text = write_decimal(value, 1)
        return 0 if text == "0" else -1 if text.startswith("-") else 1

    def symbolic(self, tree: Expression, degrees: bool = False) -> str:
        """The formula in symbols."""
        return make_symbol_writer(self.symbols, self.axes.points).write(tree, degrees).signed

    def _numeric(self, tree: Expression, degrees: bool = False) -> str:
        """The formula with numbers in place of symbols; angles are evaluated."""
        return Writer(self.number).write(tree, degrees).signed

    def number(self, tree: Expression, angular: bool) -> Piece | None:
        """The number that replaces a name, a coordinate or an angle."""
        if angular:
            return make_numeral(self.degrees(self.value(tree)) + r"^\circ")
        if isinstance(tree, Name) and tree.name != "pi":
            return make_numeral(_write_substituted(self.value(tree)))
        if isinstance(tree, Call) and tree.function not in STRUCTURAL:
            return make_numeral(_write_substituted(self.value(tree)))
        return None

    def degrees(self, angle: Any) -> str:
        """An angle in degrees as a decimal, to about two decimals."""
        quantity = self.quantity(angle, DEGREE)
        if quantity.is_plain:
            return quantity.decimal(12)
        return quantity.decimal(_DIGITS + 1 if abs(quantity.value) >= 100 else _DIGITS)

    def quantity(self, value: Any, unit: Unit) -> Quantity:
        """A value in SI as a quantity; angles in degrees are multiples of this arithmetic's pi."""
        if isinstance(value, int):
            return express_in_unit("", self.arithmetic.number(value), unit)
        with Balls(PRECISIONS[0]).context():
            return express_in_unit("", value, unit)

    def proportion(self, left: str, tree: Expression, unit: Unit) -> tuple[str, ...]:
        """left, up to a factor, as the formula = the same with numbers = the value; a zero is
        written without a factor.
        """
        results = write_result(self.quantity(self.value(tree), unit))
        worked = (("=", self.symbolic(tree)), *self.worked_out(self.symbolic(tree), tree))
        (_, first), *others = drop_repetition(() if isinstance(tree, Number) else worked, results)
        return chain_lines(left, (("=" if first == "0" else r"\propto", first), *others))

    def equation(self, left: str, tree: Expression, unit: Unit = METRE) -> tuple[str, ...]:
        """left = the formula = the same with numbers = the value."""
        results = write_result(self.quantity(self.value(tree), unit))
        return chain_lines(
            left, drop_repetition(self.worked_out(left, tree, unit.degrees), results)
        )

    def coordinates(self, point: str, pair: Pair) -> tuple[str, ...]:
        """x = ..., y = ... of a named point worked out."""
        name = self.symbols[point]
        x, y = pair
        return (*self.equation(f"x_{{{name}}}", x), *self.equation(f"y_{{{name}}}", y))

    def worked_out(self, left: str, tree: Expression, degrees: bool = False) -> tuple[Part, ...]:
        """The formula and the same with numbers, each where it adds something."""
        symbols, numbers = self.symbolic(tree, degrees), self._numeric(tree, degrees)
        plain = isinstance(tree, (Name, Number)) or (
            isinstance(tree, Call) and tree.function not in STRUCTURAL
        )
        given = () if symbols == left or isinstance(tree, Number) else (("=", symbols),)
        return given if plain or numbers == symbols else (*given, ("=", numbers))


def make_instance(solution: Solution) -> Instance:
    """The instance of a solution, with its auxiliary points evaluated."""
    template = solution.template
    instance = Instance(
        solution,
        (),
        Axes(frozenset(), frozenset()),
        collect_symbols(template),
        dict(solution.assembly.values),
        solution.arithmetic.fork(),
    )
    return add_steps(instance, list_steps(template))


def add_steps(instance: Instance, more: Iterable[Step]) -> Instance:
    """The instance with further points; those that the template does not name are evaluated."""
    all_steps = (*instance.steps, *more)
    instance = replace(instance, steps=all_steps, axes=choose_axes(all_steps))
    for step in all_steps:
        if step.point not in instance.values:
            place = instance.value(step.tree)
            instance = instance.named(
                step.point, f"{step.point[0]}_{{{step.point[1:]}}}", Vector(place.x, place.y)
            )
    return instance


def _evaluate_in(tree: Expression, values: Mapping[str, Any], arithmetic: Any) -> Any:
    """The value of an expression in one arithmetic."""
    points = {name: value for name, value in values.items() if isinstance(value, Vector)}
    functions: dict[str, Callable[..., Any]] = {
        **make_elementary_functions(arithmetic),
        **make_constructions(arithmetic, points),
    }
    return evaluate(tree, values, functions, arithmetic)


def _enclose(value: Any, balls: Balls) -> Any:
    """An exact value as an enclosure."""
    if isinstance(value, Vector):
        return Vector(balls.number(value.x), balls.number(value.y))
    if isinstance(value, Angle):
        return value.ball()
    return value if isinstance(value, str) else balls.number(value)


def _write_substituted(value: Any) -> str:
    """A number as it is substituted into a formula: exact where that is short, else rounded."""
    quantity = express_in_unit("", value, PURE)
    if isinstance(value, Angle):
        return quantity.decimal(_DIGITS)
    if quantity.is_plain:
        return quantity.decimal(12)
    text = str(quantity.exact)
    if (
        quantity.is_exact
        and len(text) <= _LONGEST_SUBSTITUTED
        and not ("sqrt" in text and "/" in text)
    ):
        return write_exact(value, LATEX)
    return _write_settled(quantity) or quantity.decimal(_DIGITS)


def _write_settled(quantity: Quantity) -> str | None:
    """The decimal of an enclosure that, within its precision, is a number of few digits; None for
    any other.
    """
    text = quantity.decimal(20)
    return text if len(text.strip("-").lstrip("0.")) <= 6 else None


def drop_repetition(worked: tuple[Part, ...], results: tuple[Part, ...]) -> tuple[Part, ...]:
    """All parts of an equation; the last step of the working is dropped where it differs from the
    result only in the unit.
    """
    if worked and results and results[0][1].split(r"\,\mathrm")[0] == worked[-1][1]:
        worked = worked[:-1]
    return worked + results


def write_result(quantity: Quantity, longest: int = _LONGEST_EXACT) -> tuple[Part, ...]:
    """The value at the end of an equation: exact where it is short enough, then rounded where the
    exact form is not a decimal.
    """
    if quantity.is_zero:
        return (("=", "0"),)
    if quantity.is_plain:
        return (("=", _write_with_unit(quantity.decimal(12), quantity.measure)),)
    if not quantity.is_exact and (short := _write_settled(quantity)):
        return (("=", _write_with_unit(short, quantity.measure)),)
    digits = _DIGITS + 1 if quantity.measure.degrees and abs(quantity.value) >= 100 else _DIGITS
    decimal = ("\\approx", _write_with_unit(quantity.decimal(digits), quantity.measure))
    arctangent = isinstance(quantity.number, Angle) and quantity.measure.degrees
    long = quantity.closed_form is None or len(str(quantity.exact)) > longest
    return (decimal,) if arctangent or long else (("=", _write_exact_with_unit(quantity)), decimal)


def _write_exact_with_unit(quantity: Quantity) -> str:
    """A closed form with its unit: a sum in brackets, an angle in radians without one."""
    text = str(quantity.closed_form)
    if isinstance(quantity.number, Angle) and not quantity.measure.degrees:
        return text
    piece = make_numeral(text)
    bracketed = piece.kind == "sum" and quantity.measure.latex
    return _write_with_unit(rf"\left({text}\right)" if bracketed else text, quantity.measure)


def _write_with_unit(text: str, unit: Unit) -> str:
    """A printed number with its unit."""
    if not unit.latex:
        return text
    return text + unit.latex if unit.degrees else rf"{text}\,{unit.latex}"
