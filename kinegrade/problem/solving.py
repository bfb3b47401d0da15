"""Solving an instance: exactly where a small field holds its values, by certified balls everywhere
else.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any, TypeVar

from flint import arb, fmpq

from kinegrade.errors import (
    AtInfinity,
    ExpressionError,
    KinegradeError,
    MechanismError,
    TemplateError,
)
from kinegrade.expressions.evaluation import evaluate
from kinegrade.expressions.tree import Expression
from kinegrade.language.message import Fault, Message
from kinegrade.mechanics.motion import Motion, pose_mechanism, solve_motion
from kinegrade.mechanics.plan import Plan
from kinegrade.numbers.angle import Angle
from kinegrade.numbers.balls import PRECISIONS, Balls, Undecided
from kinegrade.numbers.field import Field
from kinegrade.numbers.number import Arithmetic
from kinegrade.numbers.pi_multiple import PiMultiple
from kinegrade.numbers.refusals import Inexact
from kinegrade.numbers.surd import Surd
from kinegrade.problem.assembling.assemble import Assembly, assemble
from kinegrade.problem.centrode import Centrodes
from kinegrade.problem.given_values import find_certain_values, find_parameter_values, read_values
from kinegrade.problem.quantities.functions import make_quantities
from kinegrade.problem.quantities.reader import find_body_names
from kinegrade.problem.quantity import Quantity, express_in_unit
from kinegrade.problem.solution import Solution, explain_no_ask
from kinegrade.problem.template.template import Ask, Template

_Result = TypeVar("_Result")
_CERTIFIED = (
    120  # bits: an enclosure counts as certified when narrower than 2^-120, below 1e-36, relative
)


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


def _require_asks(template: Template, asks: Iterable[str] | None) -> tuple[Ask, ...]:
    """The asks named, or all. Raises TemplateError for unknown ones."""
    chosen = tuple(template.asks if asks is None else asks)
    unknown = [
        Fault(template.name, explain_no_ask(name, template.asks))
        for name in chosen
        if name not in template.asks
    ]
    if unknown:
        raise TemplateError(*unknown)
    return tuple(template.asks[name] for name in chosen)


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
        if not circles.template.scheme.has_mechanism:
            _require_radians_apart(number, ask, forked)
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
    if not isinstance(number, (int, fmpq, Surd, PiMultiple, arb, Angle)):
        raise ExpressionError(Message("template.number-of-a-vector"))
    if ask.unit.degrees and not isinstance(number, (Angle, arb)):
        raise ExpressionError(Message("template.angle-expected"))


def _require_radians_apart(number: Any, ask: Ask, arithmetic: Arithmetic) -> None:
    """Raises Inexact for an exact angle that is no answer in radians or degrees, as the arc of a
    circle has pi in it; and for a number of radians to be stated in degrees.
    """
    angle, angular = isinstance(number, Angle), ask.unit.degrees or ask.unit.text == "rad"
    if arithmetic.exact and ((angle and not angular) or (ask.unit.degrees and not angle)):
        raise Inexact


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
