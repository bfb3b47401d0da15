"""The speeds and rotations that relations without vectors are about: their symbols and values."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, assert_never

from kinegrade.expressions.tree import Call, Expression, Number
from kinegrade.language.math.tree import Row
from kinegrade.language.message import Message
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.rates import Rate, make_turning
from kinegrade.mechanics.relations.terms import Term
from kinegrade.mechanics.vector_equation import Level
from kinegrade.worked.case import Case
from kinegrade.worked.formulas.atoms import ZERO, VectorSymbol
from kinegrade.worked.formulas.equation import Equation
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.leaves import formulate
from kinegrade.worked.formulas.measures import double
from kinegrade.worked.formulas.numbers import measure, state_number
from kinegrade.worked.senses import state_sense_along, state_way_round
from kinegrade.worked.vectors.known_vectors import find_stated_sense
from kinegrade.worked.vectors.relatives import find_relative, index_relative
from kinegrade.worked.vectors.results import state_rotation_result
from kinegrade.worked.vectors.stage import measure_along_direction
from kinegrade.worked.vectors.table.tracks import orient_track
from kinegrade.worked.vectors.vectors import UNITS, name_by_role, name_point_vector


@dataclass(frozen=True)
class Statement:
    """A relation between rates: its title, why it holds, and the relation in symbols."""

    title: Message
    reason: Message
    equation: Equation


def state_rate(rate: Rate, case: Case, level: Level) -> Equation:
    """The value of a rate: an angular velocity, or the speed that belongs to a guided point."""
    match rate.kind:
        case "turning":
            return state_rotation_result(rate, case, level)
        case "sliding" | "circling" | "free-x" | "free-y" | "added-x" | "added-y":
            return _state_speed(find_term(rate, case), case, level)
        case _:
            assert_never(rate.kind)


def _state_speed(term: Term, case: Case, level: Level) -> Equation:
    """The value of a guided point's speed with its sense."""
    value = measure_along_direction(term, case, level) * find_stated_sense(term, case, level)
    links = state_number(value, UNITS[level, False])
    return Equation(name_speed(term, case, level), links, _state_sense(term, case, level))


def _state_sense(term: Term, case: Case, level: Level) -> Row:
    """The sense of a guided point's speed: around its centre, or along its line."""
    value = case.rates(level)[term.rate]
    match term.kind:
        case "arc":
            turn = -double(value) if term.clockwise else double(value)
            return state_way_round(term.base, turn, case) if value else ()
        case "sliding" | "rotation":
            ends = orient_track(term, term.coefficient(), case)
            return state_sense_along(double(value), term.coefficient(), ends, case)
        case _:
            assert_never(term.kind)


def find_term(rate: Rate, case: Case) -> Term:
    """The term of a guided point's rate."""
    frames = case.motion.frames
    chains = [chain for relation in frames.relations for chain in (relation.left, relation.right)]
    chains += [base.chain for base in frames.bases.values()]
    return next(term for chain in chains for term in chain if term.rate == rate)


def name_speed(term: Term, case: Case, level: Level) -> VectorSymbol:
    """The symbol of a guided point's algebraic speed, or of its change."""
    circling = level == "acceleration" and term.kind == "arc"
    if term.frame != GROUND:
        return replace(
            name_by_role("r", level, index_relative(find_relative(term), case)),
            part="t" if circling else "",
        )
    return replace(name_point_vector(term.point, level, case), part="t" if circling else "")


def name_rotation(body: str, case: Case, level: Level) -> Formula:
    """The symbol of a body's rotation; 0 for the ground."""
    return ZERO if body == GROUND else case.naming.turning(body, level)


def name_carried_rotation(of: str, case: Case, level: Level) -> Formula:
    """The rotation that a body gives to what it carries; 0 if it does not turn."""
    still = of in case.translating
    return ZERO if still else name_rotation(of, case, level)


def find_rotation_value(body: str, case: Case, level: Level) -> Any:
    """The value of a body's rotation; 0 for the ground."""
    rates = case.rates(level)
    return 0 if body == GROUND else rates[make_turning(body)]


def name_relative_rotation(body: str, of: str, case: Case, level: Level) -> Formula:
    """The rotation of one body relative to another, which says nothing if it does not turn."""
    rotation = name_rotation(body, case, level)
    carried = name_carried_rotation(of, case, level)
    return rotation if carried == ZERO else rotation - carried


def state_expression(tree: Expression, case: Case) -> Formula:
    """An expression of the template in symbols."""
    return formulate(case.symbols).state(tree)


def state_radius(circle: Call | None, radius: Any, case: Case) -> Formula:
    """The radius of a circle in the template's symbols; its number where the template has none."""
    stated = circle.arguments[1] if circle else None
    if stated is None or isinstance(stated, Number):
        return measure(radius, "m")
    return state_expression(stated, case)
