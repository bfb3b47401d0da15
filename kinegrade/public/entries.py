"""`kinegrade.compare_entries`: the answers of a class, typed twice, compared cell by cell."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from os import PathLike
from pathlib import Path

from kinegrade.errors import TableError
from kinegrade.exam.folder.asks import Ask
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.folder.sitting import Sitting
from kinegrade.exam.keyed_exam import Examinee, KeyedExam
from kinegrade.exam.roster.known_columns import list_key_columns
from kinegrade.files.answer_file import AnswerFile
from kinegrade.files.cell_text import make_header_key, trim
from kinegrade.files.tables import Table, drop_headers
from kinegrade.grading.sheets.part import read_part
from kinegrade.language.message import Fault, Message
from kinegrade.lms.responses.answer_table import DETECTED
from kinegrade.lms.responses.below import long
from kinegrade.lms.responses.class_files import read_class, refuse_one_file_twice
from kinegrade.lms.responses.sheet import part_times, read_answer_file
from kinegrade.public.opened import expect_opened
from kinegrade.reports.double_entry import DoubleEntry, compare_parts
from kinegrade.reports.entry_names import NamedEntries, find_unlike_entries

_ASKED = re.compile(r"(?P<question>q[0-9]+[a-z]?)\.(?P<ask>\w+)(?:\s*[(\[](?P<unit>.*)[)\]])?")

_NO_UNIT = "1"


def compare_entries(
    first: str | PathLike[str], second: str | PathLike[str], exam: ExamFolder | None = None
) -> DoubleEntry:
    """What two files of answers to the same exam say differently, as `kinegrade compare-entries`
    finds it: numbers that are equal as typed values are equal.

    With the exam, files may come from other systems, name asks as people do, and identify students
    by the codes of their papers. Raises KinegradeError.

    >>> compare_entries("answers.csv", "answers.csv")
    Traceback (most recent call last):
    kinegrade.errors.TableError: answers.csv: is given twice - ...
    >>> from pathlib import Path
    >>> name = Path("again.csv").write_text(Path("answers.csv").read_text())
    >>> compare_entries("answers.csv", "again.csv").differences
    ()
    """
    expect_opened(exam=exam)
    paths = Path(first), Path(second)
    refuse_one_file_twice(paths)
    if exam is not None:
        files: Sequence[AnswerFile] = read_class(paths, exam, DETECTED).files
        sitting: Sitting = exam
    else:
        files = [part_times(_read_sheet(path)) for path in paths]
        sitting = _stand_in(files)
    one, other = (read_part(each, sitting) for each in files)
    titles = [ask.column if exam else _name_column(ask) for ask in sitting.asks]
    named = (NamedEntries(each.table, part) for each, part in zip(files, (one, other), strict=True))
    compared = compare_parts(one, other, sitting, titles)
    return replace(compared, complaints=(*compared.complaints, *find_unlike_entries(*named)))


def _read_sheet(path: Path) -> Table:
    """An answer sheet as it is. Raises TableError for answers that need the exam to be read."""
    table = read_answer_file(path)
    if long.recognises(table.header):
        what, do = Message("responses.long-alone"), Message("responses.name-the-exam")
        raise TableError(Fault(table.file, what, do=do))
    return table


def _stand_in(files: Sequence[AnswerFile]) -> KeyedExam:
    """An exam of all students and asks that answer sheets have."""
    headers = dict.fromkeys(trim(cell) for each in files for cell in each.table.header)
    matches = (match for cell in headers if (match := _ASKED.fullmatch(cell)))
    found = sorted(matches, key=lambda match: bool(match["unit"]))  # one that states it counts
    asks = {
        (each["question"], each["ask"]): Ask(
            each["question"], each["ask"], each["unit"] or _NO_UNIT, Fraction(0)
        )
        for each in found
    }
    students = dict.fromkeys(name for each in files for name in _list_students(each.table))
    return KeyedExam(tuple(asks.values()), tuple(Examinee(name, "", {}) for name in students))


def _name_column(ask: Ask) -> str:
    """The header of an ask, with the unit that the files state, which nothing else tells."""
    return ask.column if ask.unit == _NO_UNIT else f"{ask.column} ({ask.unit})"


def _list_students(table: Table) -> list[str]:
    """The ids, or the codes, in the column that has them; none where there is no such column."""
    header = [make_header_key(cell) for cell in table.header]
    place = next((header.index(name) for name in list_key_columns() if name in header), None)
    if place is None:
        return []
    return [name for row in drop_headers(table) if (name := trim(row.cell(place)))]
