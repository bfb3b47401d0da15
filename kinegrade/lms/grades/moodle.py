"""moodle.csv, which `grade` writes into every folder of marks: Moodle's new file as it is by
default.
"""

from __future__ import annotations

from kinegrade.lms.grades.dialect import ExportOptions
from kinegrade.lms.grades.from_scratch import new_file
from kinegrade.lms.grades.grades import read_grades
from kinegrade.lms.grades.systems.moodle import MOODLE
from kinegrade.marks_folder.folder import MarksFolder


def export(marks: MarksFolder) -> str:
    """The text of moodle.csv; raises TableError.

    Feedback is a line such as "1: 4/7; 2: 3/3", by the question numbers on the student's paper.
    Names stay neutralised against spreadsheets.
    """
    return new_file(MOODLE, read_grades(marks), ExportOptions()).text
