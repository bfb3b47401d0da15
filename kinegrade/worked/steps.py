"""The steps of the plan in words and equations, for velocities and for accelerations."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from typing import assert_never

from kinegrade.mechanics.plan import Step
from kinegrade.mechanics.vector_equation import (
    Level,
    Part,
    VectorEquation,
    is_whole,
    together,
    vector_equation,
)
from kinegrade.worked.deductions import UNITS, Stage, deduced
from kinegrade.worked.document import Block, Display, Prose, Term, TermTable
from kinegrade.worked.kinds import translating
from kinegrade.worked.numbers import bracketed, double, length, short, stated
from kinegrade.worked.phrases import phrase
from kinegrade.worked.points import Fact, Findings, find_point, key_of, point_symbol, way
from kinegrade.worked.projection import deductions
from kinegrade.worked.scalars import body_or_ground, scalar_step, stated_relation
from kinegrade.worked.solution_case import Case
from kinegrade.worked.summands import component
from kinegrade.worked.vectors import (
    direction,
    letters_of,
    magnitude,
    magnitude_formula,
    subscript,
    vanishes,
)
from kinegrade.worked.wording import introduction, meanings, scalars_of


def stage_of(step: Step, case: Case, level: Level, known: Collection[str]) -> Stage:
    """The vector equations of a step, at the stage where the rates `known` are known."""
    relations = (case.motion.frames.relations[index] for index in step.relations)
    equations = [
        vector_equation(relation, case.motion, known, level)
        for relation in relations
        if relation.is_vector
    ]
    return Stage(together(equations), level, case)


def step_blocks(step: Step, stage: Stage, findings: Findings) -> Iterator[Block]:
    """A step: its equations, the projections, their results."""
    case, scalars = stage.case, scalars_of(step, stage.case)
    if not stage.equations and len(scalars) == 1 and len(step.unknowns) == 1:
        yield from scalar_step(scalars[0], step.unknowns[0], case, stage.level)
        return
    if len(stage.equations) == 1 and same_path(stage.equations[0]):
        yield from agreement(stage.equations[0], case)
        return
    for equation in stage.equations:
        yield from found_before(equation, case, findings)
    for equation in stage.equations:
        yield from contact(equation, case)
        yield Prose(introduction(equation, case))
        yield table(equation, case)
        yield from remarks(equation, case)
    for relation in scalars:
        statement = stated_relation(relation, case, stage.level)
        yield Prose(statement.reason)
        yield Display((statement.line,))
    solved: set[str] = set()
    for deduction in deductions(stage.equations, scalars, step.unknowns):
        yield from deduced(stage, deduction, solved)
        solved |= set(deduction.unknowns)


def letters_together(equation: VectorEquation, part: Part, case: Case) -> str:
    """The symbol of several known terms as one vector: of the transport motion, or of the point
    itself.
    """
    match part.role:
        case "transport":
            return letters_of(equation, part, case)
        case "absolute" | "relative" | "rotation" | "coriolis":
            return point_symbol(part.point, equation.level, case)
        case _:
            assert_never(part.role)


def found_before(equation: VectorEquation, case: Case, findings: Findings) -> Iterator[Block]:
    """How the vectors are found that the equation takes as known and that no earlier step has given
    as one vector.
    """
    for part in equation.parts:
        if not part.together:
            continue
        letters = letters_together(equation, part, case)
        yield from find_point(part.together, letters, case, equation.level, findings)
        fact = findings.facts[key_of(part.together, equation.level)]
        if fact.by_components and all(map(double, fact.value)):
            findings.sized.add(fact.symbol)
            yield Display((size_line(fact, equation.level, case),))


def size_line(fact: Fact, level: Level, case: Case) -> str:
    """The magnitude of a vector known by its components, and its direction."""
    x, y = (component(fact.symbol, axis) for axis in "xy")
    numbers = "+".join(f"{bracketed(short(number))}^{{2}}" for number in fact.value)
    size = stated(length(fact.value, case.arithmetic), UNITS[level, False])
    return (
        rf"{fact.symbol} &= \sqrt{{{x}^{{2}}+{y}^{{2}}}} = \sqrt{{{numbers}}} = "
        f"{size}{way(fact.value, case)}"
    )


def contact(equation: VectorEquation, case: Case) -> Iterator[Block]:
    """Why the centre of a circle is the moving point where the circle touches a flat face."""
    for relative in equation.compositions:
        sentence = case.joint(relative.term) if relative.term else None
        if (
            sentence
            and sentence.kind == "contact"
            and relative.part == ""
            and equation.level == "velocity"
        ):
            yield Prose(
                phrase(
                    "contact_face",
                    case.language,
                    point=case.naming.point(relative.point),
                    frame=body_or_ground(relative.frame, case),
                )
            )


def same_path(equation: VectorEquation) -> bool:
    """Whether an equation only says that a guided point moves as a point of a body whose motion is
    known.
    """
    return is_whole(equation.left) and is_whole(equation.right) and len(equation.unknowns) == 1


def agreement(equation: VectorEquation, case: Case) -> Iterator[Block]:
    """The known motion of the point that both sides describe."""
    yield Prose(introduction(equation, case))
    known = next(
        side for side in (equation.left, equation.right) if not any(part.unknown for part in side)
    )
    unit = UNITS[equation.level, False]
    lines = [
        f"{letters_of(equation, part, case)} &= {equals(magnitude_formula(equation, part, case))}"
        f"{stated(length(part.value, case.arithmetic), unit)}{way(part.value, case)}"
        for part in known
    ]
    yield Display(tuple(lines))


def equals(formula: str) -> str:
    """A formula followed by an equals sign; "" where there is none."""
    return f"{formula} = " if formula else ""


def table(equation: VectorEquation, case: Case) -> TermTable:
    """The equation term by term with magnitudes and directions; terms that vanish at this instant
    are left out.
    """
    terms: list[Term] = []
    for side in (equation.left, equation.right):
        shown = [part for part in side if not vanishes(part)]
        sign = "=" if terms else ""
        if not shown:
            terms.append(Term("=" if terms else "", "0", "", ""))
        for part in shown:
            terms.append(
                Term(
                    sign,  # type: ignore[arg-type]
                    letters_of(equation, part, case, bold=True),
                    magnitude(equation, part, case),
                    direction(equation, part, case),
                )
            )
            sign = "+"
    return TermTable(tuple(terms))


def remarks(equation: VectorEquation, case: Case) -> Iterator[Block]:
    """What a composition's vectors consist of, which parts vanish, and which points primed letters
    denote.
    """
    listed = list(meanings(equation, case))
    if listed:
        yield Prose(
            phrase("here", case.language, equations=phrase("comma", case.language).join(listed))
        )
    shifted = {
        part.term.rate.removeprefix("omega ")
        for part in equation.parts
        if part.coincident and part.term
    } & translating(case.motion.frames.mechanism)
    for name in sorted(shifted):
        yield Prose(
            phrase(f"shifted_{equation.level}", case.language, frame=case.naming.body(name))
        )
    zeros = [
        f"${letters_of(equation, part, case)}=0$"
        for part in equation.parts
        if vanishes(part) and not (shifted and (part.coincident or part.role == "coriolis"))
    ]
    if zeros:
        joined = phrase("comma", case.language).join(dict.fromkeys(zeros))
        yield Prose(phrase("zero_parts", case.language, zeros=joined))
    marked = next((part for part in equation.parts if part.coincident), None)
    if marked is not None and marked.term is not None and not shifted:
        yield Prose(
            phrase(
                "coincident",
                case.language,
                mark=mark_of(equation, marked, case),
                point=case.naming.point(marked.point),
                frame=case.naming.body(marked.term.rate.removeprefix("omega ")),
            )
        )


def mark_of(equation: VectorEquation, part: Part, case: Case) -> str:
    """The primed letter of a coincident point."""
    base = case.naming.point(part.base)
    return subscript(equation, part, case).removesuffix(base)
