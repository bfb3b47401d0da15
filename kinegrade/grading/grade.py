"""From an exam folder and an answer sheet to a folder of marks: the whole of `kinegrade grade`."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from types import MappingProxyType

from kinegrade.files import output_folder
from kinegrade.grading.decimal_style import Mark as DecimalMark
from kinegrade.grading.exam_folder import read_exam
from kinegrade.grading.marks import Marks, mark
from kinegrade.grading.report import write_report
from kinegrade.grading.sheet import read_sheet
from kinegrade.tables import read_table

MARKER = "complaints.csv"
FILES = ("marks.csv", "grades.csv", "complaints.csv")
Export = Callable[[Path], str]  # a folder with the three files -> the text of one more
_NO_EXPORTS: Mapping[str, Export] = MappingProxyType({})


def grade(
    exam: Path,
    answers: Path,
    output: Path,
    *,
    force: bool = False,
    exports: Mapping[str, Export] = _NO_EXPORTS,
    decimal: DecimalMark | None = None,
) -> Marks:
    """Writes the folder `output`, whole or not at all, and gives the marks with their complaints.

    `exports` names the files for other systems that go into the folder too, such as
    `{"moodle.csv": kinegrade.lms.moodle.export}`. `decimal` declares the decimal mark of the sheet, for 1,234 and
    1.234. Same input, same bytes.
    Raises ExamError, TableError, OutputError.
    """
    with output_folder(output, marker=MARKER, contents=(*FILES, *exports), force=force) as folder:
        known = read_exam(exam)
        marks = mark(known, read_sheet(read_table(answers), known), decimal)
        write_report(folder, marks)
        for name, export in exports.items():
            (folder / name).write_text(export(folder), encoding="utf-8", newline="")
    return marks
