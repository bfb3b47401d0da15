"""From the rates to the answers: the last lines of a solution, with the values of the key."""

from __future__ import annotations

from collections.abc import Iterator

from kinegrade.expressions.tree import Call, Name
from kinegrade.language.math.tree import Row
from kinegrade.language.message import Message
from kinegrade.problem.kinds.dimension import find_dimension
from kinegrade.problem.kinds.kinds import Scalar
from kinegrade.problem.quantities.functions import find_motion_calls
from kinegrade.problem.quantities.motion_functions import MOTION_FUNCTIONS
from kinegrade.problem.template.signs import write_sign
from kinegrade.problem.template.template import Ask
from kinegrade.problem.template.translated import Translated
from kinegrade.sign_conventions import UNSIGNED
from kinegrade.worked.answers.angles_between import explain_between
from kinegrade.worked.answers.asked_vectors import explain_prerequisites, find_fact, is_vector_call
from kinegrade.worked.answers.centrodes import explain_centrode
from kinegrade.worked.answers.directions import explain_turn, is_turn
from kinegrade.worked.answers.projections import Working
from kinegrade.worked.answers.quantity_formulas import find_value, work_out
from kinegrade.worked.answers.stated_values import explain_value
from kinegrade.worked.case import Case
from kinegrade.worked.document import Block
from kinegrade.worked.formulas.atoms import ZERO, Symbol, VectorSymbol
from kinegrade.worked.formulas.equation import Equation, Link, drop_repetition, equate
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.measures import double
from kinegrade.worked.formulas.numbers import state_number, state_quantity
from kinegrade.worked.formulas.rotational_speeds import (
    FULL_TURN,
    count_seconds,
    is_rotational_speed,
)
from kinegrade.worked.formulas.symbols import read_symbol
from kinegrade.worked.senses import state_rotation_sense, state_way
from kinegrade.worked.steps.poles.poles import explain_pole


def explain_answer(ask: Ask, case: Case) -> Iterator[Block]:
    """How an answer follows from the results of the steps; not for answers that positions alone
    decide.
    """
    calls = tuple(find_motion_calls(ask.quantity))
    derivations = {MOTION_FUNCTIONS[call.function].derivation for call in calls}
    if "centrode" in derivations:
        yield from explain_centrode(ask, case)
        return
    if "value" in derivations:
        yield from explain_value(ask, calls, case)
        return
    for call in calls:
        if call.function == "pole" and isinstance(call.arguments[0], Name):
            yield from explain_pole(call.arguments[0].name, case)
    yield from explain_prerequisites(ask.quantity, case)
    if isinstance(ask.quantity, Call) and is_turn(ask.quantity):
        yield from explain_turn(ask.quantity, case)
    symbol, answer = read_symbol(ask.symbol), case.solution.answers[ask.name]
    if symbol.print() in case.findings.distances:  # a step has given it
        return
    working = work_out(ask.quantity, case)
    if working.symbols.looks_like(abs(symbol)):
        yield case.show(Equation(working.symbols, state_quantity(answer)))
    elif working.symbols.looks_like(-symbol):
        if double(answer.number):
            yield from _count_as_asked(ask, case)
    elif not working.symbols.looks_like(symbol):  # else a step has already given it
        yield from explain_between(ask, case)
        if _is_counted_against(ask, working.symbols):
            yield case.say(_name_convention(ask, case))
        yield case.show(_state_last_line(ask, working, case))
        _note_size(ask, case)


def _note_size(ask: Ask, case: Case) -> None:
    """Keep that an answer was the magnitude of a vector in its own letters: no step repeats it."""
    tree = ask.quantity
    if (
        isinstance(tree, Call)
        and tree.function == "magnitude"
        and is_vector_call(tree.arguments[0])
    ):
        fact = find_fact(tree.arguments[0], case)
        if fact.symbol.looks_like(read_symbol(ask.symbol)):
            case.findings.sized.add(fact.symbol)


def _count_as_asked(ask: Ask, case: Case) -> Iterator[Block]:
    """An answer that a step has given under the same symbol with the opposite positive sense: the
    question's, and the value in it, as decimals where it has been rounded; the symbol keeps its
    own sense, so that it has one value.
    """
    symbol, value = read_symbol(ask.symbol), state_value(ask, case)
    rounded = tuple(link for link in value if link.relation == r"\approx")
    yield case.say(_name_convention(ask, case))
    yield case.show(Equation(-symbol, rounded or value))


def _is_counted_against(ask: Ask, symbols: Formula) -> bool:
    """Whether the question counts a letter's opposite, in a sense of its own."""
    usual = ask.sign in ("ccw", "+x", "+y", *UNSIGNED)
    return not usual and symbols.sign < 0 and isinstance(symbols.size, Symbol | VectorSymbol)


def _name_convention(ask: Ask, case: Case) -> Message:
    """The question's sign convention, in the author's words where these are in the language; kept
    for the sentence that says what is sought.
    """
    if isinstance(ask.sign, Translated) and not ask.sign.has(case.language):
        return Message("solution.as-asked-there")
    case.findings.counted.add(ask.name)
    return Message("solution.as-asked", sign=write_sign(ask.sign, case.language))


def _state_last_line(ask: Ask, working: Working, case: Case) -> Equation:
    """The answer's symbol, its formula, its numbers and its value from the key."""
    answer, symbol = case.solution.answers[ask.name], read_symbol(ask.symbol)
    if is_rotational_speed(symbol, ask.unit):
        return _count_turns(ask, working, case)
    numbers = () if working.numbers is None else (working.numbers,)
    between = [
        one for one in (working.symbols, *numbers) if one != ZERO and not one.looks_like(symbol)
    ]
    values = state_value(ask, case) if between else state_quantity(answer)
    links = drop_repetition(equate(*between), values)
    signed = ask.sign == "magnitude" and case.findings.is_negative(symbol)
    return Equation(abs(symbol) if signed else symbol, links, _state_sense(ask, case))


def _count_turns(ask: Ask, working: Working, case: Case) -> Equation:
    """A rotational speed from the angular velocity."""
    *_, rate = state_number(find_value(ask.quantity, case), find_dimension(ask.unit).unit)
    *_, value = state_quantity(case.solution.answers[ask.name])
    turned = count_seconds(rate.right / FULL_TURN, ask.unit)
    turns = equate(working.symbols / FULL_TURN, turned)
    rotations = tuple(find_motion_calls(ask.quantity))
    alone = len(rotations) == 1
    sense = state_rotation_sense(find_value(rotations[0], case), case) if alone else ()
    return Equation(read_symbol(ask.symbol), (*turns, value), sense)


def state_value(ask: Ask, case: Case) -> tuple[Link, ...]:
    """The value that a formula in SI gives; in SI first where the key has another unit, such as
    centimetres or feet.
    """
    answer, unit = case.solution.answers[ask.name], ask.unit
    if answer.at_infinity or answer.is_zero or unit.is_si:
        return state_quantity(answer)
    base = state_number(find_value(ask.quantity, case), find_dimension(unit).unit)
    *_, prefixed = state_quantity(answer)
    return (*base, prefixed)


def _state_sense(ask: Ask, case: Case) -> Row:
    """The sense or direction of an answer beside its value, nothing where there is none."""
    tree = ask.quantity
    if not isinstance(tree, Call):
        return ()
    if tree.function in MOTION_FUNCTIONS and isinstance(
        MOTION_FUNCTIONS[tree.function].gives, Scalar
    ):
        return state_rotation_sense(case.solution.answers[ask.name].value, case)
    if tree.function == "magnitude" and is_vector_call(tree.arguments[0]):
        return state_way(find_value(tree.arguments[0], case), case)
    return ()
