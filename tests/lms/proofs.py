"""What proves the grade file of a system: a golden file, and a module with its traps."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

TESTS = Path(__file__).parent.parent


def find_unproved(systems: Iterable[str], tests: Path) -> list[str]:
    """What is missing in a folder of tests, a line for each file."""
    needed = [
        tests / place
        for name in systems
        for place in (f"golden/lms/{name}.csv", f"lms/test_{name}.py")
    ]
    return [f"{file.relative_to(tests)}: missing" for file in needed if not file.exists()]
