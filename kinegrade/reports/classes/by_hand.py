"""The lines of the class report on marks by hand: what was marked, how often, and what a hand and
the machine gave there.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Sequence
from fractions import Fraction
from statistics import fmean

from kinegrade.grading.wording import Wording
from kinegrade.language.catalogue import Catalogue
from kinegrade.marks_folder.folder import MarksFolder
from kinegrade.marks_folder.hand_marks import EXTRA, HandMark, list_hand_marks
from kinegrade.press.class_sheet import HandLine, Symbol
from kinegrade.question_numbers import sort_as_in_bank
from kinegrade.reports.classes.figures import write_plain
from kinegrade.reports.classes.words import find_symbol, name_question

_NOBODY = "–"


def list_hand_lines(
    marks: MarksFolder, wording: Wording, catalogue: Catalogue
) -> Iterator[HandLine]:
    """A line for each question and ask that has marks by hand, in the bank's order."""
    found: dict[str, dict[str, list[HandMark]]] = defaultdict(dict)
    for mark in list_hand_marks(marks.by_hand):
        found[mark.question].setdefault(mark.column, []).append(mark)
    for question in sort_as_in_bank(found):
        for column, given in found[question].items():
            yield _make_line(column, given, wording, catalogue)


def _make_line(
    column: str, given: Sequence[HandMark], wording: Wording, catalogue: Catalogue
) -> HandLine:
    first = given[0]
    extra = first.question == EXTRA
    machine = [mark.machine for mark in given if mark.machine is not None]
    return HandLine(
        catalogue.text("report.extra") if extra else name_question(first.question, catalogue),
        wording.titles.get(first.question, ""),
        find_symbol(column, wording) if first.ask else Symbol(None, ""),
        len(given),
        _write_mean([mark.points for mark in given], catalogue),
        _write_mean(machine, catalogue) if machine else _NOBODY,
        _NOBODY if first.out_of is None else write_plain(float(first.out_of), catalogue),
    )


def _write_mean(points: Sequence[Fraction], catalogue: Catalogue) -> str:
    return write_plain(round(fmean(points), 2), catalogue)
