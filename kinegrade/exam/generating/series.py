"""`kinegrade series`: several sheets of one bank, each an exam folder of its own, without repeats
among them.

A sheet that exists stays as it is, so that a series can be continued.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from datetime import datetime, timedelta
from fractions import Fraction
from pathlib import Path

from kinegrade.deadlines.moment import write_moment
from kinegrade.errors import BankError, Problem
from kinegrade.exam.bank.bank import find_bank, read_blueprint
from kinegrade.exam.bank.blueprint import Blueprint
from kinegrade.exam.folder.contents import HEAD
from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.exam.folder.records import ExamHead
from kinegrade.exam.generating.options import GenerateOptions
from kinegrade.exam.homework import Homework, Kind
from kinegrade.exam.roster.roster import Roster
from kinegrade.exam.roster.students import make_student_key
from kinegrade.language.message import Fault, Message, Quoted, list_first
from kinegrade.numbers.amounts import write_amount

_MOST_NAMED = 5


@dataclass(frozen=True, slots=True)
class SeriesPlan:
    """How many sheets there are; when the first is due, None where the bank or nobody says it, and
    how long after it the next one is.
    """

    sheets: int
    due: datetime | None = None
    every: timedelta = timedelta(weeks=1)


@dataclass(frozen=True, slots=True)
class SeriesSheet:
    """One sheet: its number, what it asks, where its folder is to stand, and whether that exists;
    `others` are those that exist, whose numbers nobody is to get again, nor what they avoid.
    """

    number: int
    blueprint: Blueprint
    folder: Path
    exists: bool
    others: tuple[Path, ...]

    def adapt(self, options: GenerateOptions) -> GenerateOptions:
        """The options of the series for this sheet, which draws numbers of its own."""
        words = options.reproducible
        own = None if words is None else f"{words} {self.number}"
        return replace(options, reproducible=own, sheets=self.others)


def describe_kept(sheet: SeriesSheet, roster: Roster) -> Iterator[Problem]:
    """That a sheet exists and stays as it is; with its date, its students and its points, where
    they are not those of the series.
    """
    head = open_exam(sheet.folder).head
    homework = sheet.blueprint.frame.homework
    here = "" if homework.due is None else write_moment(homework.due)
    folder = str(sheet.folder)
    if here == head.due:
        yield Message("terminal.sheet-kept", folder=folder)
    else:
        there, date = _name_date(head.due), _name_date(here)
        yield Message("terminal.sheet-kept-otherwise", folder=folder, there=there, here=date)
    yield from _compare_students(folder, head, roster)
    yield from _compare_points(folder, head, sheet.blueprint)


def _compare_students(folder: str, head: ExamHead, roster: Roster) -> Iterator[Fault]:
    """Who of the roster has no paper of a sheet, and who has one and is not in the roster; whoever
    has another id since is neither.
    """
    there = {make_student_key(each.student): Quoted(each.student) for each in head.students}
    here = {make_student_key(each.student): Quoted(each.student) for each in roster.students}
    for before, student in head.former_ids.items():
        if here.pop(make_student_key(before), None):
            here[make_student_key(student)] = Quoted(student)
            what = Message("terminal.sheet-renamed", before=Quoted(before), now=Quoted(student))
            yield Fault(folder, what, do=Message("terminal.rename-in", roster=roster.file))
    if new := [student for key, student in here.items() if key not in there]:
        who, do = list_first(new, _MOST_NAMED), Message("terminal.add-to-sheet", folder=folder)
        yield Fault(folder, Message("terminal.sheet-lacks", students=who), do=do)
    if left := [student for key, student in there.items() if key not in here]:
        who = list_first(left, _MOST_NAMED)
        yield Fault(folder, Message("terminal.sheet-has", students=who, roster=roster.file))


def _compare_points(folder: str, head: ExamHead, blueprint: Blueprint) -> Iterator[Fault]:
    """The questions that count otherwise on a sheet than in the bank."""
    stated = {each.template.name for slot in blueprint.slots for each in slot.candidates}
    chosen = {each.question: each.template for each in head.questions if each.template in stated}
    bank = blueprint.choose(chosen)
    there = {each.question: (each.points, each.bonus) for each in head.questions}
    there |= {each.question: (each.points, each.bonus) for each in head.by_hand}
    here = {each.identifier: (each.points, each.bonus) for each in bank.questions}
    here |= {each.identifier: (each.points, each.bonus) for each in bank.by_hand}
    for question in there | here:
        kept, wanted = (_write_points(each.get(question)) for each in (there, here))
        if kept != wanted:
            what = Message("terminal.sheet-points", question=question, here=kept, bank=wanted)
            yield Fault(folder, what, do=Message("terminal.set-sheet-anew"))


def _write_points(counted: tuple[Fraction, bool] | None) -> str:
    """What a question is worth, "+" before what comes on top of the maximum."""
    points, bonus = counted or (Fraction(0), False)
    return f"{'+' if bonus else ''}{write_amount(points)}"


def _name_date(date: str) -> Message:
    return Message("terminal.sheet-due", date=date) if date else Message("terminal.sheet-undated")


def plan_sheets(bank: Path, output: Path, plan: SeriesPlan) -> Iterator[SeriesSheet]:
    """The sheets of a series below a folder, one after the other. Raises BankError."""
    path = find_bank(bank)
    stated = read_blueprint(path).frame.homework
    _require_free(path, stated, plan)
    kind: Kind = stated.stated or "homework"
    folders = [output / f"{kind}-{number}" for number in range(1, plan.sheets + 1)]
    for number, folder in enumerate(folders, 1):
        others = tuple(each for each in folders if each != folder and (each / HEAD).exists())
        blueprint = read_blueprint(path, before=_write_keys(number, stated, plan))
        yield SeriesSheet(number, blueprint, folder, (folder / HEAD).exists(), others)


def _require_free(path: Path, stated: Homework, plan: SeriesPlan) -> None:
    """Raises BankError where a bank states what the series does."""
    faults = []
    if stated.sheet:
        what = Message("exam.states-sheet", number=stated.sheet)
        faults.append(Fault(str(path), what, do=Message("exam.leave-sheet-out")))
    if stated.due is not None and plan.due is not None:
        what = Message("exam.states-due", due=write_moment(stated.due))
        faults.append(Fault(str(path), what, do=Message("exam.leave-due-out")))
    if faults:
        raise BankError(*faults)


def _write_keys(number: int, stated: Homework, plan: SeriesPlan) -> str:
    """The lines that make the bank that of a sheet, to stand before its own."""
    lines = [f"sheet = {number}"]
    if stated.stated is None:
        lines.append('kind = "homework"')
    if plan.due is not None:
        lines.append(f'due = "{write_moment(plan.due + (number - 1) * plan.every)}"')
    return "".join(f"{line}\n" for line in lines)
