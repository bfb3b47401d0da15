"""The key of a paper as the record that an exam folder keeps of it, by which marks are decided."""

from __future__ import annotations

from collections.abc import Mapping
from decimal import Decimal
from types import MappingProxyType
from typing import TYPE_CHECKING

from kinegrade.exam.folder.key.lines import (
    KeyLine,
    KeyQuestion,
    StatedAnswer,
    StatedNumber,
    StatedTolerance,
)
from kinegrade.exam.folder.writing import make_decimal
from kinegrade.exam.setting.setting import SetAsk, SetPaper, SetQuestion
from kinegrade.numbers.tolerance import Tolerance
from kinegrade.problem.quantity import Quantity

if TYPE_CHECKING:
    from kinegrade.exam.setting.key_mistakes import Mistaken

_NOTHING_KNOWN: Mapping[str, Mistaken] = MappingProxyType({})


def make_key_line(
    paper: SetPaper, mistakes: Mapping[str, Mistaken] = _NOTHING_KNOWN, *, ordered: bool = False
) -> KeyLine:
    """The key of a paper; its questions are in the bank's order, and where papers are `ordered`
    each in its own way it states their order on this one.

    `mistakes` holds for each question what known mistakes lead to.
    """
    return KeyLine(
        student=paper.student.student,
        paper=paper.code,
        version=paper.version,
        place=paper.place,
        printed=_list_identifiers(paper.printed) if ordered else (),
        questions=tuple(
            make_key_question(question, mistakes.get(question.question.identifier, {}))
            for question in paper.questions
        ),
    )


def make_key_question(question: SetQuestion, mistakes: Mistaken) -> KeyQuestion:
    """One question: what was drawn, what is right within which tolerance, what mistakes lead to."""
    drawn = question.drawn
    return KeyQuestion(
        question=question.question.identifier,
        template=question.question.template.name,
        parameters={
            name: _make_stated_number(quantity)
            for name, quantity in drawn.solution.parameters.items()
        },
        drawn=dict(drawn.values),
        asks={
            entry.ask.name: make_stated_answer(entry, mistakes.get(entry.ask.name, {}))
            for entry in question.asks
        },
    )


def make_stated_answer(entry: SetAsk, mistakes: Mapping[str, str]) -> StatedAnswer:
    """What is right for an ask; `decimal` has 40 correct digits, by which marks are decided."""
    answer = entry.answer
    return StatedAnswer(
        exact=answer.exact,
        value=None if answer.at_infinity else _round_to_double(answer),
        unit=answer.unit,
        decimal=answer.certified,
        tolerance=_make_stated_tolerance(entry.tolerance),
        period=Decimal(answer.full_turn) if entry.cyclic else None,
        points=make_decimal(entry.ask.points),
        mistakes=dict(mistakes),
    )


def _list_identifiers(questions: tuple[SetQuestion, ...]) -> tuple[str, ...]:
    return tuple(question.question.identifier for question in questions)


def _make_stated_number(quantity: Quantity) -> StatedNumber:
    return StatedNumber(quantity.exact, _round_to_double(quantity), quantity.unit)


def _round_to_double(quantity: Quantity) -> Decimal:
    """The nearest double, in as many digits as distinguish it from its neighbours."""
    return Decimal(repr(quantity.value))


def _make_stated_tolerance(tolerance: Tolerance) -> StatedTolerance:
    return StatedTolerance(
        make_decimal(tolerance.relative), make_decimal(tolerance.absolute), tolerance.figures
    )
