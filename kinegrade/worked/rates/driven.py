"""What drivers impose: the motion that is given."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, assert_never

from msgspec import structs

from kinegrade.expressions.tree import Expression, Number, find_names
from kinegrade.language.math.tree import Row, Scripts
from kinegrade.language.message import Message
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.laws import (
    Imposed,
    ImposedCircling,
    ImposedComponent,
    ImposedMotion,
    ImposedRotation,
)
from kinegrade.mechanics.relations.relation import Relation
from kinegrade.mechanics.shares import RIGHT
from kinegrade.mechanics.vector_equation import Level
from kinegrade.numbers.balls import PRECISIONS, Balls
from kinegrade.problem.kinds.dimension import find_si_unit
from kinegrade.problem.quantity import express_in_unit
from kinegrade.worked.case import Case
from kinegrade.worked.formulas.atoms import ZERO, Measured, add_terms
from kinegrade.worked.formulas.equation import Equation, Link, drop_repetition, equate, lead_to
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.measures import double
from kinegrade.worked.formulas.numbers import measure, state_number, state_quantity
from kinegrade.worked.formulas.rotational_speeds import (
    count_full_turns,
    is_rotational_speed,
    turn_into_angle,
)
from kinegrade.worked.rates.driven_points import (
    name_driven,
    name_driven_component,
    say_driven,
    say_driven_component,
    state_component_way,
    state_driven_way,
)
from kinegrade.worked.rates.speeds import (
    Statement,
    find_rotation_value,
    name_relative_rotation,
    name_rotation,
    state_expression,
)
from kinegrade.worked.senses import (
    state_rotation_sense,
    state_way_round,
)
from kinegrade.worked.vectors.known_vectors import find_given_sign
from kinegrade.worked.vectors.vectors import UNITS, name_point_vector


def state_imposed(law: Imposed, relation: Relation, case: Case, level: Level) -> Statement:
    """What a driver imposes."""
    value = _find_driven_value(relation, level)
    left = _name_imposed(law, relation, case, level)
    unit = UNITS[level, bool(law.list_factors(RIGHT))]
    sign = find_given_sign(law, relation, case, level)
    expression = _state_expression(law, left, sign, case, level)
    as_given = _state_as_given(_find_tree(law, case, level), value * sign, unit, case)
    links = drop_repetition(expression, (*as_given, *state_number(value * sign, unit)))
    equation = Equation(left, links, _state_sense(law, value, case))
    given = _state_given(law, relation, case, level)
    return Statement(Message("solution.title-given"), given, equation)


def _counts_against(law: ImposedMotion, relation: Relation, case: Case, level: Level) -> bool:
    """Whether an acceleration counts positive in the sense in which the velocity of its point
    counts negative.
    """
    moves = level == "acceleration" and double(relation.velocity) and double(relation.acceleration)
    levels: tuple[Level, Level] = ("velocity", "acceleration")
    senses = {find_given_sign(law, relation, case, one) for one in levels}
    return bool(moves) and law.of == GROUND and len(senses) > 1


def solve_relative(
    law: ImposedRotation, stated: Equation, result: Equation, case: Case, level: Level
) -> Equation:
    """What an imposed relative rotation says of that of either body, which `result` gives: in
    symbols, with numbers, and the value.
    """
    letters = [name_rotation(body, case, level) for body in (law.body, law.of)]
    rates = [find_rotation_value(body, case, level) for body in (law.body, law.of)]
    turned = letters.index(result.left)
    sign, unit = 1 - 2 * turned, UNITS[level, True]
    relative = measure(rates[0] - rates[1], unit)
    numbers = (measure(rates[1 - turned], unit), relative.size.signed(relative.sign * sign))
    said = stated.links[0].right
    working = (
        letters[1 - turned] + said.size.signed(said.sign * sign),
        add_terms(one for one in numbers if one != ZERO),
    )
    return Equation(result.left, lead_to(result.left, working, result.links), result.aside)


def _name_imposed(law: Imposed, relation: Relation, case: Case, level: Level) -> Formula:
    """The symbol of what a driver imposes."""
    match law:
        case ImposedRotation():
            return name_relative_rotation(law.body, law.of, case, level)
        case ImposedMotion():
            return name_driven(law, relation, case, level)
        case ImposedComponent():
            return name_driven_component(law, case, level)
        case ImposedCircling():
            circling = name_point_vector(law.point, level, case)
            return {"velocity": circling, "acceleration": replace(circling, part="t")}[level]
        case _:
            assert_never(law)


def _state_sense(law: Imposed, value: Any, case: Case) -> Row:
    """The sense of what a driver imposes."""
    match law:
        case ImposedRotation():
            return state_rotation_sense(value, case)
        case ImposedCircling():
            return state_way_round(law.centre, double(value), case) if value else ()
        case ImposedMotion():
            return state_driven_way(law, double(value), case)
        case ImposedComponent():
            return state_component_way(law, double(value), case)
        case _:
            assert_never(law)


def _state_as_given(tree: Expression, value: Any, unit: str, case: Case) -> tuple[Link, ...]:
    """The value in the unit of the parameter it comes from, where that is not of SI; 2 pi times
    the turns in their time where this counts turns.
    """
    parameters = case.template.parameters
    units = {parameters[name].unit for name in find_names(tree) if name in parameters}
    given = units.pop() if len(units) == 1 else None
    if given is None or given.is_si or find_si_unit(given).text != unit:
        return ()
    with Balls(PRECISIONS[0]).context():
        quantity = express_in_unit("", value, given)
        stated = state_quantity(quantity)
    if [link.relation for link in stated] != ["="] or quantity.is_zero:
        return ()
    if _counts_turns(tree, case):
        return equate(turn_into_angle(_drop_unit(stated[0].right), given))
    return stated


def state_turned(
    law: ImposedRotation, relation: Relation, case: Case
) -> tuple[Formula, Formula] | None:
    """The size of an angular velocity by the rotational speed that gives it: 2 pi n; None else."""
    tree = _find_tree(law, case, "velocity")
    size = relation.velocity if double(relation.velocity) > 0 else -relation.velocity
    given = _state_as_given(tree, size, "rad/s", case)
    if not given or not _counts_turns(tree, case):
        return None
    letters = state_expression(tree, case).size
    return count_full_turns(letters), given[0].right


def _drop_unit(formula: Formula) -> Formula:
    """The number of what is measured."""
    return formula.number if isinstance(formula, Measured) else formula


def _find_driven_value(relation: Relation, level: Level) -> Any:
    """The velocity or acceleration that a driver imposes."""
    match level:
        case "velocity":
            return relation.velocity
        case "acceleration":
            return relation.acceleration
        case _:
            assert_never(level)


def _state_expression(
    law: Imposed, left: Formula, sign: int, case: Case, level: Level
) -> tuple[Link, ...]:
    """The template's expression for a driver's value, or its opposite; nothing for a number, nor
    where the paper's parameter has the same letters as the algebraic value.
    """
    tree = _find_tree(law, case, level)
    symbols = case.symbols
    letters = {_drop_upper(symbols[name].row) for name in find_names(tree) if name in symbols}
    if isinstance(tree, Number) or _drop_upper(left.print()) in letters:
        return ()
    expression = state_expression(tree, case).signed(sign)
    return equate(count_full_turns(expression) if _counts_turns(tree, case) else expression)


def _counts_turns(tree: Expression, case: Case) -> bool:
    """Whether a parameter of an expression is a number of turns in a time."""
    parameters, symbols = case.template.parameters, case.symbols
    names = (name for name in find_names(tree) if name in parameters)
    return any(is_rotational_speed(symbols[name], parameters[name].unit) for name in names)


def _find_tree(law: Imposed, case: Case, level: Level) -> Expression:
    """The template's expression for a driver's velocity or acceleration."""
    sentence = case.template.scheme.drivers[law.driver]
    return {"velocity": sentence.velocity, "acceleration": sentence.acceleration}[level]


def _drop_upper(row: Row) -> Row:
    """Letters without what stands above them, as the t of a tangential acceleration."""
    *before, last = row
    return (*before, structs.replace(last, upper=None)) if isinstance(last, Scripts) else row


def _state_given(law: Imposed, relation: Relation, case: Case, level: Level) -> Message:
    """What is given, in a sentence."""
    match law:
        case ImposedRotation():
            return _state_given_rotation(law, case, level)
        case ImposedMotion():
            against = _counts_against(law, relation, case, level)
            return say_driven(law, relation, case, level, against=against)
        case ImposedComponent():
            return say_driven_component(law, case, level)
        case ImposedCircling():
            point, centre = case.naming.point(law.point), case.naming.point(law.centre)
            return Message(f"solution.given-circling-{level}", point=point, centre=centre)
        case _:
            assert_never(law)


def is_assumed(law: ImposedRotation, case: Case) -> bool:
    """Whether a driver turns a body as fast as one likes: by a number of the template's, where
    nothing is asked that depends on time, as the place of a pole.
    """
    timeless = all(ask.unit.time == 0 for ask in case.template.asks.values())
    return timeless and isinstance(_find_tree(law, case, "velocity"), Number)


def _state_given_rotation(law: ImposedRotation, case: Case, level: Level) -> Message:
    body = case.naming.body(law.body)
    if law.of == GROUND:
        if level == "velocity" and is_assumed(law, case):
            return Message("solution.assumed-rotation", body=body)
        return Message(f"solution.given-rotation-{level}", body=body)
    other = case.naming.body(law.of)
    return Message(f"solution.given-relative-rotation-{level}", body=body, other=other)
