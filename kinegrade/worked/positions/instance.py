"""Positions of a solved instance in formulas: symbols on one side, this paper's numbers on the
other.

x_{A} &= r \\cos\\varphi = 0.25 \\cos 60^\\circ = 0.125\\,\\unit{m}
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

from kinegrade.expressions.tree import Call, Expression, Name, Number, find_names
from kinegrade.language.math.tree import Row
from kinegrade.language.message import Message
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.angle import Angle
from kinegrade.numbers.balls import PRECISIONS, Balls
from kinegrade.numbers.refusals import Inexact
from kinegrade.numbers.rounded_text import write_decimal
from kinegrade.numbers.units import Unit, read_unit
from kinegrade.problem.kinds.dimension import find_si_unit
from kinegrade.problem.quantity import Quantity, express_in_unit
from kinegrade.worked.case import Case
from kinegrade.worked.construction_steps import Step
from kinegrade.worked.document import Prose
from kinegrade.worked.formulas.atoms import AXES, Symbol
from kinegrade.worked.formulas.equation import Equation, Link, drop_repetition, equate
from kinegrade.worked.formulas.expression import STRUCTURAL, Formulation
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.leaves import formulate
from kinegrade.worked.formulas.numbers import state_quantity, substitute
from kinegrade.worked.formulas.symbols import join_letters, name_coordinate, name_point
from kinegrade.worked.positions.algebra import ZERO, Pair, make_positive
from kinegrade.worked.positions.axes import Axes, choose_axes, length_of
from kinegrade.worked.positions.evaluation import Evaluation, enclose, has_ball
from kinegrade.worked.positions.parts import Derived

METRE, RADIAN, DEGREE, PURE = read_unit("m"), read_unit("rad"), read_unit("deg"), read_unit("1")


@dataclass(frozen=True)
class Instance:
    """What the formulas of positions need: the case, its steps and axes, symbols of names, and
    values in SI; `units` has the SI units of names that are no lengths.
    """

    case: Case
    steps: tuple[Step, ...]
    axes: Axes
    symbols: Mapping[str, Symbol]
    values: Mapping[str, Any]
    arithmetic: Any
    units: Mapping[str, Unit]

    def named(self, name: str, symbol: Symbol, value: Any, unit: Unit = METRE) -> Instance:
        """The instance with one more name that formulas may use."""
        return replace(
            self,
            symbols={**self.symbols, name: symbol},
            values={**self.values, name: value},
            units={**self.units, name: unit},
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
        # No exact number is put together with an enclosure
        mixed = self.arithmetic.exact and any(
            has_ball(self.values.get(name)) for name in find_names(tree)
        )
        if not mixed:
            with suppress(Inexact), self.arithmetic.context():
                return self._exactly.evaluate(tree)
        with Balls(PRECISIONS[0]).context():
            return self._enclosed.evaluate(tree)

    @cached_property
    def _exactly(self) -> Evaluation:
        """The values as they are."""
        return Evaluation.of(self.values, self.arithmetic)

    @cached_property
    def _enclosed(self) -> Evaluation:
        """The values as enclosures."""
        balls = Balls(PRECISIONS[0])
        enclosed = {name: enclose(value, balls) for name, value in self.values.items()}
        return Evaluation.of(enclosed, balls)

    def sign(self, tree: Expression) -> int:
        """The sign of an expression's value: -1, 0 or 1."""
        value = float(write_decimal(self.value(tree), 1))
        return (value > 0) - (value < 0)

    def measure(self, pair: Pair) -> Expression:
        """The length of a vector with these coordinates: one alone by its size, x or -x."""
        seen = [make_positive(one, sign) for one in pair if (sign := self.sign(one))]
        return seen[0] if len(seen) == 1 else length_of(Call("", pair), self.axes)

    def say(self, message: Message) -> Prose:
        """A paragraph that says a message."""
        return self.case.say(message)

    def formula(self, tree: Expression, degrees: bool = False) -> Formula:
        """An expression in symbols."""
        return formulate(self.symbols, self.axes.points).state(tree, degrees)

    def text(self, tree: Expression, degrees: bool = False) -> str:
        """An expression in symbols, as a part of a sentence."""
        return self.case.text(self.formula(tree, degrees))

    def letter(self, point: str) -> str:
        """The letter of a point, as a part of a sentence."""
        return self.case.text(self.symbols[point])

    def numbers(self, tree: Expression, degrees: bool = False) -> Formula:
        """An expression with numbers in place of symbols; angles are evaluated."""
        return Formulation(self._find_number).state(tree, degrees)

    def _find_number(self, tree: Expression, angular: bool) -> Formula | None:
        """The number that replaces a name, a coordinate or an angle."""
        if angular:
            return self._put_in(tree, DEGREE)
        if isinstance(tree, Name) and tree.name != "pi":
            return self._put_in(tree, self.units.get(tree.name, METRE))
        if isinstance(tree, Call) and tree.function not in STRUCTURAL:
            return self._put_in(tree, METRE)
        return None

    def _put_in(self, tree: Expression, unit: Unit) -> Formula:
        """The value of a part of a formula in place of its symbols."""
        value = self.value(tree)
        if isinstance(value, int):
            value = self.arithmetic.number(value)
        with Balls(PRECISIONS[0]).context():
            return substitute(value, DEGREE if isinstance(value, Angle) else unit)

    def quantity(self, value: Any, unit: Unit) -> Quantity:
        """A value in SI as a quantity; angles in degrees are multiples of this arithmetic's pi."""
        if isinstance(value, int):
            return express_in_unit("", self.arithmetic.number(value), unit)
        with Balls(PRECISIONS[0]).context():
            return express_in_unit("", value, unit)

    def note_distance(self, distance: Call) -> None:
        """Keep the distance of two named points as worked out, so that no step does it again."""
        ends = [end.name for end in distance.arguments if isinstance(end, Name)]
        if len(ends) == 2:
            letters = join_letters(map(self.case.naming.letter, ends))
            self.case.findings.arms.setdefault(frozenset(ends), letters)

    def equation(self, left: Formula, tree: Expression, unit: Unit = METRE) -> tuple[Row, ...]:
        """left = the formula = the same with numbers = the value."""
        value = state_quantity(self.quantity(self.value(tree), unit))
        return self.lines(left, drop_repetition(self.worked_out(left, tree, unit.degrees), value))

    def lines(self, left: Formula, links: tuple[Link, ...]) -> tuple[Row, ...]:
        """An equation on as many lines as it needs."""
        return self.case.break_lines(Equation(left, links))

    def coordinates(self, point: str, pair: Pair) -> tuple[Derived, Derived]:
        """x = ..., y = ... of a named point worked out."""
        across, up = pair
        x, y = (name_coordinate(axis, self.symbols[point]) for axis in AXES)
        across = ZERO if self.axes.x(point) == ZERO else across
        up = ZERO if self.axes.y(point) == ZERO else up
        return self._derive(x, across), self._derive(y, up)

    def _derive(self, symbol: Symbol, tree: Expression) -> Derived:
        return Derived(symbol, self.equation(symbol, tree), is_zero=tree == ZERO)

    def coordinate_lines(self, point: str, pair: Pair) -> tuple[Row, ...]:
        """The lines of both coordinates."""
        return tuple(line for each in self.coordinates(point, pair) for line in each.lines)

    def worked_out(
        self, left: Formula, tree: Expression, degrees: bool = False
    ) -> tuple[Link, ...]:
        """The formula and the same with numbers, each where it adds something."""
        symbols, numbers = self.formula(tree, degrees), self.numbers(tree, degrees)
        plain = isinstance(tree, (Name, Number)) or (
            isinstance(tree, Call) and tree.function not in STRUCTURAL
        )
        given = () if symbols == left or isinstance(tree, Number) else equate(symbols)
        return given if plain or numbers == symbols else (*given, *equate(numbers))


def make_instance(case: Case) -> Instance:
    """The instance of a case, with its auxiliary points evaluated."""
    instance = Instance(
        case,
        (),
        Axes(frozenset(), frozenset()),
        case.symbols,
        dict(case.solution.assembly.values),
        case.arithmetic.fork(),
        {name: find_si_unit(one.unit) for name, one in case.template.parameters.items()},
    )
    return add_steps(instance, case.construction)


def add_steps(instance: Instance, more: Iterable[Step]) -> Instance:
    """The instance with further points; those that the template does not name are evaluated."""
    all_steps = (*instance.steps, *more)
    instance = replace(instance, steps=all_steps, axes=choose_axes(all_steps))
    for step in all_steps:
        if step.point not in instance.values:
            place = instance.value(step.tree)
            instance = instance.named(step.point, name_point(step.point), Vector(place.x, place.y))
    return instance
