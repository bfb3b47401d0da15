"""Tests that the suite leaves out, or of which it tries a sample of their cases
(`tests/sampling.py`), with all cases.

A case is one file of tests, or a part of a folder whose tests share what is dear: of `tests/worked/`
those of some templates, whose solutions are written once and not by each file anew. As many seeds
that follow each other as there are cases give each of them once.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path

from tests.prove.suite import list_test_files, run_tests
from tests.sampling import LEFT, MARK

SHARED = "tests/worked"
PARTS = 24  # of three templates each: some 40 seconds of the processor
Case = tuple[str, ...]  # a file or folder, and options


def hold(seed: int, _: Path) -> None:
    """Run the sampled tests of a case whole, and those that the suite leaves out."""
    all_cases = cases()
    run_tests(*all_cases[seed % len(all_cases)], "-m", f"{MARK} or {LEFT}")


@cache
def cases() -> tuple[Case, ...]:
    """Which tests are run together."""
    alone = ((file,) for file in files() if not file.startswith(f"{SHARED}/"))
    together = ((SHARED, "--part", f"{part}/{PARTS}") for part in range(PARTS))
    return (*alone, *together)


@cache
def files() -> tuple[str, ...]:
    """The files of tests of which the suite does not try all."""
    marks = (f"pytest.mark.{mark}(" for mark in (MARK, LEFT))
    return tuple(sorted({file for mark in marks for file in list_test_files(mark)}))
