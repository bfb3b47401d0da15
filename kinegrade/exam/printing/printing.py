"""Printing papers that have been set: a part of the class at a time, by the press that the exam
asks for.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import assert_never

from msgspec import Struct

from kinegrade.exam.bank.blueprint import Bank
from kinegrade.exam.folder.contents import PAPERS, SOLUTIONS
from kinegrade.exam.printing.pages import lay_out_paper
from kinegrade.exam.setting.setting import SetPaper
from kinegrade.figure.sketch import Sketcher, sketch
from kinegrade.language import Language
from kinegrade.press.protocol import Engine, Press, Printout
from kinegrade.press.sheet import KeyPaper, Paper, PaperSize
from kinegrade.press.typst.press import TypstPress
from kinegrade.problem.template.template import Method


class PressOrder(Struct, frozen=True):
    """Which press is wanted."""

    engine: Engine
    paper_size: PaperSize

    def press(self) -> Press:
        """A new press. Raises TypesetError where its typesetter is not installed."""
        match self.engine:
            case "typst":
                return TypstPress(self.paper_size)
            case "latex":
                from kinegrade.press.latex.press import (
                    LatexPress,  # few exams need it, and it takes long
                )

                return LatexPress(self.paper_size)
            case _:
                assert_never(self.engine)


class Extras(Struct, frozen=True):
    """What is wanted beside the key: worked solutions, by `method` where several serve, with graphs
    over the `cycle`, in `solution_language` for everybody, else in that of each paper; papers in
    the other kinds of files named (docx, html). Without `papers` none is printed.
    """

    solutions: bool = False
    method: Method | None = None
    cycle: bool = False
    also: tuple[str, ...] = ()
    solution_language: Language | None = None
    papers: bool = True

    @property
    def files(self) -> int:
        """How many files each paper has in its folder."""
        return 1 + len(self.also)

    @property
    def folders(self) -> tuple[str, ...]:
        """The folders of what is printed."""
        wanted = {PAPERS: self.papers, SOLUTIONS: self.solutions}
        return tuple(name for name in wanted if wanted[name])


class PrintRun(Struct, frozen=True):
    """All that holds for every paper of an exam.

    `pages` is how many each paper has at least; None for as many as the longest of those that are
    printed together.
    """

    bank: Bank
    language: Language
    press_order: PressOrder
    extras: Extras
    pages: int | None = None

    @property
    def cycle(self) -> bool:
        """Whether worked solutions end with graphs over the cycle: where either asks for them."""
        return self.extras.cycle or self.bank.cycle

    def bind(self, paper: Printout) -> Printout:
        """A paper with the formula sheet of the bank behind it, whose pages do not count. Raises
        TypesetError.
        """
        sheet, size = self.bank.formula_sheet, self.press_order.paper_size
        if sheet is None:
            return paper
        from kinegrade.press.formula_sheet import bind  # few exams need it

        return replace(paper, pdf=bind(paper.pdf, sheet, self.language, size))


class Printed(Struct, frozen=True):
    """A paper and its worked solutions, where they are wanted, and the paper in other kinds of
    files; its line of key.jsonl, and its part of the instructor's key. `pages` counts those of the
    paper.
    """

    paper: Printout | None
    pages: int
    solution: Printout | None
    also: Mapping[str, bytes]
    record: bytes
    key: KeyPaper


def require_tools(extras: Extras) -> None:
    """Raises TypesetError where a program is missing that the extras need, before any work is
    done.
    """
    if extras.also:
        from kinegrade.press.word.pandoc import require_pandoc  # few exams need it

        require_pandoc(extras.also)


def print_papers(
    run: PrintRun,
    press: Press,
    papers: Sequence[SetPaper],
    sketcher: Sketcher = sketch,
    longest: int = 0,
) -> list[Printed]:
    """Each of the papers, and its worked solutions, as far as they are wanted; `sketcher` draws
    their figures. The `longest` of the papers that stay beside them has so many pages.

    Raises TypesetError with all faults of their texts.
    """
    # What the key takes, which a paper that is printed alone does not need
    from kinegrade.exam.folder.writing import encode_line
    from kinegrade.exam.printing.key_pages import make_key_paper
    from kinegrade.exam.setting.key_mistakes import find_mistaken_answers
    from kinegrade.exam.setting.key_record import make_key_line

    pages = {
        paper.student.file_name: lay_out_paper(run.bank, paper, run.language, sketcher)
        for paper in (papers if run.extras.papers else ())
    }
    printouts, counts = press.alike(pages, run.pages, longest)
    solutions = print_solutions(run, press, papers) if run.extras.solutions else {}
    also = _print_also(pages, run, papers) if run.extras.papers else {}
    return [
        Printed(
            run.bind(printouts[name]) if name in printouts else None,
            counts.get(name, 0),
            solutions.get(name),
            also.get(name, {}),
            encode_line(make_key_line(paper, mistakes, ordered=run.bank.states_orders)),
            make_key_paper(run.bank, paper, run.language),
        )
        for paper, mistakes in zip(papers, find_mistaken_answers(papers), strict=True)
        for name in (paper.student.file_name,)
    ]


def print_solutions(run: PrintRun, press: Press, papers: Sequence[SetPaper]) -> dict[str, Printout]:
    """The worked solutions of each paper, by its file name."""
    # It loads everything for worked solutions
    from kinegrade.exam.printing.solution_pages import SolutionWriter, write_solution_sheet

    wanted = run.extras
    writer = SolutionWriter(run.language, wanted.method, wanted.solution_language, run.cycle)
    return press.solutions(
        {paper.student.file_name: write_solution_sheet(run.bank, paper, writer) for paper in papers}
    )


def _print_also(
    pages: Mapping[str, Paper], run: PrintRun, papers: Sequence[SetPaper]
) -> dict[str, dict[str, bytes]]:
    """Each paper, by its file name, in the other kinds of files that are wanted, and the figures of
    those who read by touch. Raises TypesetError as `kinegrade.press.word.press` does.
    """
    also: dict[str, dict[str, bytes]] = {name: {} for name in pages}
    if run.extras.also:
        from kinegrade.press.word.press import PandocPress  # few exams need it

        press = PandocPress(run.press_order.paper_size)
        for name, paper in pages.items():
            also[name] |= {kind: press.also(paper, kind) for kind in run.extras.also}
    for touched in (paper for paper in papers if paper.student.reads_by_touch):
        from kinegrade.exam.printing.tactile_sheets import KIND, make_tactile_sheets

        also[touched.student.file_name][KIND] = make_tactile_sheets(touched, run.language)
    return also
