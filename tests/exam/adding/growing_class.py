"""A class whose exam grows: its files, and what is typed to add late students to it."""

from __future__ import annotations

import json
from pathlib import Path

from click.testing import Result

from tests.printed_text import read_pages
from tests.problem.crank import crank_text
from tests.small_class import contents, key_lines, kinegrade

BANK = """title = {{ en = "Quiz", zh = "小测" }}
course = "Mechanics"
{options}
[[questions]]
template = "slider-crank"
asks = {{ v_B = 3, omega_AB = 2 }}
[[questions]]
template = "crank.toml"
draw = {{ h = [1], r = "1 .. 5 step 1", omega = "1 .. 4 step 1" }}
"""
WORDS = ("--reproducible", "spring")
LATE = {"late1": "Li, Late", "=2": "=Later"}
REWRITTEN = {
    "answers.csv",
    "answers.xlsx",
    "exam.json",
    "key.jsonl",
    "key.npz",
    "key.pdf",
    "papers.pdf",
    "solutions.pdf",
}


def roster(students: dict[str, str]) -> str:
    rows = "".join(f'{student},"{name}"\n' for student, name in students.items())
    return f"student,name\n{rows}"


CLASS = {"s0": "Ann", "a/b": "王伟", "s2": "Zoë"}


def write(folder: Path, options: str = "", students: dict[str, str] = CLASS) -> Path:
    (folder / "bank.toml").write_text(BANK.format(options=options), encoding="utf-8")
    (folder / "crank.toml").write_text(crank_text(), encoding="utf-8")
    (folder / "roster.csv").write_text(roster(students), encoding="utf-8")
    (folder / "late.csv").write_text(roster(LATE), encoding="utf-8")
    return folder


def generate(folder: Path, *options: str | Path) -> Result:
    files = folder / "bank.toml", folder / "roster.csv"
    return kinegrade("generate", *files, "-o", folder / "EXAM", "--allow-odd-ids", *options)


def generated(folder: Path, *options: str | Path) -> Path:
    result = generate(folder, *options)
    assert result.exit_code == 0, result.stderr
    return folder


def add(folder: Path, *options: str | Path, late: str = "late.csv") -> Result:
    return generate(folder, "--add", folder / late, *options)


def added(folder: Path, *options: str | Path) -> Result:
    result = add(folder, *options)
    assert result.exit_code == 0, result.stderr
    return result


def refused(folder: Path, *options: str | Path) -> list[str]:
    """The lines of the refusal; all stays as it was."""
    before = contents(folder)
    result = add(folder, *options)
    assert (result.exit_code, result.stdout) == (2, "")
    assert contents(folder) == before
    lines = result.stderr.splitlines()
    assert [line for line in lines if not line.startswith("error: ")] == []
    return [line.removeprefix("error: ").replace(f"{folder}/", "") for line in lines]


def pages(file: Path) -> list[str]:
    return read_pages(file)


def drawn(folder: Path, question: int) -> list[str]:
    return [json.dumps(line["questions"][question]["drawn"]) for line in key_lines(folder / "EXAM")]
