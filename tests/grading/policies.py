"""A class in memory, marked by a policy that is given as text: for tests of policies and what
follows from them.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path

from kinegrade.exam.folder.asks import Ask
from kinegrade.exam.folder.exam_folder import ExamFolder, open_exam
from kinegrade.exam.folder.keys import Key
from kinegrade.exam.folder.papers import Paper, PaperBlock
from kinegrade.exam.folder.records import Candidate, ExamHead, ExamQuestion
from kinegrade.exam.keyed_exam import Examinee, KeyedExam
from kinegrade.files.tables import parse_table
from kinegrade.grading.grade import MarkingWishes, grade
from kinegrade.grading.marking import MarkingTerms, mark
from kinegrade.grading.marks import Mark, Marks
from kinegrade.grading.policy.accepted import alternatives
from kinegrade.grading.policy.policy import AS_PRINTED, Policy
from kinegrade.grading.policy.reading import read_policy
from kinegrade.grading.sheets.class_sheet import read_sheet
from kinegrade.marks_folder.folder import MarksFolder
from kinegrade.numbers.tolerance import ONE_PER_CENT, Tolerance
from tests.grading.small_exam import STUDENTS, exam, paper, write_exam
from tests.said import said

ZERO = Tolerance(Fraction(1, 100), Fraction(1, 500))
ASKS = (
    Ask("q1", "v_B", "m/s", Fraction(4)), Ask("q1", "omega_AB", "rad/s", Fraction(3), "counter-clockwise positive"),
    Ask("q2", "phi", "deg", Fraction(5, 2)),
)  # fmt: skip
KEYS = {
    "q1.v_B": Key(Fraction(2), ONE_PER_CENT, None, {"transport-for-absolute": Fraction(3),
                                                   "sense-reversed": Fraction(-2)}),
    "q1.omega_AB": Key(Fraction(0), ZERO, None, {"sense-reversed": Fraction(5)}),
    "q2.phi": Key(Fraction(30), ONE_PER_CENT, Fraction(360)),
}  # fmt: skip
ACCEPTED = "[questions.q1.asks.v_B]\naccept = [{}]\n"  # of a policy
CLASS = KeyedExam(ASKS, tuple(Examinee(student, student, KEYS) for student in ("007", "S9", "12")))


@dataclass(frozen=True)
class _InMemory(ExamFolder):
    """An exam folder whose papers are not read from its key."""

    exam: KeyedExam

    def papers(self) -> Iterator[Paper]:
        return self.exam.papers()

    def blocks(self, size: int) -> Iterator[PaperBlock]:
        return self.exam.blocks(size)


def folder_of(
    path: Path, exam: KeyedExam = CLASS, credit: dict[str, object] | None = None
) -> ExamFolder:
    """The folder of an exam in memory, of which `path` holds the key; `credit` is the bank's."""
    questions = tuple(
        ExamQuestion(question=name, asks=tuple(ask for ask in exam.asks if ask.question == name))
        for name in exam.questions
    )
    students = tuple(Candidate(each.student, each.name) for each in exam.examinees)
    head = ExamHead(format=2, language="en", questions=questions, students=students, credit=credit)
    return _InMemory(path, head, exam)


def policy_of(text: str, folder: Path, exam: KeyedExam = CLASS) -> Policy:
    """The policy in a text; `folder` is where it is written, and the exam's folder."""
    file = folder / "policy.toml"
    file.write_text(text, encoding="utf-8")
    return read_policy(file, folder_of(folder, exam))


def marked(
    rows: str, policy: Policy = AS_PRINTED, exam: KeyedExam = CLASS, givens: Path = Path()
) -> Marks:
    """The marks of CLASS for rows of: student, q1.v_B, q1.omega_AB, q2.phi."""
    header = ",".join(("student", *(ask.column for ask in exam.asks)))
    sheet = read_sheet(parse_table(f"{header}\n{rows}".encode(), "answers.csv"), exam)
    accepted = alternatives(exam, policy, folder_of(givens, exam))
    return mark(exam, sheet, MarkingTerms(policy, accepted))


def marks_of(marks: Marks, student: str) -> list[Mark]:
    """A student's marks in the order of the asks."""
    return [each for each in marks.marks if each.student == student]


def told(marks: Marks, student: str, index: int = 0) -> tuple[str, Fraction, str]:
    """Verdict, points and reason of one answer."""
    mark = marks_of(marks, student)[index]
    return mark.verdict.kind, mark.points, said(mark.verdict.reason)


def drawn_exam(folder: Path) -> Path:
    """An exam folder whose papers have parameters: r = 1 m, 2 m ..., omega = 30 rpm, phi = 30
    degrees.
    """
    papers = [paper(student) for student in STUDENTS]
    for number, each in enumerate(papers, 1):
        given = {
            "r": (str(number), "m"),
            "omega": ("30", "rpm"),
            "phi": ("30", "deg"),
            "h": ("sqrt(3)", "mm"),
        }
        for question in each["questions"]:
            question["parameters"] = {
                name: {"exact": text, "value": 0.0, "unit": unit}
                for name, (text, unit) in given.items()
            }
    return write_exam(folder, exam(), papers)


def regraded(exam: Path, name: str, policy: str | None = None, before: Path | None = None) -> Path:
    """The folder of marks `name` beside an exam folder and its answers.csv."""
    file = exam.parent / f"{name}.toml"
    if policy is not None:
        file.write_text(policy, encoding="utf-8")
    marks = exam.parent / name
    grade(
        open_exam(exam),
        exam.parent / "answers.csv",
        marks,
        MarkingWishes(
            policy=None if policy is None else file, never_lower=before and MarksFolder(before)
        ),
    )
    return marks
