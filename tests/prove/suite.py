"""Tests of the suite, run by a proof as `make test` does not: with the profile of `make prove`."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parent.parent.parent


def run_tests(file: str, *options: str) -> None:
    """Run the tests of a file with these options of pytest. Raises AssertionError with the names of
    those that fail.
    """
    arguments = ("-n", "0", "-p", "no:cacheprovider", "--hypothesis-profile=prove", *options)
    done = subprocess.run(
        [sys.executable, "-m", "pytest", *arguments, file],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
    )
    failed = [line for line in done.stdout.splitlines() if line.startswith(("FAILED", "ERROR"))]
    assert done.returncode == 0, "; ".join(failed) or done.stdout[-300:] + done.stderr[-300:]


def list_test_files(text: str) -> tuple[str, ...]:
    """The files of tests in which a text stands."""
    return tuple(
        path.relative_to(ROOT).as_posix()
        for path in sorted((ROOT / "tests").rglob("test_*.py"))
        if text in path.read_text(encoding="utf-8")
    )
