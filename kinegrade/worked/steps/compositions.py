"""Composition of motions: the sentences that introduce it, and what the absolute and the transport
vector consist of.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import assert_never

from kinegrade.language.math.tree import Row
from kinegrade.language.message import Message, Text, list_all
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.laws import find_rolling
from kinegrade.mechanics.vector_equation import Part, VectorEquation
from kinegrade.worked.case import Case
from kinegrade.worked.coincident_points import prime_letter
from kinegrade.worked.formulas.atoms import add_terms
from kinegrade.worked.formulas.equation import Equation, equate
from kinegrade.worked.vectors.vectors import (
    is_composed,
    name_by_role,
    name_coriolis,
    name_part,
    name_point_vector,
    number_composition,
    vanishes,
)


def introduce_composition(equation: VectorEquation, relative: Part, case: Case) -> Message:
    """The composition of the motions of a point relative to a moving frame, explained once for the
    points of a body.
    """
    number = number_composition(equation, relative, case)
    whole = name_by_role("a", equation.level, _index_absolute(equation, number), bold=True)
    coriolis = name_coriolis(number, bold=True)
    turning = {"velocity": (), "acceleration": (coriolis,)}[equation.level]
    roles = [name_by_role(role, equation.level, number, bold=True) for role in "er"]
    composed = case.tell(Equation(whole, equate(add_terms((*roles, *turning)))))
    point, frame = case.naming.point(relative.point), case.naming.body(relative.frame)
    source = equation.relation.source
    body = source.find_guided_body() if source is not None else None
    explained = (equation.level, relative.frame, body)
    if explained in case.findings.composed:
        return Message("solution.composed-likewise", point=point, composed=composed)
    case.findings.composed.add(explained)
    match equation.level:
        case "velocity":
            places: dict[str, Text] = {"composed": composed, "point": point, "frame": frame}
            if body is None:
                return Message("solution.composed-velocity-of-fixed-point", **places)
            return Message("solution.composed-velocity", body=case.naming.body(body), **places)
        case "acceleration":
            vectors = zip(("transport", "relative", "coriolis"), (*roles, coriolis), strict=True)
            letters = {name: case.text(vector) for name, vector in vectors}
            named: dict[str, Text] = {
                "composed": composed,
                "point": point,
                "frame": frame,
                **letters,
            }
            return Message("solution.composed-acceleration", **named)
        case _:
            assert_never(equation.level)


def introduce_two_frames(
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
                primed=case.text(prime_letter(compositions[1].point, case)),
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


def _find_called(equation: VectorEquation, case: Case) -> Part | None:
    """The absolute motion of a composition that has been called by the letter of its point: a given
    one, or the centre's of a body which rolls on a track, whose relation calls it so.
    """
    rolls = (find_rolling(relation.source) for relation in case.motion.frames.relations)
    centres = {roll.circle.centre for roll in rolls if roll and roll.of == GROUND}
    absolute = [
        part
        for part in equation.parts
        if part.role == "absolute" and not part.part and is_composed(equation, part)
    ]
    if len(absolute) != 1 or vanishes(absolute[0]):
        return None
    called = name_point_vector(absolute[0].point, equation.level, case)
    given = any(one.left.looks_like(called) for one in case.findings.printed)
    return absolute[0] if given or absolute[0].point in centres else None


def describe_meanings(equation: VectorEquation, case: Case) -> Iterator[Text]:
    """What the absolute and the transport vector of a composition consist of, where they are not
    single parts, and from which base point where that is a rotation about one.
    """
    if len(equation.compositions) != 1:
        return
    absolute = _find_called(equation, case)
    if absolute is not None:
        symbol = name_part(equation, absolute, case, bold=True)
        called = replace(name_point_vector(absolute.point, equation.level, case), bold=True)
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
            meant = case.tell(Equation(symbol, equate(add_terms(symbols))))
            first = equation.level == "velocity" and len(symbols) > 1
            turning = [part for part in parts if first and part.role == "rotation"]
            yield _tell_base(meant, turning[0], case) if len(turning) == 1 else meant


def _tell_base(vector: str, turning: Part, case: Case) -> Text:
    """A sum with the base point about which its last vector turns."""
    if turning.term is None:
        return vector
    base, body = case.naming.point(turning.base), case.naming.body(turning.term.rate.body)
    return Message("solution.from-base-point", vector=vector, base=base, body=body)
