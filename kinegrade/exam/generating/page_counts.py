"""All papers of an exam have the same number of pages, that of the longest, but those in large
print.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterator, Sequence
from contextlib import closing
from dataclasses import replace
from pathlib import Path

from msgspec import structs

from kinegrade.errors import Problem
from kinegrade.exam.printing.printed_files import replace_papers
from kinegrade.exam.printing.printing import Extras, Printed, PrintRun
from kinegrade.exam.roster.roster import Roster
from kinegrade.exam.roster.students import Student
from kinegrade.exam.roster.usual_pages import count_usual, find_most_pages
from kinegrade.exam.setting.dealing import ClassDeal
from kinegrade.language.message import Fault, Message

Printer = Callable[[PrintRun, ClassDeal], Generator[Printed, None, None]]


def fill_up_papers(
    folder: Path, run: PrintRun, dealt: ClassDeal, pages: Sequence[int], print_again: Printer
) -> PrintRun:
    """Print those papers of a class anew in `folder` that have fewer pages than others, and give
    the run with the number of pages that all have.

    `pages` are those of each paper. Papers printed together are alike already, so that few remain.
    """
    students = dealt.roster.students
    most = find_most_pages(students, pages)
    whole = structs.replace(run, pages=most)
    short = tuple(student for student, count in count_usual(students, pages) if count < most)
    if short:
        again = print_again(
            structs.replace(whole, extras=Extras()), replace(dealt, roster=Roster(short, ()))
        )
        with closing(again):
            printed = zip((each.file_name for each in short), again, strict=True)
            replace_papers(folder, printed, (each.file_name for each in students))
    return whole


def list_longer_papers(
    run: PrintRun, students: Sequence[Student], pages: Sequence[int]
) -> Iterator[Problem]:
    """A complaint for each paper that has more pages than all papers of the exam before it."""
    for student, count in count_usual(students, pages):
        if run.pages and count > run.pages:
            yield Fault(student.student, Message("exam.longer-paper", pages=count, usual=run.pages))
