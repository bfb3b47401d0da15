"""moodle.csv, which `grade` writes into every folder of marks: Moodle's new file as it is by
default.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction
from pathlib import Path

from kinegrade.language.message import Message
from kinegrade.lms.grades.dialect import ExportOptions
from kinegrade.lms.grades.from_scratch import new_file
from kinegrade.lms.grades.grades import read_grades
from kinegrade.lms.grades.maximum import find_most
from kinegrade.lms.grades.systems.moodle import MOODLE
from kinegrade.marks_folder.folder import MarksFolder
from kinegrade.numbers.amounts import write_amount

FILE = "moodle.csv"


def export(marks: MarksFolder) -> str:
    """The text of moodle.csv; raises TableError.

    Feedback is a line such as "1: 4/7; 2: 3/3", by the question numbers on the student's paper.
    Names stay neutralised against spreadsheets. Where students could get unlike points, totals are
    scaled to the most, as an item has one maximum; `describe_scaled` says so.
    """
    maximum = find_most(each.out_of for each in marks.totals.students)
    return new_file(MOODLE, read_grades(marks), ExportOptions(maximum=maximum)).text


def describe_scaled(folder: Path, maxima: Iterable[Fraction]) -> Iterator[Message]:
    """That the totals of moodle.csv are scaled, if they are: the students' `maxima` differ."""
    most = find_most(maxima)
    if most is not None:
        yield Message("grades.scaled-to-most", file=str(folder / FILE), maximum=write_amount(most))
