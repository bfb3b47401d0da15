"""The grades of a class as a learning management system receives them, read from the folder that
`grade` wrote.

`read_grades` is called by every export. Students who handed in nothing are marked as such, because
an empty or zero grade would overwrite the one in the system. Points are exactly the numbers in the
files.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence, Set
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import assert_never

import msgspec

from kinegrade.errors import ExamError
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.folder.records import Candidate
from kinegrade.files.cell_text import trim
from kinegrade.files.csv_writing import neutralise
from kinegrade.language import ENGLISH, Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.message import Fault, Message, Quoted
from kinegrade.lms.grades.dialect import Field
from kinegrade.marks_folder.folder import MarksFolder
from kinegrade.marks_folder.hand_marks import EXTRA
from kinegrade.marks_folder.rows import QuestionSums, StudentSums, StudentTotal
from kinegrade.numbers.amounts import write_amount
from kinegrade.question_numbers import find_bank_number, number_printed

TOTAL = ""  # the item that is the sum of all questions


class StudentGrade(msgspec.Struct, frozen=True, gc=False):  # there are many
    """One student's points by question and in total (item TOTAL), and the maximum of each.

    `name` is that of grades.csv, neutralised against spreadsheets; `email` is empty where no exam
    was read. `printed` are the questions in the order of the paper, empty where that is the bank's;
    the points of those that are a `bonus` come on top of the maximum. `scale_grade` is "" where no
    scale was stated; `subtracted` is missing from the total, which is `earlier` where one of an
    earlier marking stands.
    """

    student: str
    name: str
    email: str
    points: Mapping[str, Fraction]
    out_of: Mapping[str, Fraction]
    handed_in: bool
    printed: tuple[str, ...] = ()
    bonus: Set[str] = frozenset()
    scale_grade: str = ""
    subtracted: Fraction = Fraction(0)
    earlier: bool = False


@dataclass(frozen=True, slots=True)
class ClassGrades:
    """All students in the order of grades.csv; `title` is the exam's, empty where no exam was read.

    `language` is that of the papers, English where no exam was read.
    """

    questions: tuple[str, ...]
    students: tuple[StudentGrade, ...]
    title: str = ""
    language: Language = ENGLISH

    def exported(self, *, ungraded: bool) -> tuple[StudentGrade, ...]:
        """The students who get a grade: those who handed in something, or all."""
        return tuple(each for each in self.students if ungraded or each.handed_in)


def known_as(grade: StudentGrade, field: Field) -> str:
    """A student's key in a system: the address, or the id, which may be the login there."""
    match field:
        case "id" | "login":
            return grade.student
        case "email":
            return trim(grade.email)
        case _:
            assert_never(field)


def read_grades(marks: MarksFolder, exam: ExamFolder | None = None) -> ClassGrades:
    """The grades of a marks folder; e-mails and the title from an exam folder.

    An absent student has handed in nothing, unless an earlier total is kept; in a folder of an
    earlier version that does not say who is absent, so has a student without any answer. Raises
    TableError for a folder that `grade` cannot have written, ExamError for a damaged exam.
    """
    totals, orders = marks.totals, marks.printed
    maxima, absent = dict(_list_maxima(marks.sums)), _find_absent(marks)
    nothing = {TOTAL: Fraction(0)}  # the maxima of one without lines in marks.csv
    students = tuple(
        _make_student_grade(
            total,
            points,
            maxima.get(total.student, nothing),
            orders.get(total.student, ()),
            marks.bonus,
            handed_in=total.student not in absent,
        )
        for total, points in zip(totals.students, _add_totals(totals.students), strict=True)
    )
    found = ClassGrades(totals.questions, students)
    return found if exam is None else _add_exam(found, exam)


def _find_absent(marks: MarksFolder) -> Set[str]:
    """Who handed in nothing."""
    totals = marks.totals.students
    absent = {each.student for each in totals if not each.is_present}
    unsaid = [each for each in totals if each.status is None and not each.total > 0]
    if not unsaid:
        return absent
    answered = {each.student for each in marks.sums if each.answered}
    return absent.union(each.student for each in unsaid if each.student not in answered)


def _list_maxima(
    sums: Iterable[StudentSums],
) -> Iterator[tuple[str, Mapping[str, Fraction]]]:
    """What could be had by each student for the questions and in total; neighbours with the same
    maxima share them, as a class of any size does.
    """
    shared: Mapping[str, Fraction] = {}
    known: QuestionSums | None = None
    for each in sums:
        if each.out_of is not known:
            known = each.out_of
            out_of = {**known.by_question, TOTAL: each.total_out_of}
            shared = shared if out_of == shared else out_of
        yield each.student, shared


def _add_totals(totals: Sequence[StudentTotal]) -> Iterator[Mapping[str, Fraction]]:
    """Points by question and in total; students share them where they share those by question."""
    shared: dict[tuple[int, int], Mapping[str, Fraction]] = {}
    for each in totals:
        # By identity, as hashing a fraction takes longer than the rest
        key = id(each.points), id(each.total)
        if key not in shared:
            shared[key] = {**each.points, TOTAL: each.total}
        yield shared[key]


def _make_student_grade(
    total: StudentTotal,
    points: Mapping[str, Fraction],
    out_of: Mapping[str, Fraction],
    printed: tuple[str, ...],
    bonus: Set[str],
    *,
    handed_in: bool,
) -> StudentGrade:
    """A student's grade for an export."""
    name = neutralise(total.name)
    # An empty set is made anew each time, and takes more than all the rest
    held = frozenset(bonus & out_of.keys()) if bonus else bonus
    return StudentGrade(
        total.student,
        name,
        "",
        points,
        out_of,
        handed_in,
        printed,
        held,
        total.grade,
        total.subtracted,
        total.kept is not None,
    )


def feedback_text(
    grade: StudentGrade, questions: tuple[str, ...], language: Language = ENGLISH
) -> str:
    """What the system shows a student: points by the number of the question on the student's paper,
    and nothing that the student typed; those of a bonus have a plus sign, and what is subtracted
    from the total a minus sign; and that an earlier total stands, if one does.

    >>> points = {"q1": Fraction(5, 2), "q2": Fraction(0)}
    >>> out_of = {"q1": Fraction(4), "q2": Fraction(3)}
    >>> feedback_text(StudentGrade("7", "", "", points, out_of, True), ("q1", "q2"))
    '1: 2.5/4; 2: 0/3'
    >>> feedback_text(StudentGrade("7", "", "", points, out_of, True, ("q2", "q1")), ("q1", "q2"))
    '1: 0/3; 2: 2.5/4'
    """
    others = [name for name in questions if name not in grade.printed and name in grade.points]
    numbered = list(zip(map(str, number_printed(grade.printed)), grade.printed, strict=True))
    numbered += [(find_bank_number(name), name) for name in others]
    shown = (_write_points(grade, number, name) for number, name in numbered)
    less = f"-{write_amount(grade.subtracted)}" if grade.subtracted else ""
    stands = open_catalogue(language).text("grades.earlier-stands") if grade.earlier else ""
    return "; ".join(filter(None, (*shown, less, stands)))


@dataclass(frozen=True, slots=True)
class FeedbackTexts:
    """The feedback on the grades of a class with these questions; most students share theirs with
    others. Grades are told apart by identity, as hashing fractions takes longer than writing them.
    """

    questions: tuple[str, ...]
    language: Language = ENGLISH
    known: dict[tuple[object, ...], str] = field(default_factory=dict)

    def write(self, grade: StudentGrade) -> str:
        """The feedback on a grade, which has to be kept as long as this is."""
        amounts = grade.points, grade.out_of, grade.subtracted
        which = grade.printed, grade.bonus, grade.earlier, *map(id, amounts)
        if which not in self.known:
            self.known[which] = feedback_text(grade, self.questions, self.language)
        return self.known[which]


def _write_points(grade: StudentGrade, number: str, question: str) -> str:
    """The points of a question after its number; "" for a bonus of which nothing could be had."""
    points = write_amount(grade.points[question])
    sign = "+" if question in grade.bonus else ""
    if question == EXTRA:
        return f"{number}: {sign}{points}" if grade.points[question] else ""
    return f"{number}: {sign}{points}/{write_amount(grade.out_of.get(question, Fraction(0)))}"


def _add_person(grade: StudentGrade, candidate: Candidate) -> StudentGrade:
    """The address; and the name, where the class was marked without names."""
    name = grade.name or neutralise(candidate.name)
    return msgspec.structs.replace(grade, name=name, email=trim(candidate.email))


def _add_exam(grades: ClassGrades, exam: ExamFolder) -> ClassGrades:
    candidates = exam.head.candidates
    strangers = [each.student for each in grades.students if each.student not in candidates]
    if strangers:
        other = Message("grades.other-exam", student=Quoted(strangers[0]), number=len(strangers))
        raise ExamError(Fault(str(exam.head_file), other))
    return replace(
        grades,
        title=" ".join(exam.head.title.split()),
        language=exam.language,
        students=tuple(_add_person(each, candidates[each.student]) for each in grades.students),
    )
