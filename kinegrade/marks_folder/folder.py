"""A marks folder, read: the only way to what `kinegrade grade` wrote.

A command opens the folder once, with `open_marks`, and passes it on. Each file is read when it is
needed; marks.csv line by line, so that a class of any size takes no memory.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import groupby
from operator import attrgetter
from pathlib import Path

from kinegrade.errors import TableError
from kinegrade.files.csv_writing import restore
from kinegrade.files.placing.readings import note_reading
from kinegrade.files.tables import Complaint, Table
from kinegrade.grade_scale.scale import Scale
from kinegrade.language.message import Message
from kinegrade.marks_folder.cells import (
    Record,
    explain_cell,
    read_amount,
    read_records,
    read_records_if_any,
    read_whole,
    require_number,
)
from kinegrade.marks_folder.check import refuse_changed_totals
from kinegrade.marks_folder.complaints import read_complaints
from kinegrade.marks_folder.corrections import read_corrections
from kinegrade.marks_folder.earlier import find_mistakes, names_policy
from kinegrade.marks_folder.hand_marks import (
    ByHand,
    are_edited,
    find_only_by_hand,
    read_hand_marks,
)
from kinegrade.marks_folder.kept_totals import read_kept_totals
from kinegrade.marks_folder.layout import (
    ANSWERS,
    BONUS,
    BY_POLICY,
    CHANGES,
    EXAM,
    FOR_PEOPLE,
    FORMER_IDS,
    GRADES,
    MANUAL,
    MARKER,
    MERGED,
    PRINTED,
    PUT,
    QUESTIONS_BETWEEN,
)
from kinegrade.marks_folder.open_questions import OpenQuestion, read_open_questions
from kinegrade.marks_folder.rows import (
    ClassTotals,
    KeptTotal,
    MarkedAnswer,
    Orders,
    Put,
    StudentSums,
    Subtracted,
)
from kinegrade.marks_folder.scale_file import read_scale_file
from kinegrade.marks_folder.subtractions import read_subtracted
from kinegrade.marks_folder.sums.reading import read_sums
from kinegrade.marks_folder.table_html import write_table_html
from kinegrade.marks_folder.totals import read_totals


@dataclass(frozen=True)
class MarksFolder:
    """The files at `path`. TableError for one that is missing or `grade` cannot have written."""

    path: Path

    @cached_property
    def totals(self) -> ClassTotals:
        """grades.csv, with what kept.csv adds about its students."""
        some = {student for _, (student, _) in read_records_if_any(self.path, PRINTED)}
        return read_totals(self.path, self.kept, some)

    @cached_property
    def kept(self) -> Mapping[str, KeptTotal]:
        """The students whose earlier total stands; empty where there is no kept.csv."""
        return read_kept_totals(self.path)

    @cached_property
    def put(self) -> Put:
        """Whose line of the key each answer was marked by, where questions came from a pool; empty
        where all students were marked by their own.
        """
        found: dict[str, dict[str, str]] = {}
        for _, (student, question, ask, source) in read_records_if_any(self.path, PUT):
            found.setdefault(student, {})[f"{question}.{ask}"] = source
        return found

    @cached_property
    def printed(self) -> Orders:
        """The questions on paper in their order, where they differ from those of grades.csv."""
        found: dict[str, tuple[str, ...]] = {}
        for line, (student, listed) in read_records_if_any(self.path, PRINTED):
            found[student] = tuple(listed.split(QUESTIONS_BETWEEN))
            total = self.totals.by_student.get(student)
            held = self.totals.questions if total is None else total.points
            if sorted(found[student]) != sorted(set(held) - self.only_by_hand.keys()):
                expected = Message("marks.printed-order", file=GRADES.name)
                path = self.path / PRINTED.name
                raise TableError(explain_cell(path, line, "questions", listed, expected))
        return found

    @cached_property
    def by_hand(self) -> ByHand:
        """The marks that a person gave; empty where there is no manual.csv."""
        return read_hand_marks(self.path)

    @cached_property
    def only_by_hand(self) -> Mapping[str, Fraction]:
        """The questions of grades.csv that no machine marks, with what can be had for them."""
        return find_only_by_hand(self.by_hand)

    @cached_property
    def open(self) -> tuple[OpenQuestion, ...]:
        """The questions that nobody has been marked for by hand: no total counts them."""
        return tuple(each for each in self._unmarked if not each.counts)

    @cached_property
    def lacking(self) -> tuple[OpenQuestion, ...]:
        """The questions that others have a mark by hand for, with those who have none so far and
        count as having got nothing.
        """
        return tuple(each for each in self._unmarked if each.counts)

    @cached_property
    def _unmarked(self) -> tuple[OpenQuestion, ...]:
        return read_open_questions(self.path, self.only_by_hand)

    def leaves_out(self, question: str) -> bool:
        """Whether a question that only hands mark counts for nobody and is not waited for."""
        return question not in (*self.only_by_hand, *(each.question for each in self.open))

    @cached_property
    def bonus(self) -> frozenset[str]:
        """The questions whose points come on top of the maximum."""
        return frozenset(question for _, (question, _) in read_records_if_any(self.path, BONUS))

    @cached_property
    def corrections(self) -> int:
        """How often the key was corrected before the class was marked."""
        return read_corrections(self.path)

    @cached_property
    def exam(self) -> str:
        """By what the exam is known that the class was marked by; empty where that is unknown."""
        return next((exam for _, (exam,) in read_records_if_any(self.path, EXAM)), "")

    @cached_property
    def subtracted(self) -> Mapping[str, Subtracted]:
        """What was subtracted from totals, by student."""
        return read_subtracted(self.path)

    @cached_property
    def scale(self) -> Scale | None:
        """The scale by which grades were given; None where there are no grades."""
        return read_scale_file(self.path)

    @cached_property
    def elsewhere(self) -> Mapping[str, str]:
        """The students whose marks come from another exam, and the folder of marks that had
        them.
        """
        records = read_records_if_any(self.path, MERGED)
        return {student: restore(marks) for _, (student, marks) in records}

    @cached_property
    def former_ids(self) -> Mapping[str, str]:
        """The students by the ids that they had before; empty where nobody's was changed."""
        records = read_records_if_any(self.path, FORMER_IDS)
        return {formerly: student for _, (student, formerly) in records}

    @cached_property
    def log(self) -> tuple[Record, ...]:
        """The lines of changes.csv as they stand, the oldest first."""
        return tuple(cells for _, cells in read_records_if_any(self.path, CHANGES))

    def _repr_html_(self) -> str:
        return write_table_html(read_whole(self.path, GRADES))

    def answers(self) -> Iterator[MarkedAnswer]:
        """The lines of marks.csv, one by one."""
        path = self.path / ANSWERS.name
        for line, cells in read_records(self.path, ANSWERS):
            student, question, ask, typed, read_as, unit, verdict, points, out_of, *why = cells
            reason, mistakes, rule = map(restore, why)
            mark = self.by_hand.get(student, {}).get(f"{question}.{ask}")
            amount = read_amount(points, path, line, "points")
            yield MarkedAnswer(
                student,
                question,
                ask,
                restore(typed),
                require_number(read_as, path, line, "read_as"),
                unit,
                verdict,
                mark.points if mark else amount,
                read_amount(out_of, path, line, "out_of"),
                reason,
                find_mistakes(verdict, mistakes, reason),
                rule == BY_POLICY or names_policy(reason),
                mark,
            )

    def answers_by_student(self) -> Iterator[tuple[str, tuple[MarkedAnswer, ...]]]:
        """The answers of each student, one student at a time, in the order of the roster and of the
        asks.
        """
        for student, answers in groupby(self.answers(), attrgetter("student")):
            yield student, tuple(answers)

    @cached_property
    def sums(self) -> tuple[StudentSums, ...]:
        """The sums of marks.csv, one student after the other."""
        return tuple(read_sums(self.path, self.bonus, self.by_hand))

    def complaints(self) -> tuple[Complaint, ...]:
        """The lines of complaints.csv."""
        return read_complaints(self.path)

    def tables(self) -> Iterator[tuple[str, Table]]:
        """The tables meant for people, as they stand, each with its name."""
        by_hand = (MANUAL,) if self.by_hand else ()
        for file in (*FOR_PEOPLE, *by_hand):
            yield Path(file.name).stem, read_whole(self.path, file)


def open_marks(path: Path, *, to_mark_again: bool = False) -> MarksFolder:
    """The marks folder at a path. Raises TableError where its totals contradict its marks, or where
    it is not a marks folder; but `to_mark_again`, marks by hand may have been taken back since.
    """
    note_reading(path, MARKER)
    folder = MarksFolder(path)
    if not (to_mark_again and are_edited(path)):
        refuse_changed_totals(path, folder.totals, folder.sums, folder.scale)
    return folder
