"""Tests that the suite leaves out, or of which it tries a sample of their cases
(`tests/sampling.py`), with all cases.

A case is one file of tests; as many seeds that follow each other as there are files give each of
them once.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path

from tests.prove.suite import list_test_files, run_tests
from tests.sampling import LEFT, MARK


def hold(seed: int, _: Path) -> None:
    """Run the sampled tests of a file whole, and those that the suite leaves out."""
    names = files()
    run_tests(names[seed % len(names)], "-m", f"{MARK} or {LEFT}")


@cache
def files() -> tuple[str, ...]:
    """The files of tests of which the suite does not try all."""
    marks = (f"pytest.mark.{mark}(" for mark in (MARK, LEFT))
    return tuple(sorted({file for mark in marks for file in list_test_files(mark)}))
