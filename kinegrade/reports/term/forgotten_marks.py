"""Marks whose people were forgotten, beside others: nobody of theirs can be found there."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

from kinegrade.language.message import Fault, Message
from kinegrade.marks_folder.rows import ClassTotals

_FORGOTTEN = re.compile(r"p[0-9]+")  # as kinegrade forget names people


def find_forgotten_marks(exams: Mapping[str, ClassTotals]) -> Iterator[Fault]:
    """A complaint for each exam in which all have such names, where there are several exams."""
    for exam, totals in exams.items():
        forgotten = all(
            _FORGOTTEN.fullmatch(each.student) and not each.name for each in totals.students
        )
        if forgotten and totals.students and len(exams) > 1:
            what = Message("term.forgotten-marks", first=totals.students[0].student)
            yield Fault(exam, what, do=Message("term.leave-out-forgotten"))
