"""Solving an instance: exactly where a small field holds its values, by certified balls everywhere
else.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any, TypeVar

from flint import arb, fmpq

from kinegrade.errors import (
    AtInfinity,
    ExpressionError,
    KinegradeError,
    MechanismError,
    NoSuchAsk,
    Problem,
    TemplateError,
    suggest,
)
from kinegrade.expressions.evaluation import evaluate
from kinegrade.expressions.reading import read_expression
from kinegrade.expressions.tree import Expression
from kinegrade.language.lines import show_in_one_line
from kinegrade.language.message import Fault, Message, Quoted
from kinegrade.mechanics.motion import Motion, pose_mechanism, solve_motion
from kinegrade.mechanics.plan import Plan
from kinegrade.numbers.angle import Angle, Inexact
from kinegrade.numbers.balls import PRECISIONS, Balls, Undecided
from kinegrade.numbers.field import Field
from kinegrade.numbers.number import Arithmetic
from kinegrade.numbers.surd import Surd
from kinegrade.problem.assemble import Assembly, assemble, read_parameter
from kinegrade.problem.centrode import Centrodes
from kinegrade.problem.quantities.functions import make_quantities
from kinegrade.problem.quantities.reader import find_body_names
from kinegrade.problem.quantity import Quantity, express_in_unit
from kinegrade.problem.template.template import Ask, Template

_Result = TypeVar("_Result")
_CERTIFIED = (
    120  # bits: an enclosure counts as certified when narrower than 2^-120, below 1e-36, relative
)


@dataclass(frozen=True, eq=False, repr=False)
class Solution(Mapping[str, Quantity]):
    """An instance solved: its parameters and answers in their units, and the motion they come
    from. It maps the names of what is asked to the answers, and equals any mapping of equal ones.
    """

    template: Template
    parameters: Mapping[str, Quantity]
    answers: Mapping[str, Quantity]
    assembly: Assembly
    motion: Motion
    arithmetic: Arithmetic

    @cached_property
    def doubles(self) -> Motion:
        """The motion in doubles: for scales, and for working it out again by hand."""
        return self.motion.map(float)

    def __getitem__(self, ask: str) -> Quantity:
        """The answer of an ask. Raises NoSuchAsk, a KeyError."""
        if ask not in self.answers:
            raise NoSuchAsk(Fault(self.template.name, _explain_no_ask(str(ask), self.answers)))
        return self.answers[ask]

    def __iter__(self) -> Iterator[str]:
        return iter(self.answers)

    def __len__(self) -> int:
        return len(self.answers)

    def __repr__(self) -> str:
        return f"<{self.template.name}: {', '.join(map(str, self.answers.values()))}>"


def solve_template(
    template: Template,
    given: Mapping[str, str],
    asks: Iterable[str] | None = None,
    plan: Plan | None = None,
) -> Solution:
    """Solve `template` at the values given as texts in the parameters' units; the rest take their
    default.

    Raises TemplateError for unknown names or unreadable values, MechanismError with the reason in
    mechanics.
    """
    trees = read_values(template, given)
    wanted = _require_asks(template, asks)
    try:
        return solve_certified(
            lambda arithmetic: _solve_in(template, trees, wanted, plan, arithmetic)
        )
    except (ExpressionError, MechanismError) as error:
        raise MechanismError(*error.faults_at(template.name)) from error


def solve_certified(work: Callable[[Any], _Result]) -> _Result:
    """What `work` gives in the first arithmetic that holds its values: exact, then balls of growing
    precision.

    Raises MechanismError when even the narrowest balls leave a sign or a pivot open.
    """
    arithmetics: tuple[Field | Balls, ...] = (
        Field(),
        *(Balls(precision) for precision in PRECISIONS),
    )
    for arithmetic in arithmetics:
        try:
            with arithmetic.context():
                return work(arithmetic)
        except (Inexact, Undecided):
            continue
    raise MechanismError(Message("template.degenerate", bits=PRECISIONS[-1]))


def read_values(template: Template, given: Mapping[str, str]) -> dict[str, Expression]:
    """The trees of all parameters' values. Raises TemplateError with every fault."""
    faults: list[Problem] = []
    trees: dict[str, Expression] = {}
    for name in given:
        if name not in template.parameters:
            hint = suggest(name, template.parameters)
            problem = Message("template.no-parameter", name=Quoted(name), hint=hint)
            faults.append(Fault(template.name, problem))
    for name, parameter in template.parameters.items():
        text = given.get(name, parameter.default)
        try:
            trees[name] = _read_cached(text)
        except ExpressionError as error:
            where = f"{template.name}: {name} = {show_in_one_line(text[:60])}"
            faults += error.faults_at(where)
    if faults:
        raise TemplateError(*faults)
    return trees


@lru_cache(maxsize=4096)
def _read_cached(text: str) -> Expression:
    """The tree of a value, read once: few values are drawn often. Raises ExpressionError."""
    return read_expression(text)


def find_parameter_values(
    template: Template, trees: Mapping[str, Expression], arithmetic: Arithmetic
) -> dict[str, Any]:
    """All parameters in SI. Raises TemplateError with every value that is no number (roots of
    negative numbers, unknown names), Inexact where the exact field does not hold them.
    """
    faults: list[Problem] = []
    values: dict[str, Any] = {}
    for name, parameter in template.parameters.items():
        try:
            values[name] = read_parameter(parameter, trees[name], arithmetic)
            if parameter.is_size and arithmetic.sign(values[name]) < 0:
                raise ExpressionError(Message("template.negative-length"))
        except ExpressionError as error:
            faults += error.faults_at(f"{template.name}: {name}")
    if faults:
        raise TemplateError(*faults)
    return values


def _require_asks(template: Template, asks: Iterable[str] | None) -> tuple[Ask, ...]:
    """The asks named, or all. Raises TemplateError for unknown ones."""
    chosen = tuple(template.asks if asks is None else asks)
    unknown = [
        Fault(template.name, _explain_no_ask(name, template.asks))
        for name in chosen
        if name not in template.asks
    ]
    if unknown:
        raise TemplateError(*unknown)
    return tuple(template.asks[name] for name in chosen)


def _explain_no_ask(name: str, known: Iterable[str]) -> Message:
    hint = suggest(name, known)
    return Message("template.no-ask", name=Quoted(name), hint=hint)


def _solve_in(
    template: Template,
    trees: Mapping[str, Expression],
    asks: Iterable[Ask],
    plan: Plan | None,
    arithmetic: Arithmetic,
) -> Solution:
    """Solve in one arithmetic. Raises Inexact or Undecided when another is needed."""
    values = find_parameter_values(template, trees, arithmetic)
    assembly = assemble(template, values, arithmetic)
    motion = (
        solve_motion(assembly.mechanism, arithmetic, plan)
        if template.scheme.drivers
        else pose_mechanism(assembly.mechanism, arithmetic)
    )
    circles = Centrodes(template, values, plan)
    answers = {ask.name: _answer_ask(ask, assembly, motion, circles, arithmetic) for ask in asks}
    known = values if arithmetic.exact else find_certain_values(template, trees, values)
    parameters = {
        name: express_in_unit(name, number, template.parameters[name].unit)
        for name, number in known.items()
    }
    return Solution(template, parameters, answers, assembly, motion, arithmetic)


def _answer_ask(
    ask: Ask, assembly: Assembly, motion: Motion, circles: Centrodes, arithmetic: Arithmetic
) -> Quantity:
    """The answer of one ask; roots that it alone needs stay out of the others' field."""
    forked = arithmetic.fork()
    values = {**find_body_names(assembly.mechanism), **assembly.values}
    functions = {
        **assembly.functions,
        **make_quantities(motion, forked),
        **circles.functions(forked),
    }
    try:
        number = evaluate(ask.quantity, values, functions, forked)
        _require_number(number, ask)
        quantity = express_in_unit(ask.name, number, ask.unit)
    except AtInfinity:
        return Quantity(ask.name, None, ask.unit)
    except KinegradeError as error:
        raise type(error)(*error.faults_at(ask.name)) from error
    _require_certified(quantity.number)
    return quantity


def _require_number(number: Any, ask: Ask) -> None:
    """Raises ExpressionError for a quantity that is no number (a vector, a point), or no angle
    where one is due.
    """
    if not isinstance(number, (int, fmpq, Surd, arb, Angle)):
        raise ExpressionError(Message("template.number-of-a-vector"))
    if ask.unit.degrees and not isinstance(number, (Angle, arb)):
        raise ExpressionError(Message("template.angle-expected"))


def _require_certified(number: Any) -> None:
    """Raises Undecided for a ball that is too wide to be a reference; one about zero must be narrow
    in itself.
    """
    if not isinstance(number, arb):
        return
    narrow = (
        number.rad() < arb(2) ** -_CERTIFIED
        if 0 in number
        else number.rel_accuracy_bits() >= _CERTIFIED
    )
    if not narrow:
        raise Undecided  # an enclosure is too wide


def find_certain_values(
    template: Template, trees: Mapping[str, Expression], values: Mapping[str, Any]
) -> dict[str, Any]:
    """The parameters in SI, exact wherever they can be, although the instance is solved by
    balls.
    """
    found = dict(values)
    for name, parameter in template.parameters.items():
        with suppress(Inexact):
            found[name] = read_parameter(parameter, trees[name], Field())
    return found
