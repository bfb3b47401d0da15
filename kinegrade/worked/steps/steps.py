"""The steps of the plan in words and equations, for velocities and for accelerations."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from itertools import chain
from typing import assert_never

from kinegrade.language.message import Message
from kinegrade.mechanics.plan import Step
from kinegrade.mechanics.rates import Rate
from kinegrade.mechanics.vector_equation import (
    Level,
    Part,
    VectorEquation,
    is_whole,
    number_together,
    write_vector_equation,
)
from kinegrade.worked.case import Case
from kinegrade.worked.deductions.deductions import explain_deduction
from kinegrade.worked.document import Block
from kinegrade.worked.formulas.atoms import VectorSymbol
from kinegrade.worked.formulas.equation import Equation, equate
from kinegrade.worked.formulas.measures import length
from kinegrade.worked.formulas.numbers import state_number
from kinegrade.worked.rates.scalars import explain_scalar_step, state_relations
from kinegrade.worked.senses import state_way
from kinegrade.worked.steps.base_points import start_from_known
from kinegrade.worked.steps.flat_faces import explain_flat_face
from kinegrade.worked.steps.remarks import (
    explain_corner,
    explain_mark,
    explain_remarks,
    list_equations,
    say_meanings,
)
from kinegrade.worked.steps.term_tables import make_term_table
from kinegrade.worked.steps.titles import introduce_equation, select_scalars
from kinegrade.worked.vectors.arms import find_arms, introduce_lengths
from kinegrade.worked.vectors.coriolis import explain_directions, list_turned
from kinegrade.worked.vectors.facts import has_been_told
from kinegrade.worked.vectors.points import find_point
from kinegrade.worked.vectors.projection import find_deductions
from kinegrade.worked.vectors.stage import Stage
from kinegrade.worked.vectors.table.magnitudes import state_magnitude
from kinegrade.worked.vectors.vectors import UNITS, name_part, name_point_vector


def find_stage(step: Step, case: Case, level: Level, known: Collection[Rate]) -> Stage:
    """The vector equations of a step, at the stage where the rates `known` are known."""
    relations = (case.motion.frames.relations[index] for index in step.relations)
    equations = [
        start_from_known(write_vector_equation(relation, case.motion, known, level))
        for relation in relations
        if relation.is_vector
    ]
    return Stage(number_together(equations), level, case)


def explain_step(step: Step, stage: Stage) -> Iterator[Block]:
    """A step: its equations, the projections, their results."""
    case, scalars = stage.case, select_scalars(step, stage.case)
    if not stage.equations and len(scalars) == 1 and len(step.unknowns) == 1:
        yield from explain_scalar_step(scalars[0], step.unknowns[0], case, stage.level)
        return
    if len(stage.equations) == 1 and _same_path(stage.equations[0]):
        yield from _explain_agreement(stage.equations[0], case)
        return
    for equation in stage.equations:
        yield from _explain_earlier_vectors(equation, case)
    for equation in stage.equations:
        yield from explain_flat_face(equation, case)
        yield case.say(introduce_with_lengths(equation, stage))
        yield from explain_mark(equation, case)
        yield from say_meanings(equation, case)
        yield make_term_table(equation, case)
        yield from explain_remarks(equation, case)
        yield from explain_corner(equation, case)
    yield from explain_directions(list_turned(stage), case)
    for reason, equations in state_relations(scalars, case, stage.level):
        yield case.say(reason)
        yield case.show(*equations)
    solved: set[Rate] = set()
    found = find_deductions(stage.equations, scalars, step.unknowns)
    later = [deduction for deduction in found if not stage.spares(deduction)]
    while later:
        deduction, *later = later
        yield from explain_deduction(stage, deduction, solved, later)
        solved |= set(deduction.unknowns)


def introduce_with_lengths(equation: VectorEquation, stage: Stage) -> Message:
    """The theorem by which an equation holds, and the lengths that the tables of its step need, as
    far as they have not been found.
    """
    case, parts = stage.case, chain.from_iterable(one.parts for one in stage.equations)
    said, arms = introduce_equation(equation, case), find_arms(parts)
    lengths = tuple(map(case.tell, introduce_lengths(arms, case)))
    if not lengths:
        return said
    here = Message("solution.here", equations=list_equations(lengths))
    return Message("solution.sentences", first=said, next=here)


def _name_together(equation: VectorEquation, part: Part, case: Case) -> VectorSymbol:
    """The symbol of several known terms as one vector: of the transport motion, or of the point
    itself.
    """
    match part.role:
        case "transport":
            return name_part(equation, part, case)
        case "absolute" | "relative" | "rotation" | "coriolis":
            return name_point_vector(part.point, equation.level, case)
        case _:
            assert_never(part.role)


def _explain_earlier_vectors(equation: VectorEquation, case: Case) -> Iterator[Block]:
    """How the vectors are found that the equation takes as known and that no earlier step has given
    as one vector.
    """
    for part in equation.parts:
        if not part.together:
            continue
        letters = _name_together(equation, part, case)
        yield from find_point(part.together, letters, case, equation.level)


def _same_path(equation: VectorEquation) -> bool:
    """Whether an equation only says that a guided point moves as a point of a body whose motion is
    known.
    """
    return is_whole(equation.left) and is_whole(equation.right) and len(equation.unknowns) == 1


def _explain_agreement(equation: VectorEquation, case: Case) -> Iterator[Block]:
    """The known motion of the point that both sides describe, unless that has been told."""
    known = next(
        side for side in (equation.left, equation.right) if not any(part.unknown for part in side)
    )
    if all(has_been_told(part, case, equation.level) for part in known):
        return
    term = known[0].term
    if equation.level == "velocity" and term is not None and term.kind == "rotation":
        name = _name_together(equation, known[0], case)
        yield from find_point((term,), name, case, "velocity")
        return
    yield case.say(introduce_equation(equation, case))
    yield case.show(*(_state_known(equation, part, case) for part in known))


def _state_known(equation: VectorEquation, part: Part, case: Case) -> Equation:
    """A known vector with its magnitude and direction."""
    formula = state_magnitude(equation, part, case)
    size = state_number(length(part.value, case.arithmetic), UNITS[equation.level, False])
    links = (*(equate(formula) if formula else ()), *size)
    return Equation(name_part(equation, part, case), links, state_way(part.value, case))
