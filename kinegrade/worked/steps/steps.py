"""The steps of the plan in words and equations, for velocities and for accelerations."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from functools import reduce
from typing import assert_never

from kinegrade.language.message import Message, Text
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
from kinegrade.worked.document import Block, Display, Term, TermTable
from kinegrade.worked.formulas.numbers import (
    double,
    length,
    write_bracketed,
    write_number,
    write_short,
)
from kinegrade.worked.steps.deductions import UNITS, Stage, explain_deduction
from kinegrade.worked.steps.findings import Fact, Findings, make_key, write_point_symbol
from kinegrade.worked.steps.kinds import find_translating
from kinegrade.worked.steps.points import find_point, write_way
from kinegrade.worked.steps.projection import find_deductions
from kinegrade.worked.steps.scalars import explain_scalar_step, state_relation
from kinegrade.worked.steps.summands import write_component
from kinegrade.worked.steps.titles import describe_meanings, introduce_equation, select_scalars
from kinegrade.worked.steps.vectors import (
    describe_direction,
    describe_magnitude,
    vanishes,
    write_letters,
    write_magnitude_formula,
    write_subscript,
)
from kinegrade.worked.words.solution_case import Case


def find_stage(step: Step, case: Case, level: Level, known: Collection[Rate]) -> Stage:
    """The vector equations of a step, at the stage where the rates `known` are known."""
    relations = (case.motion.frames.relations[index] for index in step.relations)
    equations = [
        write_vector_equation(relation, case.motion, known, level)
        for relation in relations
        if relation.is_vector
    ]
    return Stage(number_together(equations), level, case)


def explain_step(step: Step, stage: Stage, findings: Findings) -> Iterator[Block]:
    """A step: its equations, the projections, their results."""
    case, scalars = stage.case, select_scalars(step, stage.case)
    if not stage.equations and len(scalars) == 1 and len(step.unknowns) == 1:
        yield from explain_scalar_step(scalars[0], step.unknowns[0], case, stage.level)
        return
    if len(stage.equations) == 1 and _same_path(stage.equations[0]):
        yield from _explain_agreement(stage.equations[0], case)
        return
    for equation in stage.equations:
        yield from _explain_earlier_vectors(equation, case, findings)
    for equation in stage.equations:
        yield from _explain_contact(equation, case)
        yield case.say(introduce_equation(equation, case))
        yield make_term_table(equation, case)
        yield from explain_remarks(equation, case)
    for relation in scalars:
        statement = state_relation(relation, case, stage.level)
        yield case.say(statement.reason)
        yield Display((statement.line,))
    solved: set[Rate] = set()
    for deduction in find_deductions(stage.equations, scalars, step.unknowns):
        yield from explain_deduction(stage, deduction, solved)
        solved |= set(deduction.unknowns)


def _write_joint_symbol(equation: VectorEquation, part: Part, case: Case) -> str:
    """The symbol of several known terms as one vector: of the transport motion, or of the point
    itself.
    """
    match part.role:
        case "transport":
            return write_letters(equation, part, case)
        case "absolute" | "relative" | "rotation" | "coriolis":
            return write_point_symbol(part.point, equation.level, case)
        case _:
            assert_never(part.role)


def _explain_earlier_vectors(
    equation: VectorEquation, case: Case, findings: Findings
) -> Iterator[Block]:
    """How the vectors are found that the equation takes as known and that no earlier step has given
    as one vector.
    """
    for part in equation.parts:
        if not part.together:
            continue
        letters = _write_joint_symbol(equation, part, case)
        yield from find_point(part.together, letters, case, equation.level, findings)
        fact = findings.facts[make_key(part.together, equation.level)]
        if fact.by_components and all(map(double, fact.value)):
            findings.sized.add(fact.symbol)
            yield Display((_write_size_line(fact, equation.level, case),))


def _write_size_line(fact: Fact, level: Level, case: Case) -> str:
    """The magnitude of a vector known by its components, and its direction."""
    x, y = (write_component(fact.symbol, axis) for axis in "xy")
    numbers = "+".join(f"{write_bracketed(write_short(number))}^{{2}}" for number in fact.value)
    size = write_number(length(fact.value, case.arithmetic), UNITS[level, False])
    return (
        rf"{fact.symbol} &= \sqrt{{{x}^{{2}}+{y}^{{2}}}} = \sqrt{{{numbers}}} = "
        f"{size}{write_way(fact.value, case)}"
    )


def _explain_contact(equation: VectorEquation, case: Case) -> Iterator[Block]:
    """Why the centre of a circle is the moving point where the circle touches a flat face."""
    for relative in equation.compositions:
        sentence = case.joint(relative.term) if relative.term else None
        if (
            sentence
            and sentence.kind == "contact"
            and relative.part == ""
            and equation.level == "velocity"
        ):
            yield case.say(
                Message(
                    "solution.contact-face",
                    point=case.naming.point(relative.point),
                    frame=case.naming.body(relative.frame),
                )
            )


def _same_path(equation: VectorEquation) -> bool:
    """Whether an equation only says that a guided point moves as a point of a body whose motion is
    known.
    """
    return is_whole(equation.left) and is_whole(equation.right) and len(equation.unknowns) == 1


def _explain_agreement(equation: VectorEquation, case: Case) -> Iterator[Block]:
    """The known motion of the point that both sides describe."""
    yield case.say(introduce_equation(equation, case))
    known = next(
        side for side in (equation.left, equation.right) if not any(part.unknown for part in side)
    )
    unit = UNITS[equation.level, False]
    lines = [
        f"{write_letters(equation, part, case)} &= "
        f"{_write_equals(write_magnitude_formula(equation, part, case))}"
        f"{write_number(length(part.value, case.arithmetic), unit)}{write_way(part.value, case)}"
        for part in known
    ]
    yield Display(tuple(lines))


def _write_equals(formula: str) -> str:
    """A formula followed by an equals sign; "" where there is none."""
    return f"{formula} = " if formula else ""


def make_term_table(equation: VectorEquation, case: Case) -> TermTable:
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
                    write_letters(equation, part, case, bold=True),
                    describe_magnitude(equation, part, case),
                    describe_direction(equation, part, case),
                )
            )
            sign = "+"
    return TermTable(tuple(terms))


def explain_remarks(equation: VectorEquation, case: Case) -> Iterator[Block]:
    """What a composition's vectors consist of, which parts vanish, and which points primed letters
    denote.
    """
    listed = list(describe_meanings(equation, case))
    if listed:
        yield case.say(Message("solution.here", equations=_list_equations(listed)))
    shifted = {
        part.term.rate.body for part in equation.parts if part.coincident and part.term
    } & find_translating(case.motion.frames.mechanism)
    for name in sorted(shifted):
        yield case.say(Message(f"solution.shifted-{equation.level}", frame=case.naming.body(name)))
    zeros = [
        f"${write_letters(equation, part, case)}=0$"
        for part in equation.parts
        if vanishes(part) and not (shifted and (part.coincident or part.role == "coriolis"))
    ]
    if zeros:
        listed_zeros = _list_equations(dict.fromkeys(zeros))
        yield case.say(Message("solution.zero-parts", zeros=listed_zeros))
    marked = next((part for part in equation.parts if part.coincident), None)
    if marked is not None and marked.term is not None and not shifted:
        yield case.say(
            Message(
                "solution.coincident",
                mark=_find_mark(equation, marked, case),
                point=case.naming.point(marked.point),
                frame=case.naming.body(marked.term.rate.body),
            )
        )


def _list_equations(equations: Iterable[Text]) -> Text:
    """Equations in a sentence, one after another."""
    return reduce(
        lambda first, following: Message("solution.equation-list", first=first, next=following),
        equations,
    )


def _find_mark(equation: VectorEquation, part: Part, case: Case) -> str:
    """The primed letter of a coincident point."""
    base = case.naming.point(part.base)
    return write_subscript(equation, part, case).removesuffix(base)
