"""Titles and introductions of the steps: which theorem each equation uses."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import reduce
from typing import assert_never

from kinegrade.language.math.tree import Row
from kinegrade.language.message import Listing, Message, Text, list_all
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.plan import Step
from kinegrade.mechanics.relations import Relation, Term
from kinegrade.mechanics.vector_equation import Part, VectorEquation
from kinegrade.worked.case import Case
from kinegrade.worked.formulas.atoms import add_terms
from kinegrade.worked.formulas.equation import Equation, equate
from kinegrade.worked.formulas.symbols import prime
from kinegrade.worked.rates.scalars import state_relation
from kinegrade.worked.vectors.stage import Stage
from kinegrade.worked.vectors.vectors import (
    is_composed,
    name_by_role,
    name_coriolis,
    name_part,
    name_point_vector,
    number_composition,
    vanishes,
)

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
    """The theorem by which the equation holds."""
    compositions = equation.compositions
    if len(compositions) == 1:
        return _introduce_composition(equation, compositions[0], case)
    if compositions:
        return _introduce_two_frames(equation, compositions, case)
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


def _introduce_composition(equation: VectorEquation, relative: Part, case: Case) -> Message:
    """The composition of the motions of a point relative to a moving frame."""
    number = number_composition(equation, relative, case)
    whole = name_by_role("a", equation.level, _index_absolute(equation, number), bold=True)
    vectors = [name_by_role(role, equation.level, number, bold=True) for role in "er"]
    turned = name_coriolis(number, bold=True)
    absolute, transport, seen, coriolis = map(case.text, (whole, *vectors, turned))
    point, frame = case.naming.point(relative.point), case.naming.body(relative.frame)
    places: dict[str, Text] = {
        "point": point,
        "frame": frame,
        "absolute": absolute,
        "transport": transport,
        "relative": seen,
    }
    match equation.level:
        case "velocity":
            source = equation.relation.source
            body = source.find_guided_body() if source is not None else None
            if body is None:
                return Message("solution.composed-velocity-of-fixed-point", **places)
            return Message("solution.composed-velocity", body=case.naming.body(body), **places)
        case "acceleration":
            return Message("solution.composed-acceleration", coriolis=coriolis, **places)
        case _:
            assert_never(equation.level)


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


def _introduce_two_frames(
    equation: VectorEquation, compositions: Sequence[Part], case: Case
) -> Message:
    """The sentence for a point relative to two moving frames, or for a point of one that slides in
    another.
    """
    names = [case.naming.body(part.frame) for part in compositions]
    points = [case.naming.point(part.point) for part in compositions]
    if any(part in equation.left for part in compositions) and any(
        part in equation.right for part in compositions
    ):
        return Message(
            f"solution.composed-twice-{equation.level}", point=points[0], frames=list_all(names)
        )
    match equation.level:
        case "velocity":
            return Message(
                "solution.composed-on-velocity",
                first=points[0],
                frame=names[0],
                second=points[1],
                primed=case.text(prime(case.naming.letter(compositions[1].point))),
                other=names[1],
            )
        case "acceleration":
            return Message("solution.composed-on-acceleration", second=points[1])
        case _:
            assert_never(equation.level)


def _index_absolute(equation: VectorEquation, number: Row) -> Row:
    """The index of an absolute vector: none of a single composition, whatever its other vectors
    have, nor where the equation has it as a part.
    """
    alone = any(part.role == "absolute" and is_composed(equation, part) for part in equation.parts)
    return () if alone or equation.among == 1 else number


def _find_rolling_centre(equation: VectorEquation, case: Case) -> Part | None:
    """The absolute motion of a composition that is the centre's of a body which rolls on a track:
    the relation of this one calls it by the letter of the point.
    """
    sources = (relation.source for relation in case.motion.frames.relations)
    rolls = [roll for source in sources if source and (roll := source.find_rolling())]
    centres = {roll.circle.centre for roll in rolls if roll.of == GROUND}
    absolute = [part for part in equation.parts if part.role == "absolute" and not part.part]
    known = len(absolute) == 1 and absolute[0].point in centres
    return absolute[0] if known and is_composed(equation, absolute[0]) else None


def describe_meanings(equation: VectorEquation, case: Case) -> Iterator[str]:
    """What the absolute and the transport vector of a composition consist of, where they are not
    single parts.
    """
    if len(equation.compositions) != 1:
        return
    centre = _find_rolling_centre(equation, case)
    if centre is not None:
        symbol = name_part(equation, centre, case, bold=True)
        called = replace(name_point_vector(centre.point, equation.level, case), bold=True)
        yield case.tell(Equation(symbol, equate(called)))
    relative = equation.compositions[0]
    side, other = (
        (equation.left, equation.right)
        if relative in equation.left
        else (equation.right, equation.left)
    )
    transport = [part for part in side if part.role not in ("relative", "coriolis")]
    number = number_composition(equation, relative, case)
    for role, parts in (("a", other), ("e", transport)):
        symbols = tuple(
            name_part(equation, part, case, bold=True) for part in parts if not vanishes(part)
        )
        if not parts or not all(
            part.role == "transport" or is_composed(equation, part) for part in parts
        ):
            index = _index_absolute(equation, number) if role == "a" else number
            symbol = name_by_role(role, equation.level, index, bold=True)
            yield case.tell(Equation(symbol, equate(add_terms(symbols))))
