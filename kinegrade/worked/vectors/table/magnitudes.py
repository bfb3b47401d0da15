"""The magnitude and direction of each vector of an equation, as the table below it states them."""

from __future__ import annotations

from typing import Any, assert_never

from kinegrade.mechanics.relations.terms import Term
from kinegrade.mechanics.vector_equation import Part, VectorEquation
from kinegrade.worked.case import Case
from kinegrade.worked.formulas.atoms import TWO
from kinegrade.worked.formulas.equation import Equation
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.measures import length
from kinegrade.worked.formulas.numbers import state_number
from kinegrade.worked.vectors.arms import name_length
from kinegrade.worked.vectors.table.directions import find_omega
from kinegrade.worked.vectors.vectors import (
    UNITS,
    name_by_role,
    name_point_vector,
    number_composition,
)


def describe_magnitude(equation: VectorEquation, part: Part, case: Case) -> str:
    """The magnitude of a part in prose: its formula, and its number or a question mark."""
    formula = state_magnitude(equation, part, case)
    if part.unknown:
        return f"? $({case.text(formula)})$" if formula else "?"
    *_, number = state_number(length(part.value, case.arithmetic), UNITS[equation.level, False])
    if formula is None:
        return f"${case.text(number.right)}$"
    return case.tell(Equation(formula, (number,)))


def state_magnitude(equation: VectorEquation, part: Part, case: Case) -> Formula | None:
    """The formula of a part's magnitude, None where it has none."""
    term = part.term
    if term is None:
        return None
    match part.role:
        case "coriolis":
            relative = name_by_role("r", "velocity", number_composition(equation, part, case))
            omega = find_omega(case, term.frame)
            speed = case.motion.rates[term.rate]
            turned = _take_size(case.naming.omega(term.frame), omega)
            return TWO * turned * _take_size(relative, speed)
        case "absolute" | "transport" | "relative" | "rotation":
            return _state_term_magnitude(equation, part, term, case)
        case _:
            assert_never(part.role)


def _state_term_magnitude(
    equation: VectorEquation, part: Part, term: Term, case: Case
) -> Formula | None:
    """The formula of the magnitude of a term's velocity, or of a part of its acceleration; None
    where it has none.
    """
    match term.kind:
        case "sliding":
            return None
        case "arc" if part.part != "n":
            return None
        case "arc":
            return _name_speed(equation, part, case) ** TWO / name_length(
                part.base, part.point, case
            )
        case "rotation":
            return _state_rotation_magnitude(equation, part, term, case)
        case _:
            assert_never(term.kind)


def _state_rotation_magnitude(
    equation: VectorEquation, part: Part, term: Term, case: Case
) -> Formula:
    """The length times the angular velocity, its square, or the angular acceleration."""
    arm, body = name_length(part.base, part.point, case), term.rate.body
    match part.part:
        case "n":
            return arm.dot(case.naming.omega(body) ** TWO)
        case "" | "t":
            rate = case.naming.turning(body, equation.level)
            value = case.rates(equation.level)[term.rate]
            return arm.dot(rate if part.unknown else _take_size(rate, value))
        case _:
            assert_never(part.part)


def _name_speed(equation: VectorEquation, part: Part, case: Case) -> Formula:
    """The speed on a circular path: v_r, or v_A on a fixed circle."""
    match part.role:
        case "relative":
            return name_by_role("r", "velocity", number_composition(equation, part, case))
        case "absolute" | "transport" | "rotation" | "coriolis":
            return name_point_vector(part.point, "velocity", case)
        case _:
            assert_never(part.role)


def _take_size(symbol: Formula, value: Any) -> Formula:
    """A symbol, between bars where its value is negative."""
    return symbol if float(value) >= 0 else abs(symbol)
