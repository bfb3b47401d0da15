"""What is said beside a vector equation: what its vectors consist of, which of them vanish, and
which point a letter denotes.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Set
from dataclasses import replace
from functools import reduce
from typing import assert_never

from kinegrade.language.message import Message, Text
from kinegrade.mechanics.vector_equation import Level, Part, VectorEquation
from kinegrade.worked.case import Case
from kinegrade.worked.coincident_points import name_place
from kinegrade.worked.document import Block
from kinegrade.worked.formulas.atoms import ZERO
from kinegrade.worked.formulas.equation import Equation, equate
from kinegrade.worked.steps.compositions import describe_meanings
from kinegrade.worked.steps.polygons import (
    has_corner,
    name_shared_corner,
    spans_polygon,
    write_corner,
)
from kinegrade.worked.translations import say_translation
from kinegrade.worked.vectors.coriolis import explain_absences
from kinegrade.worked.vectors.vectors import name_part, vanishes


def say_meanings(equation: VectorEquation, case: Case) -> Iterator[Block]:
    """What a composition's vectors consist of, and what they have been called before."""
    listed = tuple(describe_meanings(equation, case))
    if listed:
        yield case.say(Message("solution.here", equations=list_equations(listed)))


def explain_remarks(equation: VectorEquation, case: Case) -> Iterator[Block]:
    """Which parts of an equation vanish, and why."""
    shifted = _find_shifted(equation, case)
    for name in sorted(shifted):
        yield from _say_translation(name, equation.level, case)
    gone = [
        part
        for part in equation.parts
        if vanishes(part)
        and not _turns_with_held_body(part, case)
        and not (shifted and part.role == "coriolis")
    ]
    zeros = dict.fromkeys(
        _state_zero(equation, part, case) for part in gone if part.role != "coriolis"
    )
    if zeros:
        yield case.say(Message("solution.zero-parts", zeros=list_equations(zeros)))
    absent = [(part, _state_zero(equation, part, case)) for part in gone if part.role == "coriolis"]
    yield from map(case.say, explain_absences(absent, case))


def _state_zero(equation: VectorEquation, part: Part, case: Case) -> str:
    return case.tell(Equation(name_part(equation, part, case), equate(ZERO)))


def _say_translation(name: str, level: Level, case: Case) -> Iterator[Block]:
    """What follows for the points of a body that translates."""
    match level:
        case "velocity":
            yield from say_translation(name, level, case)
        case "acceleration":
            frame = case.naming.body(name)
            yield case.say(Message("solution.shifted-acceleration", frame=frame))
        case _:
            assert_never(level)


def _turns_with_held_body(part: Part, case: Case) -> bool:
    """Whether a part is the rotation of a body of which has been said that it translates."""
    return part.role == "rotation" and part.term is not None and part.term.rate in case.held_rates


def _find_shifted(equation: VectorEquation, case: Case) -> Set[str]:
    """The bodies that translate and of which a point is meant that coincides with another."""
    meant = {part.term.rate.body for part in equation.parts if part.coincident and part.term}
    return meant & case.translating


def explain_mark(equation: VectorEquation, case: Case) -> Iterator[Block]:
    """Which point a primed letter denotes, said once."""
    marked = next((part for part in equation.parts if part.coincident), None)
    if marked and marked.term and not _find_shifted(equation, case):
        mark = case.text(name_place(marked, case))
        if mark in case.findings.coincident:
            return
        case.findings.coincident.add(mark)
        yield case.say(
            Message(
                "solution.coincident",
                mark=mark,
                point=case.naming.point(marked.point),
                frame=case.naming.body(marked.term.rate.body),
            )
        )


def explain_corner(equation: VectorEquation, case: Case) -> Iterator[Block]:
    """Which points the primed letters in a polygon stand for, said once, unless the letters of the
    points themselves have been explained.
    """
    if not spans_polygon(equation):
        return
    explained = {write_corner(mark) for mark in case.findings.coincident} | case.findings.corners
    for relative in equation.compositions:
        corner = name_shared_corner(relative, equation, case)
        if corner not in explained and has_corner(corner, equation, case):
            case.findings.corners.add(corner)
            point, frame = case.naming.point(relative.point), case.naming.body(relative.frame)
            said = case.say(Message("solution.corner", corner=corner, point=point, frame=frame))
            yield replace(said, on_polygon=True)


def list_equations(equations: Iterable[Text]) -> Text:
    """Equations in a sentence, one after another."""
    return reduce(
        lambda first, following: Message("solution.equation-list", first=first, next=following),
        equations,
    )
