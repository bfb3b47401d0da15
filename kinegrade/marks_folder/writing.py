"""Writing the files of a marks folder: marks.csv while the class is being marked, the others
afterwards.

Typed text and names are written `neutralise`, so that no cell runs as a formula in a spreadsheet;
ids and numbers are written as they are.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache, partial
from pathlib import Path

from kinegrade.files.csv_writing import (
    encode,
    encode_for_people,
    neutralise,
    neutralise_cells,
    write_csv,
    write_csv_cell,
    write_csv_cells,
    write_csv_text,
    write_for_people,
)
from kinegrade.files.tables import Complaint
from kinegrade.grade_scale.scale import Scale
from kinegrade.language import Language
from kinegrade.language.catalogue import Catalogue, open_catalogue
from kinegrade.language.message import Text
from kinegrade.marks_folder.grade_list import GradeList
from kinegrade.marks_folder.hand_marks import HandMark
from kinegrade.marks_folder.layout import (
    ANSWERS,
    BONUS,
    COMPLAINTS,
    CORRECTIONS,
    EXAM,
    FORMER_IDS,
    GRADES,
    KEPT,
    LEFT_OUT,
    MANUAL,
    OPEN,
    POLICY,
    PRINTED,
    PUT,
    QUESTIONS_BETWEEN,
    SCALE,
    SCALE_GRADE,
    SUBTRACTED,
    SUBTRACTED_POINTS,
    Status,
    make_grades_header,
)
from kinegrade.marks_folder.open_questions import OpenQuestion
from kinegrade.marks_folder.rows import Grade, KeptTotal, Orders, Subtracted
from kinegrade.marks_folder.scale_file import write_scale_rows
from kinegrade.marks_folder.subtractions import write_subtracted
from kinegrade.numbers.amounts import write_amount


@dataclass(frozen=True, slots=True)
class MarksWriter:
    """Writes into a folder that exists, in the language of the exam."""

    path: Path
    language: Language

    @contextmanager
    def answers(self) -> Iterator[Callable[[bytes], object]]:
        """Gives a function that appends lines to marks.csv; their cells are safe as they stand."""
        with (self.path / ANSWERS.name).open("wb") as stream:
            stream.write(encode(write_csv_text(ANSWERS.columns, [])))
            yield stream.write

    def put(self, rows: Sequence[tuple[str, str, str, str]]) -> None:
        """Whose line of the key each answer was marked by, where it is not always the student's
        own: student, question, ask, and whose line.
        """
        if rows:
            write_csv(self.path / PUT.name, PUT.columns, rows)

    def grades(
        self,
        questions: tuple[str, ...],
        grades: GradeList,
        scale: Scale | None = None,
        *,
        subtracting: bool = False,
    ) -> None:
        """Every student's points, with what is subtracted where anything can be, and the grades
        that a scale gives, which is kept beside them.
        """
        needed = [SUBTRACTED_POINTS] if subtracting else []
        needed += [] if scale is None else [SCALE_GRADE]
        header = make_grades_header(questions, needed)
        text = write_csv_text(header, []) + "".join(_write_grade_lines(grades, needed))
        (self.path / GRADES.name).write_bytes(encode_for_people(text))
        if scale is not None:
            write_csv(self.path / SCALE.name, SCALE.columns, list(write_scale_rows(scale)))

    def complaints(self, complaints: Iterable[Complaint]) -> None:
        """What a person should look at."""
        # Much is said of many answers alike
        say = lru_cache(maxsize=1024)(open_catalogue(self.language).write)
        rows = (_write_complaint(complaint, say) for complaint in complaints)
        write_for_people(self.path / COMPLAINTS.name, COMPLAINTS.columns, rows)

    def policy(self, text: str) -> None:
        """The policy by which the class was marked; empty where the papers alone decide."""
        remark = open_catalogue(self.language).text("marks.no-policy")
        (self.path / POLICY).write_bytes((text or f"# {remark}\n").encode("utf-8"))

    def kept(self, kept: Iterable[KeptTotal]) -> None:
        """The students whose earlier total stands."""
        words = open_catalogue(self.language)
        rows = (_write_kept(each, words) for each in kept)
        write_for_people(self.path / KEPT.name, KEPT.columns, rows)

    def subtracted(self, subtracted: Iterable[Subtracted]) -> None:
        """What was subtracted from whose total."""
        words = open_catalogue(self.language)
        rows = (write_subtracted(each, words) for each in subtracted)
        write_for_people(self.path / SUBTRACTED.name, SUBTRACTED.columns, rows)

    def printed(self, orders: Orders) -> None:
        """The order of the questions on paper, by student, where it differs from the bank's."""
        if orders:
            rows = [(student, QUESTIONS_BETWEEN.join(order)) for student, order in orders.items()]
            write_csv(self.path / PRINTED.name, PRINTED.columns, rows)

    def bonus(self, points: Mapping[str, Fraction]) -> None:
        """The questions whose points come on top of the maximum, with these points."""
        if points:
            rows = [(question, write_amount(each)) for question, each in points.items()]
            write_csv(self.path / BONUS.name, BONUS.columns, rows)

    def corrections(self, count: int) -> None:
        """How often the key was corrected before."""
        if count:
            write_csv(self.path / CORRECTIONS.name, CORRECTIONS.columns, [(str(count),)])

    def former_ids(self, now: Mapping[str, str]) -> None:
        """The students by the ids that they had before."""
        if now:
            rows = [(student, formerly) for formerly, student in now.items()]
            write_csv(self.path / FORMER_IDS.name, FORMER_IDS.columns, rows)

    def exam(self, identity: str) -> None:
        """By what the exam is known."""
        if identity:
            write_csv(self.path / EXAM.name, EXAM.columns, [(identity,)])

    def open(
        self,
        questions: Iterable[OpenQuestion],
        names: Mapping[str, str],
        comments: Mapping[tuple[str, str], str],
        identity: str,
        *,
        codes: Mapping[str, str],
    ) -> None:
        """Who is still to be marked by hand for which questions, and what was said of that so far;
        `names` are by student, so are the `codes` by which answers were typed, and the exam is
        known by its `identity`.
        """
        rows = []
        for each in questions:
            asked = each.question, write_amount(each.points)
            for of in each.students:
                said = neutralise(comments.get((of, each.question), ""))
                whose = of, neutralise(names[of]), codes.get(of, "")
                rows.append((*whose, *asked, "", said, identity))
        if rows:
            write_for_people(self.path / OPEN.name, OPEN.columns, rows)

    def by_hand(self, marks: Iterable[HandMark]) -> None:
        """The marks that a person gave."""
        if rows := list(map(_write_hand_mark, marks)):
            write_for_people(self.path / MANUAL.name, MANUAL.columns, rows)

    def left_out(self, marks: Iterable[HandMark]) -> None:
        """The marks that a person gave to what the policy drops."""
        if rows := list(map(_write_hand_mark, marks)):
            write_for_people(self.path / LEFT_OUT.name, LEFT_OUT.columns, rows)


def _write_grade_lines(grades: GradeList, needed: Sequence[str]) -> Iterator[str]:
    students = write_csv_cells(grades.students)
    names = write_csv_cells(neutralise_cells(grades.names))
    ends = grades.write(partial(_write_end, needed=needed))
    for student, name, end in zip(students, names, ends, strict=True):
        yield f"{student},{name},{end}"


def _write_end(grade: Grade, needed: Sequence[str]) -> str:
    """What stands behind the name, with the end of the line."""
    status: Status = "absent" if grade.absent else "marked"
    last = [write_csv_cell(_LAST[each](grade)) for each in needed]
    return ",".join((*_write_amounts(grade), status, *last)) + "\n"


_LAST: Mapping[str, Callable[[Grade], str]] = {
    SUBTRACTED_POINTS: lambda grade: write_amount(grade.subtracted),
    SCALE_GRADE: lambda grade: neutralise(grade.grade),
}


def _write_amounts(grade: Grade) -> tuple[str, ...]:
    """Points by question, the total, the maximum, and the percentage."""
    points = ("" if each is None else write_amount(each) for each in grade.points)
    total = write_amount(grade.total), write_amount(grade.out_of)
    return (*points, *total, write_amount(grade.percent, places=2))


def _write_complaint(complaint: Complaint, say: Callable[[Text], str]) -> tuple[str, ...]:
    line = "" if complaint.line is None else str(complaint.line)
    said = say(complaint.problem), say(complaint.done)
    texts = complaint.column, complaint.content, *said
    return (neutralise(complaint.file), line, *map(neutralise, texts))


def _write_hand_mark(mark: HandMark) -> tuple[str, ...]:
    amounts = mark.points, mark.out_of, mark.machine
    shown = ("" if each is None else write_amount(each) for each in amounts)
    return (mark.student, mark.column, *shown, neutralise(mark.comment), mark.paper)


def _write_kept(kept: KeptTotal, words: Catalogue) -> tuple[str, ...]:
    amounts = kept.before, kept.before_out_of, kept.by_this_marking, kept.out_of, kept.stands
    return (
        kept.student,
        neutralise(kept.name),
        *map(write_amount, amounts),
        words.write(kept.reason),
    )
