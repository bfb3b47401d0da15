"""An exam for 300 students, four questions with figures each, papers and key, as users make it on
the command line.

The peer is the whole job as it is usually done: for one student after the other, numbers are drawn,
the problems solved and sketched, an ordinary document with amsmath, siunitx and TikZ is written,
and pdflatex is run once. Drawing, solving and sketching are our own, so they count on both sides.
The peer makes a sample of the same papers, its programs are loaded and warm before the clock
starts, and it makes no key, so it has less to do. As a second peer, without promise, stands a run
of our own LaTeX source, which is written to be fast. Memory is that of the command with all its
processes.
"""

from __future__ import annotations

import os
import subprocess
import sys
import time
from collections.abc import Iterator, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory

from benchmarks.figure_of_merit import Figure, seconds
from benchmarks.memory import peak_of_tree
from benchmarks.ordinary_latex import ordinary_paper
from kinegrade.exam.bank.bank import find_bank, read_bank
from kinegrade.exam.bank.blueprint import Bank
from kinegrade.exam.folder.exam_secret import FromWords
from kinegrade.exam.printing.pages import lay_out_paper
from kinegrade.exam.roster.roster import Roster
from kinegrade.exam.setting.dealing import deal_exam
from kinegrade.exam.setting.setting import SetPaper

STUDENTS, HALF, SAMPLE = 300, 150, 10
BANK, SEED = "demo", "bench"
SOLVED = 60  # students whose worked solutions are timed
TYPST_PROMISE, LATEX_PROMISE = 8.5, 4
TYPST_SOUGHT = 20  # Typst alone takes a good half of the time that this allows
MEMORY_PROMISE, GROWTH_PROMISE = (
    1024,
    1.15,
)  # megabytes at 300 students; at most so many times that of 150


def figures() -> Iterator[Figure]:
    """Seconds per paper of four questions with figures, and megabytes of the whole class."""
    with TemporaryDirectory() as name:
        folder = Path(name)
        _, half = generate(folder, HALF)
        typst, memory = generate(folder, STUDENTS)
        yield Figure(
            "generate, 300 students: memory against 1 GiB", memory, MEMORY_PROMISE, 1, "MB"
        )
        yield Figure(
            "generate, 150 students: memory against that of 300",
            memory / GROWTH_PROMISE,
            half,
            1,
            "MB",
        )
        solved = solve(folder, SOLVED)
        latex, _ = generate(folder, STUDENTS, "--engine", "latex")
        ordinary, lean = one_job_each(folder, SAMPLE), one_run_each(kept_papers(folder, SAMPLE))
        yield Figure(
            "a paper by Typst against drawing and pdflatex for each",
            typst,
            ordinary,
            TYPST_PROMISE,
            sought=TYPST_SOUGHT,
        )
        yield Figure(
            "a paper by LaTeX, a run for many, against the same", latex, ordinary, LATEX_PROMISE
        )
        yield Figure(
            "its worked solutions by Typst, against the same paper by pdflatex",
            solved,
            ordinary,
            None,
        )
        yield Figure("a paper by Typst against a run of our own lean source", typst, lean, None)
        yield Figure("a paper by LaTeX against a run of our own lean source", latex, lean, None)


def generate(folder: Path, students: int, *options: str) -> tuple[float, float]:
    """Seconds per paper and peak memory in megabytes of the command, for a class of that size."""
    roster = class_of(folder, students)
    words = (
        *("generate", BANK, roster, "-o", folder / "EXAM"),
        *("--reproducible", SEED, "--force", *options),
    )
    took, memory = run_command(folder, words)
    return took / students, memory


def solve(folder: Path, students: int) -> float:
    """Seconds for the worked solutions of a paper, for so many students of the exam there."""
    named = [f"{number:05}" for number in range(students)]
    return run_command(folder, ("solutions", folder / "EXAM", *named))[0] / students


def run_command(folder: Path, words: Sequence[str | Path]) -> tuple[float, float]:
    """Seconds and peak memory in megabytes of a command. Its modules are kept compiled after the
    first run, as those of an installed program are.
    """
    usual = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    start = time.perf_counter()
    process = subprocess.Popen(
        [sys.executable, "-m", "kinegrade", *map(str, words)],
        stderr=subprocess.PIPE,
        env={**usual, "PYTHONPYCACHEPREFIX": str(folder / "compiled")},
    )
    memory = peak_of_tree(process)
    if process.returncode:
        raise RuntimeError(process.stderr.read().decode() if process.stderr else "")
    return time.perf_counter() - start, memory


def class_of(folder: Path, students: int) -> Path:
    """The roster of a class of that size."""
    roster = folder / f"{students}.csv"
    roster.write_text(
        "student,name\n" + "".join(f"{number:05},Student {number}\n" for number in range(students)),
        encoding="utf-8",
    )
    return roster


def one_job_each(folder: Path, count: int) -> float:
    """The median time of the whole job for one student, after one to warm up."""
    bank, place = read_bank(find_bank(Path(BANK)), SEED), folder / "ordinary"
    place.mkdir()
    roster = Roster.read(class_of(folder, STUDENTS))
    papers = deal_exam(bank, roster, FromWords(SEED)).papers()
    return seconds(lambda: ordinary_job(bank, papers, place), count)


def ordinary_job(bank: Bank, papers: Iterator[SetPaper], folder: Path) -> None:
    """The next student's paper solved, sketched, written as an ordinary document and printed by
    pdflatex; it was dealt already.
    """
    pages = lay_out_paper(bank, next(papers), "en")
    source = folder / f"{pages.student}.tex"
    source.write_text(ordinary_paper(pages), encoding="utf-8")
    run_latex(source)


def kept_papers(folder: Path, count: int) -> list[Path]:
    """The same papers in the LaTeX sources that `generate` has just kept."""
    return sorted((folder / "EXAM" / "tex" / "papers").glob("*.tex"))[: count + 1]


def one_run_each(sources: list[Path]) -> float:
    """The median time of an xelatex run for one paper, shell escape off, after one to warm up."""
    turn = iter(sources)
    return seconds(lambda: run_latex(next(turn), "xelatex"), len(sources) - 1)


def run_latex(source: Path, program: str = "pdflatex") -> None:
    """One run of a program of LaTeX."""
    subprocess.run(
        [program, "-no-shell-escape", "-interaction=batchmode", source.name],
        cwd=source.parent,
        check=True,
        capture_output=True,
    )
