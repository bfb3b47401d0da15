"""`kinegrade doctor` says what is installed, what it is for, and how to get what is not."""

from __future__ import annotations

import shutil
import subprocess
import sys

import pytest

from kinegrade import __version__
from kinegrade.press import installation
from tests.small_class import kinegrade


def test_what_is_there_is_said_with_its_version() -> None:
    result = kinegrade("doctor")
    assert (result.exit_code, result.stderr) == (0, "")
    lines = dict(line.split(": ", 1) for line in result.stdout.splitlines())
    assert lines["kinegrade"] == f"{__version__} (for everything)"
    assert lines["Typst"].endswith(" (for papers, keys and sheets as PDF)")
    assert list(lines)[-1] == "room on the disk"


def test_what_few_need_is_no_fault(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(shutil, "which", lambda name: None)
    result = kinegrade("doctor")
    assert result.exit_code == 0
    assert "LaTeX: not there - only needed for papers by LaTeX (--engine latex) - install TeX" in (
        result.stdout
    )


def test_what_everyone_needs_is_a_fault(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(installation, "_ROOM", 10**12)
    result = kinegrade("doctor")
    assert result.exit_code == 1
    assert "room on the disk: MISSING - needed for exam folders - free 500 MB" in result.stdout


def test_it_speaks_the_language_of_the_terminal(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("LC_ALL", "zh_CN.UTF-8")
    assert "（生成 PDF 试卷、答案和单页）" in kinegrade("doctor").stdout


def test_shells_complete_commands_and_options(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("_KINEGRADE_COMPLETE", "bash_complete")
    monkeypatch.setenv("COMP_WORDS", "kinegrade list --di")
    monkeypatch.setenv("COMP_CWORD", "2")
    run = subprocess.run(
        [sys.executable, "-c", "from kinegrade.cli import main; main(prog_name='kinegrade')"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.stdout == "plain,--difficulty\n"
