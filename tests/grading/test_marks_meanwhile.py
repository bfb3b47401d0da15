"""Marks that another command replaces while they are read: nothing is made of half of each, and
none is called damaged; through the command line.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from kinegrade.marks_folder import folder as marks_folder
from tests.exam.test_spare_papers import CHANGED
from tests.small_class import generate, kinegrade, write_short_class


@pytest.fixture
def marks(tmp_path: Path) -> Path:
    """The marks of a small class."""
    write_short_class(tmp_path)
    assert generate(tmp_path).exit_code == 0
    grade(tmp_path, "1")
    return tmp_path / "MARKS"


def grade(folder: Path, answer: str) -> None:
    """Mark the class, everybody's first answer being this one."""
    sheet = folder / "EXAM" / "answers.csv"
    rows = sheet.read_text(encoding="utf-8-sig").replace(",,", f",{answer},", 1)
    (folder / "answers.csv").write_text(rows, encoding="utf-8")
    files = folder / "EXAM", folder / "answers.csv", "-o", folder / "MARKS"
    kinegrade("grade", *files, "--force")


@pytest.mark.parametrize(
    "words",
    [
        ("report", "EXAM", "MARKS", "-o", "report.html"),
        ("export", "MARKS", "--to", "moodle", "-o", "moodle.csv"),
        ("feedback", "EXAM", "MARKS", "-o", "FEEDBACK", "--format", "md"),
    ],
    ids=lambda words: words[0],
)
def test_of_marks_that_were_replaced_nothing_is_made(
    marks: Path, monkeypatch: pytest.MonkeyPatch, words: tuple[str, ...]
) -> None:
    read = marks_folder.read_totals

    def come_second(*arguments: Any) -> Any:
        monkeypatch.setattr(marks_folder, "read_totals", read)
        grade(marks.parent, "2")
        return read(*arguments)

    second: Callable[..., Any] = come_second
    monkeypatch.setattr(marks_folder, "read_totals", second)
    monkeypatch.chdir(marks.parent)
    result = kinegrade(*words)
    assert (result.exit_code, result.stderr) == (2, f"error: MARKS: {CHANGED}\n")
    assert not (marks.parent / words[words.index("-o") + 1]).exists()
    assert kinegrade(*words).exit_code in (0, 1)


def test_marks_that_are_marked_again_are_not_called_replaced(marks: Path) -> None:
    grade(marks.parent, "2")
    sheet = marks.parent / "EXAM", marks.parent / "answers.csv"
    again = kinegrade("grade", *sheet, "-o", marks, "--force")
    assert again.exit_code in (0, 1), again.stderr
    assert "changed while" not in again.stderr
