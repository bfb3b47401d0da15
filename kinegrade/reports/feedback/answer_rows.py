"""A question on a feedback sheet: its numbers as they were printed, and a row for each answer."""

from __future__ import annotations

from collections.abc import Iterator
from math import isnan, nan

from kinegrade.grading.wording import Wording
from kinegrade.language.catalogue import Catalogue
from kinegrade.language.decimal_mark import write_decimals_of_math
from kinegrade.language.message import Message, Text
from kinegrade.marks_folder.rows import MarkedAnswer
from kinegrade.press.sheet import FeedbackRow
from kinegrade.reports.feedback.points import mark_decimals, write_share
from kinegrade.reports.feedback.remarks import make_remark, name_verdict
from kinegrade.reports.feedback.right_answers import (
    describe_allowed,
    write_closed_form,
    write_decimal,
    write_with_unit,
)
from kinegrade.reports.paper_record import PaperRecord

_LONGEST_TYPED = 80  # characters: the rest of a longer cell adds nothing
_GIVEN_DIGITS = 6
_FULL, _PART, _NOTHING, _UNDECIDED = "✓", "(✓)", "✗", "–"  # told apart without colour


def list_givens(
    question: str, paper: PaperRecord, wording: Wording, catalogue: Catalogue
) -> Iterator[str]:
    """The numbers of a question as they were printed, each as prose; none where its asks were put
    with different ones.
    """
    for (asked, name), unit in wording.givens.items():
        number = paper.parameters.get((asked, name), nan)
        if asked == question and not isnan(number):
            shown = f"{number:.{_GIVEN_DIGITS}g}"
            relation = "=" if float(shown) == number else r"\approx"
            symbol = wording.parameters.get((asked, name), name)
            formula = _mark_formula(f"{symbol} {relation} {shown}", catalogue)
            yield write_with_unit(f"${formula}$", unit)


def make_feedback_row(
    answer: MarkedAnswer, paper: PaperRecord, wording: Wording, catalogue: Catalogue
) -> FeedbackRow:
    """The row for one answer."""
    right = paper.answers.get(answer.column)
    remark = make_remark(answer, paper, wording)
    prose = catalogue.write(remark.prose)
    return FeedbackRow(
        wording.symbols.get(answer.column, rf"\mathrm{{{answer.ask.replace('_', ' ')}}}"),
        wording.meanings.get(answer.column, ""),
        wording.conventions.get(answer.column, ""),
        _cut(answer.typed),
        catalogue.write(_describe_reading(answer, catalogue)),
        _mark_formula(write_closed_form(right), catalogue) if right else "",
        mark_decimals(write_decimal(right), catalogue) if right else "",
        mark_decimals(catalogue.write(describe_allowed(right)), catalogue) if right else "",
        _choose_mark(answer),
        catalogue.write(name_verdict(answer.judged)),
        write_share(answer.points, answer.out_of, catalogue),
        prose,
        remark.guess,
        catalogue.write(remark.note),
    )


def _cut(typed: str) -> str:
    return typed if len(typed) <= _LONGEST_TYPED else f"{typed[:_LONGEST_TYPED]}…"


def _mark_formula(latex: str, catalogue: Catalogue) -> str:
    """A formula with the decimal mark of the language."""
    return write_decimals_of_math(latex, catalogue.language)


def _choose_mark(answer: MarkedAnswer) -> str:
    """The sign beside the verdict: whether all points were given, some, or none."""
    if answer.judged in ("blank", "void"):
        return _UNDECIDED
    if answer.points >= answer.out_of:
        return _FULL
    return _PART if answer.points > 0 else _NOTHING


def _describe_reading(answer: MarkedAnswer, catalogue: Catalogue) -> Text:
    if answer.read_as in ("", answer.typed.strip()):
        return ""
    number = write_with_unit(answer.read_as, answer.unit).replace("-", "−")
    return Message("feedback.read-as", number=mark_decimals(number, catalogue))
