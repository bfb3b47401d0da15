"""A recipe of CONTRIBUTING, followed on a copy of the package: its steps are read from there."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from pathlib import Path

import kinegrade

PACKAGE = Path(kinegrade.__file__).parent
_CONTRIBUTING = PACKAGE.parent / "CONTRIBUTING.md"
_STEP = re.compile(r"^\d+\. \*\*(.+?)\.\*\* ", re.MULTILINE)


@dataclass(frozen=True)
class Step:
    """A step: its title, what does it in a copy, what is then said without it, and where that is
    said: what runs into the lack, and gives its words.
    """

    title: str
    do: Callable[[Path], None]
    refused: str
    ask: Callable[[Path], str]


def read_titles(heading: str) -> list[str]:
    """The titles of the numbered steps under a heading of CONTRIBUTING."""
    text = _CONTRIBUTING.read_text(encoding="utf-8")
    (section,) = re.findall(rf"^#+ {re.escape(heading)}\n(.*?)(?=^#|\Z)", text, re.M | re.S)
    return _STEP.findall(section)


def copy_package(folder: Path) -> Path:
    """A folder with a copy of the package, as it is; what is compiled is good for files as old."""
    folder.mkdir(parents=True, exist_ok=True)
    shutil.copytree(PACKAGE, folder / "kinegrade")
    return folder


def follow_steps(folder: Path, steps: Iterable[Step], missing: Step | None = None) -> Path:
    """A copy of the package in which all steps were done, but the one that is missing."""
    room = copy_package(folder)
    for step in steps:
        if step != missing:
            step.do(room)
    return room


def run(folder: Path, *arguments: object, **environment: str) -> subprocess.CompletedProcess[str]:
    """kinegrade as the copy in the folder has it."""
    return run_python(folder, "-m", "kinegrade", *arguments, **environment)


def run_python(
    folder: Path, *arguments: object, **environment: str
) -> subprocess.CompletedProcess[str]:
    """Python, with the package as the copy in the folder has it."""
    return subprocess.run(
        [sys.executable, *map(str, arguments)],
        cwd=folder,
        env={**os.environ, "PYTHONPATH": str(folder), "TMPDIR": str(folder), **environment},
        capture_output=True,
        text=True,
        check=False,
    )


def edit(file: Path, *changes: tuple[str, str]) -> None:
    """Replace texts of a file, each of which stands in it once."""
    text = file.read_text(encoding="utf-8")
    for old, new in changes:
        if text.count(old) != 1:
            raise AssertionError(f"{file}: {old!r} stands there {text.count(old)} times")
        text = text.replace(old, new)
    file.write_text(text, encoding="utf-8")
