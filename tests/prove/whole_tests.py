"""Tests of which the suite tries a sample of their cases (`tests/sampling.py`), with all cases.

A case is one file of tests; as many seeds that follow each other as there are files give each of
them once.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path

from tests.prove.suite import list_test_files, run_tests
from tests.sampling import MARK


def hold(seed: int, _: Path) -> None:
    """Run the sampled tests of a file whole."""
    names = files()
    run_tests(names[seed % len(names)], "-m", MARK)


@cache
def files() -> tuple[str, ...]:
    """The files of tests of which the suite tries a sample."""
    return list_test_files(f"\n@pytest.mark.{MARK}(")
