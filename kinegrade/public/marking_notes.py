"""What is said of a marking when it is done: what was written, what hands gave, what was
subtracted, and the grades.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from os import PathLike
from pathlib import Path

from kinegrade.errors import Problem
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.grading.marks import ClassGrades
from kinegrade.grading.policy.reading import read_policy, stated_policy
from kinegrade.language.message import Fault, Message, list_first
from kinegrade.lms.grades import moodle
from kinegrade.marks_folder.folder import MarksFolder
from kinegrade.marks_folder.hand_marks import list_hand_marks
from kinegrade.marks_folder.layout import KEPT, MANUAL, SUBTRACTED
from kinegrade.marks_folder.open_questions import describe_open
from kinegrade.numbers.amounts import write_amount

_MOST_NAMED = 5
_FEW_STUDENTS = 5
_SAMPLE = 1000  # of a large class
_HARDLY_ANY = Fraction(1, 10)


def describe_key(exam: ExamFolder) -> Iterator[Fault]:
    """That the key by which a class is marked is not the one that was generated."""
    if exam.has_changed_key:
        what, do = Message("terminal.key-changed"), Message("terminal.verify-key")
        yield Fault(str(exam.keys.file), what, do=do)


def describe_points(grades: ClassGrades, marks: MarksFolder) -> Iterator[Problem]:
    """What hands gave, what was subtracted, and that totals are scaled for another system."""
    yield from _describe_by_hand(grades, marks)
    yield from _describe_subtracted(marks)
    yield from moodle.describe_scaled(marks.path, (each.out_of for each in grades.grades))


def _describe_by_hand(grades: ClassGrades, marks: MarksFolder) -> Iterator[Problem]:
    """What hands marked, and what they still have to mark."""
    yield from grades.notes
    given = list(list_hand_marks(marks.by_hand))
    if given:
        changed = sum(mark.is_override for mark in given)
        overrides = Message("terminal.overrides", count=changed)
        file = str(marks.path / MANUAL.name)
        yield Message("terminal.by-hand", file=file, count=len(given), overrides=overrides)
    if marks.open:
        yield describe_open(marks.open)


def _describe_subtracted(marks: MarksFolder) -> Iterator[Message]:
    """From how many totals points were subtracted, where a policy says what costs any."""
    if (marks.path / SUBTRACTED.name).exists():
        points = [each.subtracted for each in marks.totals.students if each.subtracted]
        whole = write_amount(sum(points, Fraction(0)))
        file = str(marks.path / SUBTRACTED.name)
        yield Message("terminal.subtracted", file=file, count=len(points), points=whole)


def describe_grades(
    marks: MarksFolder, exam: ExamFolder, policy: str | PathLike[str] | None
) -> Iterator[Message]:
    """By which scale grades were given, and how many passed; or that they wait."""
    banks = stated_policy(exam).scale
    stated = banks if policy is None else read_policy(Path(policy), exam).scale
    if stated is None:
        return
    if stated != banks and banks is not None:
        yield Message("terminal.scale-of-policy", file=str(policy))
    if marks.scale is None:
        yield Message("terminal.grades-wait")
        return
    passing = {step.grade for step in marks.scale.steps if step.passes}
    present = [each for each in marks.totals.students if each.is_present]
    least = marks.scale.pass_mark or Fraction(0)
    yield Message(
        "terminal.graded",
        mark=Message("scale.percent", number=write_amount(100 * least, places=2)),
        count=sum(each.grade in passing for each in present),
        present=len(present),
        absent=len(marks.totals.students) - len(present),
    )


def list_written(marks: ClassGrades, output: Path, *, kept: bool) -> Iterator[Message]:
    """What was written, one line each; and who has no answer in it."""
    complaints = Message("terminal.complaints", count=len(marks.complaints))
    yield Message(
        "terminal.marked", folder=str(output), count=len(marks.grades), complaints=complaints
    )
    if kept:
        who = sum(each.kept is not None for each in marks.grades)
        yield Message("terminal.kept-totals", file=str(output / KEPT.name), count=who)
    yield from _describe_absent(marks)
    yield from _describe_strangers(marks)


def _describe_absent(grades: ClassGrades) -> Iterator[Message]:
    """Who answered nothing at all, where anybody did: perhaps the wrong file was given."""
    absent = [each.student for each in grades.grades if each.absent]
    if absent:
        names = list_first(absent, _MOST_NAMED)
        yield Message("terminal.absent", count=len(absent), all=len(grades.grades), names=names)


def _describe_strangers(grades: ClassGrades) -> Iterator[Message]:
    """That a class has hardly any points, as one has whose answers are to another exam: sheets of a
    series may ask the same of the same students.
    """
    everybody = [each for each in grades.grades if not each.absent]
    present = everybody[:: len(everybody) // _SAMPLE + 1]
    possible = sum(float(each.out_of) for each in present)
    share = sum(float(each.total) for each in present) / possible if possible else 1.0
    if len(everybody) >= _FEW_STUDENTS and share < _HARDLY_ANY:
        percent = write_amount(Fraction(100 * share), places=1)
        yield Message("terminal.hardly-any", count=len(everybody), percent=percent)
