"""Titles and introductions of the steps: which theorem each equation uses."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import reduce

from kinegrade.language.message import Listing, Message, list_all
from kinegrade.mechanics.plan import Step
from kinegrade.mechanics.relations.relation import Relation
from kinegrade.mechanics.relations.terms import Term
from kinegrade.mechanics.vector_equation import VectorEquation
from kinegrade.worked.case import Case
from kinegrade.worked.rates.scalars import state_relation
from kinegrade.worked.steps.compositions import introduce_composition, introduce_two_frames
from kinegrade.worked.vectors.stage import Stage
from kinegrade.worked.vectors.vectors import vanishes

_TOGETHER: Mapping[int, Message] = {
    2: Message("solution.title-two-equations"),
    3: Message("solution.title-three-equations"),
    4: Message("solution.title-four-equations"),
}


def select_scalars(step: Step, case: Case) -> tuple[Relation, ...]:
    """The relations of a step that are not vector equations."""
    relations = (case.motion.frames.relations[index] for index in step.relations)
    return tuple(relation for relation in relations if not relation.is_vector)


def name_step(step: Step, stage: Stage) -> Message:
    """The title of a step."""
    case, scalars = stage.case, select_scalars(step, stage.case)
    if len(stage.equations) == 1:
        return _name_equation(stage.equations[0], case)
    if stage.equations:
        return _TOGETHER[len(stage.equations)]
    return state_relation(scalars[0], case, stage.level).title


def _name_equation(equation: VectorEquation, case: Case) -> Message:
    """The title of a step of one vector equation: by its method."""
    compositions, rotations = equation.compositions, find_rotations(equation)
    if len(compositions) > 1:
        point = case.naming.point(compositions[0].point)
        return Message("solution.title-composed-twice", point=point)
    if compositions:
        return Message(
            "solution.title-composed",
            point=case.naming.point(compositions[0].point),
            frame=case.naming.body(compositions[0].frame),
        )
    if not rotations:
        return Message("solution.title-fixed", point=case.naming.point(equation.parts[0].point))
    bases = list_all(f"${case.naming.point(term.base)}$" for term in rotations)
    body = _list_turning_bodies(equation, case)
    if len(rotations) == 1:
        return Message("solution.title-base", body=body, base=bases)
    return Message("solution.title-bases", body=body, bases=bases)


def find_rotations(equation: VectorEquation) -> tuple[Term, ...]:
    """The rotations about base points in an equation, in order."""
    found = {
        part.term.rate: part.term
        for part in equation.parts
        if part.role == "rotation" and part.term
    }
    return tuple(found.values())


def _list_turning_bodies(equation: VectorEquation, case: Case) -> Listing:
    """The bodies that turn about base points in an equation, in prose."""
    return list_all(case.naming.body(_find_body(term)) for term in find_rotations(equation))


def _find_body(term: Term) -> str:
    """The body that turns in a term."""
    return term.rate.body


def introduce_equation(equation: VectorEquation, case: Case) -> Message:
    """The theorem by which the equation holds, and once what the indices of its parts mark."""
    said = _introduce_theorem(equation, case)
    marked = any(part.part and not vanishes(part) for part in equation.parts)
    if not marked or case.findings.parts_explained:
        return said
    case.findings.parts_explained = True
    if said.key == "solution.base-equation-acceleration":
        return said
    return Message("solution.sentences", first=said, next=Message("solution.normal-and-tangential"))


def _introduce_theorem(equation: VectorEquation, case: Case) -> Message:
    """The theorem by which the equation holds."""
    compositions = equation.compositions
    if len(compositions) == 1:
        return introduce_composition(equation, compositions[0], case)
    if compositions:
        return introduce_two_frames(equation, compositions, case)
    turning = find_rotations(equation)
    if not turning:
        return Message("solution.equal-motion", point=case.naming.point(equation.parts[0].point))
    if len(turning) > 1:
        return _introduce_chained_bases(equation, turning, case)
    if _find_body(turning[0]) in case.translating:
        body = _find_body(turning[0])
        case.findings.translated[equation.level].add(body)
        return Message(f"solution.same-{equation.level}", body=case.naming.body(body))
    return Message(
        f"solution.base-equation-{equation.level}",
        body=_list_turning_bodies(equation, case),
        point=case.naming.point(turning[0].point),
        base=case.naming.point(turning[0].base),
    )


def _introduce_chained_bases(
    equation: VectorEquation, turning: Sequence[Term], case: Case
) -> Message:
    """The sentence for a point reached through several rotating bodies, one after the other."""
    legs = (
        Message(
            "solution.leg",
            point=case.naming.point(term.point),
            base=case.naming.point(term.base),
            body=case.naming.body(_find_body(term)),
        )
        for term in turning
    )
    return Message(f"solution.base-chain-{equation.level}", legs=reduce(_list_legs, legs))


def _list_legs(first: Message, following: Message) -> Message:
    return Message("solution.leg-list", first=first, next=following)
