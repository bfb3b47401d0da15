"""A class whose exam is generated: its files, what the folder must hold, and what a refusal says."""

from __future__ import annotations

from pathlib import Path

from tests.problem.crank import crank_text
from tests.small_class import (
    generate,
)

FILES = ["007.pdf", "0012.pdf", "a%2Fb.pdf", "%3D2.pdf"]
TOP = [
    "INSTRUCTOR-ONLY.txt",
    "answers.csv",
    "answers.xlsx",
    "bank.toml",
    "exam.json",
    "key.jsonl",
    "key.npz",
    "key.pdf",
    "papers",
    "papers.pdf",
    "templates",
]
SHORT = '[[questions]]\ntemplate = "crank.toml"\ndraw = { omega = [2, 3, 4] }\n'
NO_PANDOC = "pandoc not found - expected the optional extra - pip install 'kinegrade[word]'"


def refused(folder: Path, *options: str) -> list[str]:
    """The lines of the refusal; nothing may have been written."""
    before = sorted(entry.name for entry in folder.iterdir())
    result = generate(folder, "NEW", *options)
    assert result.exit_code == 2
    assert sorted(entry.name for entry in folder.iterdir()) == before
    lines = result.stderr.splitlines()
    assert lines
    assert [line for line in lines if not line.startswith("error: ")] == []
    return lines


def with_crank(folder: Path, bank: str, *changes: tuple[str, str]) -> None:
    (folder / "crank.toml").write_text(crank_text(*changes), encoding="utf-8")
    (folder / "bank.toml").write_text('title = "T"\ncourse = "C"\n' + bank, encoding="utf-8")


def with_nonsense(folder: Path) -> None:
    """The statement holds a command that no typesetter knows."""
    with_crank(folder, SHORT, ("above $O$.", r"above $\nonsense{O}$."))
