"""The solution of a question that has named steps in place of a mechanism: each step in symbols,
with numbers, and its value.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any, assert_never

from kinegrade.expressions.angular import is_angle
from kinegrade.expressions.tree import Call, Expression, Name, Number, Operation
from kinegrade.language.message import Message
from kinegrade.numbers.angle import Angle
from kinegrade.numbers.units import Unit, read_unit
from kinegrade.problem.kinds.dimension import find_si_unit
from kinegrade.problem.needs import find_needed_steps
from kinegrade.problem.template.template import Ask
from kinegrade.worked.answers.answers import state_value
from kinegrade.worked.answers.boxes import AnswerBoxes
from kinegrade.worked.answers.dimensions import find_unit
from kinegrade.worked.case import Case
from kinegrade.worked.document import Block
from kinegrade.worked.formulas.atoms import Symbol
from kinegrade.worked.formulas.equation import Equation, Link, lead_to
from kinegrade.worked.formulas.expression import Formulation
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.leaves import formulate
from kinegrade.worked.formulas.numbers import state_number, state_quantity, substitute
from kinegrade.worked.formulas.symbols import PI, read_symbol


def explain_steps(asked: Sequence[Ask], case: Case, boxes: AnswerBoxes) -> Iterator[Block]:
    """The givens in SI where they are given in other units, then the steps that answers need, those
    up to an answer together.
    """
    steps = find_needed_steps(case.template, (ask.name for ask in asked))
    converted = list(_convert_givens(case))
    if converted:
        yield case.say(Message("solution.in-si"))
        yield case.show(*converted)
    waiting: list[Equation] = []
    for name in steps:
        waiting.append(_state_step(name, case))
        if any(ask.name == name for ask in asked):
            yield case.show(*waiting)
            waiting.clear()
    yield from boxes.state_missing(asked)


def _convert_givens(case: Case) -> Iterator[Equation]:
    """The givens whose unit is not that of SI, angles aside, as they are given and in SI."""
    for name, quantity in case.solution.parameters.items():
        parameter = case.template.parameters[name]
        if not parameter.unit.is_si:
            value = case.solution.assembly.values[name]
            given = state_quantity(quantity)
            links = (*given, *state_number(value, find_si_unit(parameter.unit).text))
            yield Equation(read_symbol(parameter.symbol), links)


def _state_step(name: str, case: Case) -> Equation:
    """A step: its symbol, its formula, its numbers and its value."""
    tree, ask = case.template.scheme.steps[name], case.template.asks.get(name)
    left = _collect_letters(case)[name]
    symbols = formulate(_collect_letters(case)).state(tree)
    numbers = Formulation(lambda part, angular: _find_number(part, case)).state(tree)
    value = state_value(ask, case) if ask in _list_answered(case) else _state_found(name, case)
    return Equation(left, lead_to(left, (symbols, numbers), value))


def _list_answered(case: Case) -> list[Ask]:
    """The asks that have an answer here."""
    return [case.template.asks[name] for name in case.solution.answers]


def _collect_letters(case: Case) -> dict[str, Symbol]:
    """The symbols of givens and steps; those of asks as the question has them."""
    asks = {name: read_symbol(ask.symbol) for name, ask in case.template.asks.items()}
    return {**case.symbols, **asks}


def _find_number(tree: Expression, case: Case) -> Formula | None:
    """What stands for a name with its unit; None for an expression to be taken apart."""
    match tree:
        case Name("pi"):
            return PI
        case Name(name):
            return substitute(case.solution.assembly.values[name], _find_unit(name, case))
        case Number() | Operation() | Call():
            return None
        case _:
            assert_never(tree)


def _state_found(name: str, case: Case) -> tuple[Link, ...]:
    """The value of a step that is not asked for."""
    value: Any = case.solution.assembly.values[name]
    return state_number(value, _find_unit(name, case).text)


def _find_unit(name: str, case: Case) -> Unit:
    """The unit in which the value of a given or a step is put into formulas."""
    given = case.template.parameters.get(name)
    if given is not None:
        return find_si_unit(given.unit)
    ask, value = case.template.asks.get(name), case.solution.assembly.values[name]
    if ask is not None and ask.unit.is_si:
        return ask.unit
    unit, tree = find_unit(Name(name), case.template), case.template.scheme.steps[name]
    angular = isinstance(value, Angle) or is_angle(tree, case.template.angles)
    return read_unit("deg" if unit == "1" and angular else unit)
