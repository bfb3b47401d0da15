"""The lines of the class report on the asks: how hard each was, whether it separates good papers
from weak ones, and how it was answered.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Container, Iterator

import numpy as np

from kinegrade.grading.verdict_names import name_verdict
from kinegrade.grading.wording import Wording
from kinegrade.language.catalogue import Catalogue
from kinegrade.language.message import Listing, Message, list_plainly, list_statements
from kinegrade.press.class_charts import Bar, StackedBar
from kinegrade.press.class_sheet import AskLine
from kinegrade.reports.classes.figures import write_decimal, write_plain, write_share
from kinegrade.reports.classes.item_statistics import (
    find_discriminations,
    find_facilities,
    find_interval,
)
from kinegrade.reports.classes.tally import ClassTally
from kinegrade.reports.classes.words import explain_verdict, find_symbol, name_question

_HARD, _EASY, _FLAT, _USUAL = 0.3, 0.9, 0.1, 0.3
_WIDTH = 70.0  # pixels of the bar of a facility
_VERDICTS = (
    "right",
    "accepted",
    "follow-through",
    "void",
    "mistake",
    "wrong",
    "wrong unit",
    "unreadable",
    "blank",
    "another paper",
)  # in the order of the segments of a bar
_UNKNOWN = "shade5"
_SHADES = {verdict: f"shade{place}" for place, verdict in enumerate(_VERDICTS)}


def list_asks(
    counts: ClassTally, bonus: Container[str], wording: Wording, catalogue: Catalogue
) -> Iterator[AskLine]:
    """One line for each ask; the points of questions that are a `bonus` have a plus sign."""
    facilities = find_facilities(counts.points, counts.out_of)
    discriminations = find_discriminations(counts.points, counts.out_of)
    before, students = "", len(counts.answered)
    for place, column in enumerate(counts.columns):
        facility, discrimination = facilities[place], discriminations[place]
        given = int((~np.isnan(counts.points[:, place])).sum())
        question, share = column.split(".")[0], write_share(facility, catalogue)
        sign = "+" if question in bonus else ""
        verdicts = _write_verdicts(counts.verdicts[column], catalogue)
        yield AskLine(
            name_question(question, catalogue),
            wording.titles.get(question, ""),
            question != before,
            find_symbol(column, wording),
            wording.meanings.get(column, ""),
            sign + write_plain(float(counts.out_of[place]), catalogue),
            share,
            Bar(facility or 0.0, "column", share, _WIDTH, track=True),
            write_decimal(discrimination, catalogue),
            _write_interval(discrimination, given, catalogue),
            StackedBar(_share_out(counts.verdicts[column]), verdicts),
            verdicts,
            catalogue.write(_note(facility, discrimination, given, students)),
        )
        before = question


def list_legend(counts: ClassTally, catalogue: Catalogue) -> Iterator[tuple[str, str]]:
    """The shades of the verdicts that occur, and their names."""
    for verdict, _ in _in_order(sum(counts.verdicts.values(), Counter[str]())):
        yield _SHADES.get(verdict, _UNKNOWN), catalogue.write(explain_verdict(verdict))


def _share_out(verdicts: Counter[str]) -> tuple[tuple[str, float], ...]:
    """All answers to an ask, by shade."""
    whole = verdicts.total()
    counted = _in_order(verdicts)
    return tuple((_SHADES.get(verdict, _UNKNOWN), count / whole) for verdict, count in counted)


def _write_verdicts(verdicts: Counter[str], catalogue: Catalogue) -> str:
    """How often each verdict was given."""
    return catalogue.write(
        list_plainly(
            Message("report.verdict-count", verdict=name_verdict(verdict), number=count)
            for verdict, count in _in_order(verdicts)
        )
    )


def _in_order(verdicts: Counter[str]) -> list[tuple[str, int]]:
    """Verdicts with their counts, right answers first, unknown verdicts last."""
    known = [verdict for verdict in _VERDICTS if verdicts[verdict]]
    return [
        (verdict, verdicts[verdict])
        for verdict in (*known, *sorted(set(verdicts) - set(_VERDICTS)))
    ]


def _write_interval(discrimination: float | None, students: int, catalogue: Catalogue) -> str:
    """Where the discrimination lies with 95 % confidence; "" where that is not known."""
    interval = None if discrimination is None else find_interval(discrimination, students)
    if interval is None:
        return ""
    low, high = (write_decimal(end, catalogue) for end in interval)
    return catalogue.write(Message("report.interval", low=low, high=high))


def _note(
    facility: float | None, discrimination: float | None, given: int, students: int
) -> Listing:
    """What is worth a look; of an ask that not all students had, how many had it."""
    notes = [] if given == students else [Message("report.given-to", count=given)]
    if facility is not None and facility < _HARD:
        notes.append(Message("report.hard"))
    if facility is not None and facility > _EASY:
        notes.append(Message("report.easy"))
    if discrimination is not None and discrimination < _FLAT:
        notes.append(_judge_low(discrimination, given))
    return list_statements(notes)


def _judge_low(discrimination: float, students: int) -> Message:
    """What a low discrimination means, as far as so many students tell."""
    _, high = find_interval(discrimination, students) or (-1.0, 1.0)
    if high < 0:
        return Message("report.negative")
    return Message("report.flat" if high < _USUAL else "report.low-by-chance")
