"""An exam that another command replaces while it is read is not called damaged, and nothing is made
of half of each; through the command line.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.exam.generating.growing import adding
from kinegrade.exam.handing_out import handout
from kinegrade.exam.printing import reprint
from tests.exam.test_spare_papers import CHANGED
from tests.small_class import contents, generate, kinegrade, write_short_class


@pytest.fixture
def exam(tmp_path: Path) -> Path:
    """An exam that has two spare papers."""
    folder = write_short_class(tmp_path)
    assert generate(folder, "EXAM", "--spare", "2").exit_code == 0
    return folder / "EXAM"


def assign_before(
    exam: Path, monkeypatch: pytest.MonkeyPatch, function: Callable[..., Any]
) -> Callable[..., Any]:
    """The function, before which another command assigns a spare paper."""
    code = open_exam(exam).head.spares[1].paper

    def come_second(*arguments: Any) -> Any:
        monkeypatch.undo()
        assert kinegrade("assign", exam, code, "5001").exit_code == 0
        return function(*arguments)

    return come_second


def test_a_class_that_grows_meanwhile_is_not_called_damaged(
    exam: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "late.csv").write_text("student,name\n0099,Dora\n", encoding="utf-8")
    come_second = assign_before(exam, monkeypatch, adding.read_replaced)
    monkeypatch.setattr(adding, "read_replaced", come_second)
    files = tmp_path / "bank.toml", tmp_path / "roster.csv"
    odd = "--allow-odd-ids", "--add", tmp_path / "late.csv"
    result = kinegrade("generate", *files, "-o", exam, *odd)
    assert (result.exit_code, result.stderr) == (2, f"error: {exam}: {CHANGED}\n")
    assert "5001" in open_exam(exam).students
    assert kinegrade("generate", *files, "-o", exam, *odd).exit_code == 0


@pytest.mark.parametrize("function", ["list_files", "read_paper"])
def test_of_an_exam_that_was_replaced_no_paper_is_copied(
    exam: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, function: str
) -> None:
    come_second = assign_before(exam, monkeypatch, getattr(handout, function))
    monkeypatch.setattr(handout, function, come_second)
    result = kinegrade("papers", exam, "-o", tmp_path / "OUT")
    assert (result.exit_code, result.stderr) == (2, f"error: {exam}: {CHANGED}\n")
    assert not (tmp_path / "OUT").exists()
    assert kinegrade("papers", exam, "-o", tmp_path / "OUT").exit_code == 0
    assert "5001.pdf" in contents(tmp_path / "OUT")


def test_a_file_is_not_written_of_an_exam_that_was_replaced(
    exam: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Nothing that it reads is missing: what it makes is the old paper of another exam."""
    monkeypatch.setattr(reprint, "reprint", assign_before(exam, monkeypatch, reprint.reprint))
    out = tmp_path / "007.pdf"
    result = kinegrade("paper", exam, "007", "-o", out)
    assert (result.exit_code, result.stderr) == (2, f"error: {exam}: {CHANGED}\n")
    assert not out.exists()
