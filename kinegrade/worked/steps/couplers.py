"""Two points of one body, the velocity of one known, the direction of the other's: what the
projection theorem and the pole apply to.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import assert_never

from kinegrade.language.math.tree import Row
from kinegrade.language.message import Message
from kinegrade.mechanics.vector_equation import Part, VectorEquation, is_whole
from kinegrade.problem.pole_names import find_poles
from kinegrade.problem.template.template import Method
from kinegrade.worked.case import Case
from kinegrade.worked.document import Block
from kinegrade.worked.formulas.equation import Equation, equate
from kinegrade.worked.formulas.measures import length
from kinegrade.worked.formulas.numbers import state_number
from kinegrade.worked.senses import state_way, state_way_about
from kinegrade.worked.steps.rigid import find_rigid_triangle, name_triangle
from kinegrade.worked.vectors.facts import has_been_told
from kinegrade.worked.vectors.known_vectors import is_stated_negative
from kinegrade.worked.vectors.stage import Stage
from kinegrade.worked.vectors.table.magnitudes import state_magnitude
from kinegrade.worked.vectors.vectors import name_part, vanishes


@dataclass(frozen=True)
class Coupler:
    """Two points of one body: the velocity of `base` is known, the direction of that of `point`."""

    equation: VectorEquation
    base: Part
    point: Part
    rotation: Part

    @property
    def body(self) -> str:
        """The body that carries both points."""
        return self.rotation.unknown.body if self.rotation.unknown else ""


def name_method(stage: Stage) -> Message | None:
    """The title of a step by another method than the base point's, else None."""
    triangle = find_rigid_triangle(stage)
    if triangle is not None:
        return name_triangle(triangle, stage.case)
    coupler = find_coupler(stage)
    return _name_method_for(coupler, stage.case) if coupler else None


def _name_method_for(coupler: Coupler, case: Case) -> Message | None:
    body, method = case.naming.body(coupler.body), choose_method(coupler, case)
    match method:
        case "base-point":
            return None
        case "projection":
            return Message("solution.title-projection", body=body)
        case "pole":
            return Message("solution.title-pole", body=body)
        case _:
            assert_never(method)


def choose_method(coupler: Coupler, case: Case) -> Method:
    """The method asked for; else the pole where an answer is about it, or where the body does not
    turn.
    """
    if case.method is not None:
        return case.method
    asked = find_poles(case.template.asks[name] for name in case.solution.answers)
    still = case.arithmetic.is_zero(case.motion.omega(coupler.body))
    return "pole" if coupler.body in asked or still else "base-point"


def goes_by_pole(stage: Stage) -> bool:
    """Whether a step is told by the pole of a body that turns."""
    coupler, case = find_coupler(stage), stage.case
    if coupler is None or case.arithmetic.is_zero(case.motion.omega(coupler.body)):
        return False
    return choose_method(coupler, case) == "pole"


def find_coupler(stage: Stage) -> Coupler | None:
    """The two points of a step of one velocity equation v_B = v_A + v_BA; None for any other
    step.
    """
    if stage.level != "velocity" or len(stage.equations) != 1:
        return None
    equation = stage.equations[0]
    whole, other = equation.left, equation.right
    if not (
        is_whole(whole) and len(whole) == 1 and len(other) == 2 and other[1].role == "rotation"
    ):
        return None
    if whole[0].unknown is None:  # v_B known, v_A sought: A and B change places
        known, sought = whole[0], other[0]
    else:
        known, sought = other[0], whole[0]
    if (
        known.unknown
        or not sought.unknown
        or not other[1].unknown
        or vanishes(known)
        or sought.role != "absolute"
    ):
        return None
    return Coupler(equation, known, sought, other[1])


def explain_base_speed(coupler: Coupler, case: Case) -> Iterator[Block]:
    """The speed of the point whose velocity is known, where it follows from a rotation about a
    fixed axis and has not been told.
    """
    if has_been_told(coupler.base, case, "velocity"):
        return
    formula = state_magnitude(coupler.equation, coupler.base, case)
    term = coupler.base.term
    if formula and term and not is_stated_negative(term, case, "velocity"):
        value = coupler.base.value
        links = (*equate(formula), *state_number(length(value, case.arithmetic), "m/s"))
        symbol = name_part(coupler.equation, coupler.base, case)
        yield case.show(Equation(symbol, links, _state_way(coupler.base, case)))


def _state_way(part: Part, case: Case) -> Row:
    """The direction of a known velocity: about a fixed point where it turns about one."""
    if part.term is None or part.term.kind == "sliding":
        return state_way(part.value, case)
    return state_way_about(part.value, part.term.vector, part.base, case)


def find_pole_body(stage: Stage) -> str | None:
    """The body whose pole a step finds by normals to velocities."""
    coupler = find_coupler(stage)
    if coupler is None or choose_method(coupler, stage.case) != "pole":
        return None
    return coupler.body
