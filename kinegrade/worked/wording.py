"""Titles and introductions of the steps: which theorem each equation uses."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kinegrade.mechanics.joints import GROUND
from kinegrade.mechanics.plan import Step
from kinegrade.mechanics.relations import Relation, Term
from kinegrade.mechanics.vector_equation import Part, VectorEquation
from kinegrade.worked.deductions import Stage
from kinegrade.worked.phrases import fill_phrase
from kinegrade.worked.scalars import name_body, state_relation
from kinegrade.worked.solution_case import Case
from kinegrade.worked.vectors import (
    is_composed,
    vanishes,
    write_composition_number,
    write_letter,
    write_letters,
    write_primed,
)


def select_scalars(step: Step, case: Case) -> tuple[Relation, ...]:
    """The relations of a step that are not vector equations."""
    relations = (case.motion.frames.relations[index] for index in step.relations)
    return tuple(relation for relation in relations if not relation.is_vector)


def write_title(step: Step, stage: Stage) -> str:
    """The title of a step."""
    case, scalars = stage.case, select_scalars(step, stage.case)
    if len(stage.equations) == 1:
        return _write_equation_title(stage.equations[0], case)
    if stage.equations:
        count = fill_phrase(f"count_{len(stage.equations)}", case.language)
        return fill_phrase("title_together", case.language, count=count)
    return state_relation(scalars[0], case, stage.level).title


def _write_equation_title(equation: VectorEquation, case: Case) -> str:
    """The title of a step of one vector equation: by its method."""
    compositions = equation.compositions
    if len(compositions) > 1:
        return fill_phrase(
            "title_composed_twice", case.language, point=case.naming.point(compositions[0].point)
        )
    if compositions:
        return fill_phrase(
            "title_composed",
            case.language,
            point=case.naming.point(compositions[0].point),
            frame=case.naming.body(compositions[0].frame),
        )
    rotation = next((part for part in equation.parts if part.role == "rotation"), None)
    if rotation is None:
        return fill_phrase(
            "title_fixed", case.language, point=case.naming.point(equation.parts[0].point)
        )
    bases = fill_phrase("and", case.language).join(
        f"${case.naming.point(term.base)}$" for term in _find_rotations(equation)
    )
    key = "title_base" if len(_find_rotations(equation)) == 1 else "title_bases"
    return fill_phrase(key, case.language, body=_name_turning_bodies(equation, case), base=bases)


def _find_rotations(equation: VectorEquation) -> tuple[Term, ...]:
    """The rotations about base points in an equation, in order."""
    found = {
        part.term.rate: part.term
        for part in equation.parts
        if part.role == "rotation" and part.term
    }
    return tuple(found.values())


def _name_turning_bodies(equation: VectorEquation, case: Case) -> str:
    """The bodies that turn about base points in an equation, in prose."""
    names = dict.fromkeys(
        part.term.rate.removeprefix("omega ")
        for part in equation.parts
        if part.role == "rotation" and part.term
    )
    return fill_phrase("and", case.language).join(case.naming.body(name) for name in names)


def write_introduction(equation: VectorEquation, case: Case) -> str:
    """The theorem by which the equation holds."""
    compositions = equation.compositions
    if len(compositions) == 1:
        relative = compositions[0]
        return fill_phrase(
            f"composed_{equation.level}",
            case.language,
            point=case.naming.point(relative.point),
            frame=case.naming.body(relative.frame),
            of=_name_owner(equation, case),
        )
    if compositions:
        return _describe_two_frames(equation, compositions, case)
    turning = _find_rotations(equation)
    if not turning:
        return fill_phrase(
            "equal_motion", case.language, point=case.naming.point(equation.parts[0].point)
        )
    if len(turning) > 1:
        return _describe_chained_bases(equation, turning, case)
    return fill_phrase(
        f"base_equation_{equation.level}",
        case.language,
        body=_name_turning_bodies(equation, case),
        point=case.naming.point(turning[0].point),
        base=case.naming.point(turning[0].base),
    )


def _describe_chained_bases(equation: VectorEquation, turning: Sequence[Term], case: Case) -> str:
    """The sentence for a point reached through several rotating bodies, one after the other."""
    legs = (
        fill_phrase(
            "leg",
            case.language,
            point=case.naming.point(term.point),
            base=case.naming.point(term.base),
            body=case.naming.body(term.rate.removeprefix("omega ")),
        )
        for term in turning
    )
    joined = fill_phrase("legs", case.language).join(legs)
    return fill_phrase(f"base_chain_{equation.level}", case.language, legs=joined)


def _describe_two_frames(equation: VectorEquation, compositions: Sequence[Part], case: Case) -> str:
    """The sentence for a point relative to two moving frames, or for a point of one that slides in
    another.
    """
    names = [case.naming.body(part.frame) for part in compositions]
    points = [case.naming.point(part.point) for part in compositions]
    if any(part in equation.left for part in compositions) and any(
        part in equation.right for part in compositions
    ):
        return fill_phrase(
            f"composed_twice_{equation.level}",
            case.language,
            point=points[0],
            frames=fill_phrase("and", case.language).join(names),
        )
    return fill_phrase(
        f"composed_on_{equation.level}",
        case.language,
        first=points[0],
        frame=names[0],
        second=points[1],
        primed=write_primed(points[1]),
        other=names[1],
    )


def describe_meanings(equation: VectorEquation, case: Case) -> Iterator[str]:
    """What the absolute and the transport vector of a composition consist of, where they are not
    single parts.
    """
    if len(equation.compositions) != 1:
        return
    relative = equation.compositions[0]
    side, other = (
        (equation.left, equation.right)
        if relative in equation.left
        else (equation.right, equation.left)
    )
    transport = [part for part in side if part.role not in ("relative", "coriolis")]
    number = write_composition_number(equation, relative)
    for role, parts in (("a", other), ("e", transport)):
        symbols = [
            write_letters(equation, part, case, bold=True) for part in parts if not vanishes(part)
        ]
        if not parts or not all(
            part.role == "transport" or is_composed(equation, part) for part in parts
        ):
            symbol = rf"\boldsymbol{{{write_letter(equation)}}}_{{\mathrm{{{role}}}{number}}}"
            yield f"${symbol}={'+'.join(symbols) or '0'}$"


def _name_owner(equation: VectorEquation, case: Case) -> str:
    """The body whose point moves in the moving frame."""
    body = getattr(equation.relation.source, "body", GROUND)
    if body == GROUND:
        return fill_phrase("of_ground", case.language)
    return fill_phrase("of_body", case.language, body=name_body(body, case))
