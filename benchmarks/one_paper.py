"""One paper of an exam alone, in a new process, by the time of the processor.

The peer is what no program that uses these libraries can go below: a process that loads them, and
typesets the same paper once from a source that was written before.
"""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory

import kinegrade
from benchmarks.figure_of_merit import Figure
from kinegrade.exam.printing.pages import lay_out_paper
from kinegrade.exam.printing.reprint import reprint
from kinegrade.press.typst.paper import write_paper_source

STUDENT, BANK, SEED, REPEATS = "s1", "demo", "bench", 5
PROMISE = 0.25  # at most four times the time
LIBRARIES = """
import sys
import click, flint, markdown_it, msgspec, numpy, segno
from pathlib import Path
from kinegrade.press.typst.compiler import make_compiler
make_compiler().compile(Path(sys.argv[1]).read_bytes(), format="pdf", pdf_standards="ua-1")
"""


def figures() -> Iterator[Figure]:
    """Seconds of the processor, the best of several processes each."""
    with TemporaryDirectory() as name:
        folder = Path(name)
        exam, source = folder / "EXAM", folder / "paper.typ"
        (folder / "roster.csv").write_text(f"student,name\n{STUDENT},One\n", encoding="utf-8")
        setting = ("generate", BANK, folder / "roster.csv", "-o", exam, "--no-papers")
        run_process(("-m", "kinegrade", *setting, "--reproducible", SEED))
        again = reprint(kinegrade.open_exam(exam), STUDENT)
        pages = lay_out_paper(again.run.bank, again.paper, again.run.language)
        source.write_text(write_paper_source(pages), encoding="utf-8")
        printing = ("-m", "kinegrade", "paper", exam, STUDENT, "-o", "-")
        ours = min(run_process(printing) for _ in range(REPEATS))
        peer = min(run_process(("-c", LIBRARIES, source)) for _ in range(REPEATS))
    yield Figure("a paper alone against its libraries and one typesetting", ours, peer, PROMISE)


def run_process(arguments: Sequence[str | Path]) -> float:
    """Seconds of the processor that Python takes with these arguments; its modules are compiled."""
    usual = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    process = subprocess.Popen(
        [sys.executable, *map(str, arguments)],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        env={**usual, "RAYON_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"},
    )
    _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode:
        raise RuntimeError(f"{arguments}: ended with status {process.returncode}")
    return used.ru_utime + used.ru_stime
