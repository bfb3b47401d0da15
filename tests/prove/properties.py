"""Every property of the suite, the laws of kinematics among them, at new examples of hypothesis.

A case is one file of tests. Their sample is the suite itself, which runs the same examples every
time.
"""

from __future__ import annotations

import subprocess
import sys
from functools import cache
from pathlib import Path

ROOT = Path(__file__).parent.parent.parent


def hold(seed: int, _: Path) -> None:
    """Run the properties of a file by that seed of hypothesis."""
    names = files()
    done = subprocess.run(
        [
            *(
                sys.executable,
                "-m",
                "pytest",
                "-n",
                "0",
                "-m",
                "hypothesis",
                "-p",
                "no:cacheprovider",
            ),
            *("--hypothesis-profile=prove", f"--hypothesis-seed={seed}", names[seed % len(names)]),
        ],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
    )
    failed = [line for line in done.stdout.splitlines() if line.startswith(("FAILED", "ERROR"))]
    assert done.returncode == 0, "; ".join(failed) or done.stdout[-300:] + done.stderr[-300:]


@cache
def files() -> tuple[str, ...]:
    """The files of tests that hold properties."""
    found = (ROOT / "tests").rglob("test_*.py")
    return tuple(
        path.relative_to(ROOT).as_posix()
        for path in sorted(found)
        if "\n@given(" in path.read_text(encoding="utf-8")
    )
