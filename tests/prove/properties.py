"""Every property of the suite, the laws of kinematics among them, at new examples of hypothesis.

A case is one file of tests. Their sample is the suite itself, which runs the same examples every
time.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path

from tests.prove.suite import list_test_files, run_tests


def hold(seed: int, _: Path) -> None:
    """Run the properties of a file by that seed of hypothesis."""
    names = files()
    run_tests(names[seed % len(names)], "-m", "hypothesis", f"--hypothesis-seed={seed}")


@cache
def files() -> tuple[str, ...]:
    """The files of tests that hold properties."""
    return list_test_files("\n@given(")
