"""What the typesetter alone takes of a paper, its key and its worked solutions: no change of the
rest can bring their cost below it.

Typst is timed where it is called, each page in a compiler that has set others of the same class, by
the time of the processor. The peer is the ordinary job of `benchmarks.papers`, by the clock.
"""

from __future__ import annotations

import os
import time
from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Literal

from benchmarks.figure_of_merit import Figure
from benchmarks.papers import BANK, SAMPLE, SEED, one_job_each
from kinegrade.exam.bank.bank import find_bank, read_bank
from kinegrade.exam.folder.exam_secret import FromWords
from kinegrade.exam.printing.key_pages import make_key_book, make_key_paper
from kinegrade.exam.printing.pages import lay_out_paper
from kinegrade.exam.printing.solution_pages import SolutionWriter, write_solution_sheet
from kinegrade.exam.roster.roster import Roster
from kinegrade.exam.roster.students import Student
from kinegrade.exam.setting.dealing import deal_exam
from kinegrade.press.typst.press import TypstPress

STUDENTS = 60


def figures() -> Iterator[Figure]:
    """Seconds of Typst for each student."""
    os.environ["RAYON_NUM_THREADS"] = "1"
    with TemporaryDirectory() as name:
        ordinary = one_job_each(Path(name), SAMPLE)
    for printed, seconds in measure().items():
        title = f"Typst alone: {printed}, against drawing and pdflatex"
        yield Figure(title, seconds / STUDENTS, ordinary, None)


class TimedPress(TypstPress):
    """A press that counts the seconds of the processor in its compiler."""

    seconds = 0.0

    def _pdf(self, source: str, standard: Literal["a-2b", "ua-1"]) -> bytes:
        start = time.process_time()
        pdf = super()._pdf(source, standard)
        self.seconds += time.process_time() - start
        return pdf


def measure() -> dict[str, float]:
    """Seconds of Typst for all papers of a class, their key, and their worked solutions."""
    bank = read_bank(find_bank(Path(BANK)))
    students = tuple(Student(f"s{number}", "One", "", f"s{number}") for number in range(STUDENTS))
    papers = list(deal_exam(bank, Roster(students, ()), FromWords(SEED)).papers())
    printing, keys, solving = TimedPress(), TimedPress(), TimedPress()
    writer = SolutionWriter("en")
    for paper in papers:
        printing.paper(lay_out_paper(bank, paper, "en"))
        solving.solution(write_solution_sheet(bank, paper, writer))
    keys.key(make_key_book(bank, [make_key_paper(bank, paper, "en") for paper in papers], "en"))
    presses = {"a paper": printing, "its key": keys, "its worked solutions": solving}
    return {printed: press.seconds for printed, press in presses.items()}
