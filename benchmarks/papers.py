"""An exam for 300 students, four questions with figures each, papers and key, as users make it on the command line.

The peer is what is usual elsewhere: one LaTeX run for each student. It typesets the same papers by the same layout, on
a sample, in files that are drawn, solved and written as LaTeX before the clock starts, so it has less to do. Memory is
that of the command with all its processes. Where no LaTeX is on the machine its figures are left out, and the report
says so.
"""

from __future__ import annotations

import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from shutil import which
from tempfile import TemporaryDirectory

from benchmarks.figure_of_merit import Figure, seconds
from benchmarks.memory import peak_of_tree

STUDENTS, HALF, SAMPLE = 300, 150, 10
TYPST_PROMISE, LATEX_PROMISE = 25, 4
MEMORY_PROMISE, GROWTH_PROMISE = 1024, 1.15  # megabytes at 300 students; at most so many times that of 150


def figures() -> Iterator[Figure]:
    """Seconds per paper of four questions with figures, and megabytes of the whole class."""
    with TemporaryDirectory() as name:
        folder = Path(name)
        typst, memory = generate(folder, STUDENTS)
        _, half = generate(folder, HALF)
        yield Figure("generate, 300 students: memory against 1 GiB", memory, MEMORY_PROMISE, 1, "MB")
        yield Figure("generate, 150 students: memory against that of 300", memory / GROWTH_PROMISE, half, 1, "MB")
        if which("pdflatex") is None:
            print(f"papers: {typst * 1e3:.1f} ms each; no LaTeX on this machine to compare with")
            return
        latex, _ = generate(folder, STUDENTS, "--engine", "latex")
        peer = one_run_each(folder, SAMPLE)
        yield Figure("a paper by Typst against a LaTeX run of its own", typst, peer, TYPST_PROMISE)
        yield Figure("a paper by LaTeX, a run for many, against a run of its own", latex, peer, LATEX_PROMISE)


def generate(folder: Path, students: int, *options: str) -> tuple[float, float]:
    """Seconds per paper and peak memory in megabytes of the command, for a class of that size."""
    roster = folder / f"{students}.csv"
    roster.write_text("student,name\n" + "".join(f"{number:05},Student {number}\n" for number in range(students)),
                      encoding="utf-8")
    start = time.perf_counter()
    process = subprocess.Popen([sys.executable, "-m", "kinegrade", "generate", "demo", str(roster), "-o",
                                str(folder / "EXAM"), "--seed", "bench", "--force",
                                "--no-solutions", *options], stderr=subprocess.PIPE)
    memory = peak_of_tree(process)
    if process.returncode:
        raise RuntimeError(process.stderr.read().decode() if process.stderr else "")
    return (time.perf_counter() - start) / students, memory


def one_run_each(folder: Path, count: int) -> float:
    """The median time of a LaTeX run of one paper, from the sources that `generate` has just kept."""
    papers = folder / "EXAM" / "tex" / "papers"
    sources = iter(sorted(papers.glob("*.tex"))[:count + 1])
    return seconds(lambda: run_latex(papers, next(sources)), count)


def run_latex(folder: Path, source: Path) -> None:
    """One pdflatex run, shell escape off."""
    subprocess.run(["pdflatex", "-no-shell-escape", "-interaction=batchmode", source.name], cwd=folder, check=True,
                   capture_output=True)
