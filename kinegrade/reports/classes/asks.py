"""The lines of the class report on the asks: how hard each was, whether it separates good papers
from weak ones, and how it was answered.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from kinegrade.grading.wording import Wording
from kinegrade.language.catalogue import Catalogue
from kinegrade.language.message import Listing, Message, list_plainly, list_statements
from kinegrade.press.class_sheet import AskLine, Bar, StackedBar
from kinegrade.reports.classes.figures import write_decimal, write_plain, write_share
from kinegrade.reports.classes.item_statistics import find_discriminations, find_facilities
from kinegrade.reports.classes.tally import ClassTally
from kinegrade.reports.classes.words import (
    explain_verdict,
    find_symbol,
    name_question,
    name_verdict,
)

_HARD, _EASY, _FLAT = 0.3, 0.9, 0.1
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


def list_asks(counts: ClassTally, wording: Wording, catalogue: Catalogue) -> Iterator[AskLine]:
    """One line for each ask."""
    facilities = find_facilities(counts.points, counts.out_of)
    discriminations = find_discriminations(counts.points)
    before = ""
    for place, column in enumerate(counts.columns):
        facility, discrimination = facilities[place], discriminations[place]
        question, share = column.split(".")[0], write_share(facility, catalogue)
        verdicts = _write_verdicts(counts.verdicts[column], catalogue)
        yield AskLine(
            name_question(question, catalogue),
            wording.titles.get(question, ""),
            question != before,
            find_symbol(column, wording),
            wording.meanings.get(column, ""),
            write_plain(float(counts.out_of[place]), catalogue),
            share,
            Bar(facility or 0.0, "column", share, _WIDTH, track=True),
            write_decimal(discrimination, catalogue),
            StackedBar(_share_out(counts.verdicts[column]), verdicts),
            verdicts,
            catalogue.write(_note(facility, discrimination, len(counts.answered))),
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


def _note(facility: float | None, discrimination: float | None, students: int) -> Listing:
    """What is worth a look; a correlation within two standard errors of zero counts as none."""
    notes: list[Message] = []
    if facility is not None and facility < _HARD:
        notes.append(Message("report.hard"))
    if facility is not None and facility > _EASY:
        notes.append(Message("report.easy"))
    if discrimination is not None and discrimination < _FLAT:
        negative = discrimination < -2 / students**0.5
        notes.append(Message("report.negative" if negative else "report.flat"))
    return list_statements(notes)
