"""Papers that are drawn become files: a part of the class at a time, by whichever press the exam
asks for.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import assert_never

from kinegrade.exam.blueprint import Bank
from kinegrade.exam.document import KeyPaper, Paper, PaperSize
from kinegrade.exam.key_mistakes import mistaken_answers
from kinegrade.exam.key_record import key_record
from kinegrade.exam.pages import key_paper, paper_pages
from kinegrade.exam.press import Engine, Press
from kinegrade.exam.setting import SetPaper
from kinegrade.exam.typst import TypstPress
from kinegrade.figure.sketch import sketch
from kinegrade.figure.sketchbook import sketch_once
from kinegrade.language import Language
from kinegrade.problem.template import Method


@dataclass(frozen=True)
class PressOrder:
    """Which press is wanted; LaTeX keeps its sources in the folder `sources`."""

    engine: Engine
    paper_size: PaperSize
    sources: Path

    def press(self) -> Press:
        """A new press. Raises TypesetError where its typesetter is not installed."""
        match self.engine:
            case "typst":
                return TypstPress(self.paper_size)
            case "latex":
                from kinegrade.exam.latex import LatexPress  # few exams need it, and it takes long

                return LatexPress(self.paper_size, self.sources)
            case _:
                assert_never(self.engine)


@dataclass(frozen=True)
class Extras:
    """What is wanted beside papers and key: worked solutions, by `method` where several serve, and
    papers in the other kinds of files named (docx, html).
    """

    solutions: bool = False
    method: Method | None = None
    also: tuple[str, ...] = ()


@dataclass(frozen=True)
class PrintRun:
    """All that holds for every paper of an exam; `sketchbook` is a private folder where processes
    share figures.
    """

    bank: Bank
    language: Language
    press_order: PressOrder
    papers: Path
    solutions: Path
    extras: Extras
    sketchbook: Path | None = None


@dataclass(frozen=True)
class Printed:
    """What remains of a paper when it is printed: its line of key.jsonl, and its part of the
    instructor's key.
    """

    record: str
    key: KeyPaper


def require_tools(extras: Extras) -> None:
    """Raises TypesetError where a program is missing that the extras need, before any work is
    done.
    """
    if extras.also:
        from kinegrade.exam.word import require_pandoc  # few exams need it

        require_pandoc(extras.also)


def print_papers(run: PrintRun, press: Press, papers: Sequence[SetPaper]) -> list[Printed]:
    """Write `NAME.pdf` for each of the papers, and for its worked solutions where they are wanted.

    Raises TypesetError with all faults of their texts.
    """
    figure = partial(sketch_once, run.sketchbook) if run.sketchbook else sketch
    pages = {
        paper.student.file_name: paper_pages(run.bank, paper, run.language, figure)
        for paper in papers
    }
    press.papers(pages, run.papers)
    if run.extras.solutions:
        # Loads the whole of worked solutions
        from kinegrade.exam.solution_pages import solution_sheet

        press.solutions(
            {
                paper.student.file_name: solution_sheet(
                    run.bank, paper, run.language, run.extras.method
                )
                for paper in papers
            },
            run.solutions,
        )
    if run.extras.also:
        write_also(pages, run)
    return [
        Printed(
            json.dumps(key_record(paper, mistakes, shuffled=run.bank.shuffle), ensure_ascii=False),
            key_paper(paper, run.language),
        )
        for paper, mistakes in zip(papers, mistaken_answers(papers), strict=True)
    ]


def write_also(pages: Mapping[str, Paper], run: PrintRun) -> None:
    """Write `NAME.docx`, `NAME.html` beside `NAME.pdf`. Raises TypesetError as
    `kinegrade.exam.word` does.
    """
    from kinegrade.exam.word import PandocPress  # few exams need it

    press = PandocPress(run.press_order.paper_size)
    for name, paper in pages.items():
        for kind in run.extras.also:
            (run.papers / f"{name}.{kind}").write_bytes(press.also(paper, kind))
