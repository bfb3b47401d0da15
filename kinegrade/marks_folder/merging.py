"""Marks folders put together: those of an exam, and of make-up exams of a few of its students.

Who handed in to one alone has the marks of that one. The first folder is that of the exam that
feedback and explanations go by; whose marks come from another one stands in merged.csv.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import permutations
from pathlib import Path
from typing import Literal, assert_never

from kinegrade.errors import TableError
from kinegrade.files.csv_writing import neutralise, write_csv, write_for_people
from kinegrade.language.message import Fault, Message, Quoted, list_statements
from kinegrade.marks_folder.cells import read_records_if_any, read_whole
from kinegrade.marks_folder.folder import MarksFolder
from kinegrade.marks_folder.hand_marks import EXTRA
from kinegrade.marks_folder.layout import (
    ANSWERS,
    COMPLAINTS,
    CORRECTIONS,
    EXAM,
    GRADES,
    KEPT,
    MERGED,
    POLICY,
    PRINTED,
    QUESTIONS_BETWEEN,
    SCALE,
    TABLES,
    WHERE_NEEDED,
    TableFile,
    make_grades_header,
)
from kinegrade.marks_folder.open_questions import describe_unmarked
from kinegrade.marks_folder.rows import StudentTotal
from kinegrade.numbers.amounts import write_amount

Preference = Literal["first", "last", "better"]
_MADE_ANEW = (GRADES, PRINTED, MERGED)
_OF_PEOPLE = (COMPLAINTS, KEPT)
_AGAIN = Message("exam.mark-again")
_OF_THE_FIRST = (SCALE, CORRECTIONS, EXAM)


@dataclass(frozen=True)
class Merging:
    """The folders in their order, and which of several marks of one student stand; None where that
    is refused.
    """

    folders: Sequence[MarksFolder]
    preference: Preference | None = None

    @cached_property
    def chosen(self) -> Mapping[str, MarksFolder]:
        """Whose marks are taken from which folder, in the order of the folders. Raises TableError
        naming all who handed in to several.
        """
        found: dict[str, MarksFolder] = {}
        faults = []
        for student in dict.fromkeys(self._list_students()):
            having = [each for each in self.folders if student in each.totals.by_student]
            written = [each for each in having if _is_written(each.totals.by_student[student])]
            if len(written) > 1 and self.preference is None:
                faults.append(_explain_several(student, written))
            found[student] = self._prefer(student, written or having[:1])
        if faults:
            raise TableError(*faults)
        return found

    @cached_property
    def questions(self) -> tuple[str, ...]:
        """The questions of all folders, and EXTRA where anybody's marks that stand have it."""
        listed = dict.fromkeys(name for each in self.folders for name in each.totals.questions)
        stands = any(
            EXTRA in folder.by_hand.get(student, {}) for student, folder in self.chosen.items()
        )
        return tuple(name for name in listed if stands or name != EXTRA)

    def write(self, target: Path) -> None:
        """Write the files of a marks folder into `target`, which exists. Raises TableError."""
        self._require_one_scale()
        self._require_one_key()
        for file in TABLES:
            rows = list(self._list_rows(file))
            if file not in _MADE_ANEW and (rows or file in (ANSWERS, COMPLAINTS)):
                write = write_for_people if file in _OF_PEOPLE else write_csv
                write(target / file.name, file.columns, rows)
        had = {name for each in self.folders for name in read_whole(each.path, GRADES).header}
        header = make_grades_header(self.questions, [each for each in WHERE_NEEDED if each in had])
        write_for_people(target / GRADES.name, header, self._list_grades(header))
        self._write_if_any(target, PRINTED, self._list_printed())
        self._write_if_any(target, MERGED, self._list_elsewhere())
        policy = self.folders[0].path / POLICY
        if policy.exists():
            (target / POLICY).write_bytes(policy.read_bytes())

    def _require_one_scale(self) -> None:
        """Raises TableError for folders whose grades are by another scale than those of the
        first.
        """
        first, *others = self.folders
        what = Message("marks.other-scale", first=str(first.path))
        differing = [each for each in others if each.scale != first.scale]
        faults = [
            missing
            for each in ([first, *differing] if differing else [])
            if each.scale is None  # without points by hand there are no grades yet
            for missing in describe_unmarked(str(each.path), each.open, each.lacking)
        ] or [Fault(str(each.path), what, do=Message("marks.same-scale")) for each in differing]
        if faults:
            raise TableError(*faults)

    def _require_one_key(self) -> None:
        """Raises TableError for markings of one exam of which some are by a key that was corrected
        after them: one student's marks would be by that of now, another's by that of before.
        """
        faults = [
            Fault(str(before.path), Message("marks.key-of-before", now=str(now.path)), do=_AGAIN)
            for before, now in permutations(self.folders, 2)
            if before.exam and before.exam == now.exam and before.corrections < now.corrections
        ]
        if faults:
            raise TableError(*faults)

    def _write_if_any(self, target: Path, file: TableFile, rows: Iterable[Sequence[str]]) -> None:
        listed = list(rows)
        if listed:
            write_csv(target / file.name, file.columns, listed)

    def maxima(self) -> Iterator[Fraction]:
        """What each student's total is out of."""
        for student, folder in self.chosen.items():
            yield folder.totals.by_student[student].out_of

    def find_different_maxima(self) -> Iterator[Fault]:
        """Folders in which there was something else to get than in the first."""
        first, *others = self.folders
        stated = {each.out_of for each in first.totals.students}
        for folder in others:
            taken = [
                each
                for student, each in folder.totals.by_student.items()
                if self.chosen[student] is folder
            ]
            maxima = {each.out_of for each in taken} - stated
            if maxima:
                what = Message(
                    "marks.other-maximum",
                    maximum=list_statements(map(write_amount, sorted(maxima))),
                    first=list_statements(map(write_amount, sorted(stated))),
                    count=sum(each.out_of in maxima for each in taken),
                )
                yield Fault(str(folder.path), what, do=Message("marks.compare-shares"))

    def _list_students(self) -> Iterator[str]:
        for folder in self.folders:
            yield from folder.totals.by_student

    def _prefer(self, student: str, having: Sequence[MarksFolder]) -> MarksFolder:
        match self.preference:
            case "first" | None:
                return having[0]
            case "last":
                return having[-1]
            case "better":
                return max(having, key=lambda each: each.totals.by_student[student].share)
            case _:
                assert_never(self.preference)

    def _list_rows(self, file: TableFile) -> Iterator[Sequence[str]]:
        """The rows of a file, of those whose marks are taken from its folder; of a file without
        students all different ones.
        """
        if "student" not in file.columns:
            folders = self.folders[:1] if file in _OF_THE_FIRST else self.folders
            read = (read_records_if_any(folder.path, file) for folder in folders)
            yield from dict.fromkeys(cells for records in read for _, cells in records)
            return
        place = file.columns.index("student")
        for folder in self.folders:
            for _, cells in read_records_if_any(folder.path, file):
                if self.chosen.get(cells[place]) is folder:
                    yield cells

    def _list_grades(self, header: Sequence[str]) -> Iterator[Sequence[str]]:
        """The rows of grades.csv, in the order of marks.csv."""
        nothing = {EXTRA: "0"}  # which nobody has to have; other cells are empty
        for folder in self.folders:
            table = read_whole(folder.path, GRADES)
            for row in table.rows:
                cells = {**nothing, **dict(zip(table.header, row.cells, strict=False))}
                if self.chosen[cells["student"]] is folder:
                    yield [cells.get(name, "") for name in header]

    def _list_printed(self) -> Iterator[Sequence[str]]:
        """The questions of each paper, where they are not all or not in the bank's order."""
        everywhere = tuple(name for name in self.questions if name != EXTRA)
        for student, folder in self.chosen.items():
            points = folder.totals.by_student[student].points
            counted = tuple(name for name in points if name != EXTRA)
            held = folder.printed.get(student, counted)
            if held != everywhere:
                yield student, QUESTIONS_BETWEEN.join(held)

    def _list_elsewhere(self) -> Iterator[Sequence[str]]:
        for student, folder in self.chosen.items():
            if student in folder.elsewhere or folder is not self.folders[0]:
                yield student, neutralise(folder.elsewhere.get(student, str(folder.path)))


def _is_written(total: StudentTotal) -> bool:
    """Whether a student handed in anything; folders of earlier versions do not say."""
    return total.status != "absent" or total.kept is not None


def _explain_several(student: str, written: Sequence[MarksFolder]) -> Fault:
    totals = [
        Message(
            "marks.total-in",
            marks=str(folder.path),
            points=write_amount(folder.totals.by_student[student].total),
            out_of=write_amount(folder.totals.by_student[student].out_of),
        )
        for folder in written
    ]
    what = Message("marks.in-several", student=Quoted(student), totals=list_statements(totals))
    return Fault("", what, do=Message("marks.add-prefer"))
