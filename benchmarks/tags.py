"""What it costs that a paper can be heard: one set, solved, drawn and typeset with tags, against
the same without them, by the time of the processor; and its size, where papers are joined.
"""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from pathlib import Path

from benchmarks.figure_of_merit import Figure
from kinegrade.exam.bank.bank import find_bank, read_bank
from kinegrade.exam.folder.exam_secret import FromWords
from kinegrade.exam.printing.pages import lay_out_paper
from kinegrade.exam.roster.roster import Roster
from kinegrade.exam.roster.students import Student
from kinegrade.exam.setting.dealing import deal_exam
from kinegrade.press.join import join_pages
from kinegrade.press.typst.compiler import make_compiler
from kinegrade.press.typst.paper import write_paper_source

STUDENTS, REPEATS, BANK, SEED = 24, 5, "demo", "bench"
TIME_PROMISE = 1 / 1.1  # at most a tenth more
MEGABYTE = 1e6


def figures() -> Iterator[Figure]:
    """Seconds of the processor for a paper, and megabytes of a volume."""
    os.environ["RAYON_NUM_THREADS"] = "1"
    setting, sources = measure(write_sources)
    heard, tagged = measure(partial(typeset, sources, tags=True))
    unheard, bare = measure(partial(typeset, sources, tags=False))
    yield Figure(
        "a paper with tags against one without",
        (setting + heard) / STUDENTS,
        (setting + unheard) / STUDENTS,
        TIME_PROMISE,
    )
    yield Figure("typesetting it alone", heard / STUDENTS, unheard / STUDENTS, None)
    volumes = [len(join_pages(each)) / MEGABYTE for each in (tagged, bare)]
    yield Figure("a volume of 24 papers with tags against one without", *volumes, None, "MB")


def measure(work: Callable[[], list[bytes]]) -> tuple[float, list[bytes]]:
    """The least seconds of several runs, after one to warm up, and what they give."""
    found, times = work(), []
    for _ in range(REPEATS):
        start = time.process_time()
        work()
        times.append(time.process_time() - start)
    return min(times), found


def write_sources() -> list[bytes]:
    """The Typst sources of a class, from the bank on."""
    bank = read_bank(find_bank(Path(BANK)))
    students = tuple(Student(f"s{number}", "One", "", f"s{number}") for number in range(STUDENTS))
    dealt = deal_exam(bank, Roster(students, ()), FromWords(SEED))
    pages = (lay_out_paper(bank, paper, "en") for paper in dealt.papers())
    return [write_paper_source(page).encode() for page in pages]


def typeset(sources: Sequence[bytes], *, tags: bool) -> list[bytes]:
    """Each of the papers as PDF."""
    compiler = make_compiler()
    standard = "ua-1" if tags else "a-2b"
    return [
        bytes(
            compiler.compile(
                source, format="pdf", pdf_standards=standard, timestamp=0, pdf_tags=tags
            )
        )
        for source in sources
    ]
