"""`kinegrade series`: several sheets of one bank, each an exam folder of its own, without repeats
among them.

A sheet that exists stays as it is, so that a series can be continued.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from datetime import datetime, timedelta
from pathlib import Path

from kinegrade.deadlines.moment import write_moment
from kinegrade.errors import BankError
from kinegrade.exam.bank.bank import find_bank, read_blueprint
from kinegrade.exam.bank.blueprint import Blueprint
from kinegrade.exam.folder.contents import HEAD
from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.exam.generating.options import GenerateOptions
from kinegrade.exam.homework import Homework, Kind
from kinegrade.language.message import Fault, Message


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
    `avoid` are the folders whose numbers nobody is to get again.
    """

    number: int
    blueprint: Blueprint
    folder: Path
    exists: bool
    avoid: tuple[Path, ...]

    def adapt(self, options: GenerateOptions) -> GenerateOptions:
        """The options of the series for this sheet, which draws numbers of its own."""
        words = options.reproducible
        own = None if words is None else f"{words} {self.number}"
        return replace(options, reproducible=own, avoid=(*options.avoid, *self.avoid))


def describe_kept(sheet: SeriesSheet) -> Message:
    """That a sheet exists and stays as it is; with its date, where it is not that of the series."""
    homework = sheet.blueprint.frame.homework
    here = "" if homework.due is None else write_moment(homework.due)
    there = open_exam(sheet.folder).head.due
    if here == there:
        return Message("terminal.sheet-kept", folder=str(sheet.folder))
    return Message(
        "terminal.sheet-kept-otherwise",
        folder=str(sheet.folder),
        there=_name_date(there),
        here=_name_date(here),
    )


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
