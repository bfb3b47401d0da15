"""A key has one line for each student: every command that goes through it refuses any other, in the
same words.
"""

from __future__ import annotations

import json
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from tests.problem.crank import crank_text
from tests.small_class import contents, kinegrade

BANK = """title = "T"
course = "C"
[[questions]]
template = "crank.toml"
draw = { h = [1], r = "1 .. 5 step 1", omega = "1 .. 4 step 1" }
"""
RESTORE = "restore the exam folder as it was generated"
TWICE = f'student "1" appears 2 times - expected once - {RESTORE}'
LACKING = f'no line for student "2" - expected one - {RESTORE}'
STRANGER = f'student "9" is not in exam.json - expected only its students - {RESTORE}'
Damage = Callable[[list[str]], list[str]]


@pytest.fixture(scope="module")
def marked(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with EXAM and MARKS of three students."""
    folder = tmp_path_factory.mktemp("class")
    (folder / "roster.csv").write_text("student,name\n1,Ann\n2,Bob\n3,Cid\n", encoding="utf-8")
    (folder / "bank.toml").write_text(BANK, encoding="utf-8")
    (folder / "crank.toml").write_text(crank_text(), encoding="utf-8")
    assert kinegrade(*generate(folder)).exit_code == 0
    answers = folder / "answers.csv"
    answers.write_text("student,q1.v_x\n1,-2\n2,5\n3,-4\n", encoding="utf-8")
    assert kinegrade("grade", folder / "EXAM", answers, "-o", folder / "MARKS").exit_code == 0
    return folder


@pytest.fixture
def place(marked: Path, tmp_path: Path) -> Path:
    return Path(shutil.copytree(marked, tmp_path / "class"))


def generate(place: Path) -> tuple[str | Path, ...]:
    files = place / "bank.toml", place / "roster.csv"
    return ("generate", *files, "-o", place / "EXAM")


def commands(place: Path) -> dict[str, tuple[str | Path, ...]]:
    exam, marks, out = place / "EXAM", place / "MARKS", place / "OUT"
    return {
        "quiz": ("quiz", exam, "--to", "moodle-xml", "-o", out),
        "pool": ("quiz", exam, "--to", "moodle-xml", "--variants", "2", "-o", out),
        "grade": ("grade", exam, exam / "answers.csv", "-o", out),
        "sharing": ("sharing", exam, marks, "-o", out),
        "feedback": ("feedback", exam, marks, "--format", "md", "-o", out),
        "report": ("report", exam, marks, "-o", out),
        "generate": (*generate(place), "--force"),
    }


def repeat(lines: list[str]) -> list[str]:
    """The first student has the line of the third, too."""
    return [*lines, json.dumps({**json.loads(lines[2]), "student": "1"})]


def remove(lines: list[str]) -> list[str]:
    return [lines[0], lines[2]]


def add(lines: list[str]) -> list[str]:
    return [*lines, json.dumps({**json.loads(lines[0]), "student": "9"})]


WHOLE_CLASS = ("quiz", "pool", "grade", "sharing", "generate")
EVERY = (*WHOLE_CLASS, "feedback", "report")


@pytest.mark.parametrize(
    ("command", "damage", "said"),
    [
        *((command, repeat, TWICE) for command in EVERY),
        *((command, remove, LACKING) for command in WHOLE_CLASS),
        *((command, add, STRANGER) for command in WHOLE_CLASS),
    ],
)
def test_lines_that_are_not_one_for_each_student_are_refused(
    place: Path, command: str, damage: Damage, said: str
) -> None:
    key = place / "EXAM" / "key.jsonl"
    lines = key.read_text(encoding="utf-8").splitlines()
    key.write_text("\n".join(damage(lines)) + "\n", encoding="utf-8")
    result = kinegrade(*commands(place)[command])
    assert result.exit_code == 2
    (line,) = result.stderr.splitlines()
    assert line.startswith(f"error: {key}: {said}")
    assert not (place / "OUT").exists()


@pytest.mark.parametrize("command", EVERY)
def test_lines_in_another_order_are_taken(place: Path, command: str) -> None:
    key = place / "EXAM" / "key.jsonl"
    lines = key.read_text(encoding="utf-8").splitlines()
    key.write_text("\n".join(reversed(lines)) + "\n", encoding="utf-8")
    result = kinegrade(*commands(place)[command])
    assert result.exit_code < 2, result.stderr


def edit_unit(line: dict[str, Any]) -> None:
    line["questions"][0]["asks"]["v_x"]["unit"] = "kg"


def remove_question(line: dict[str, Any]) -> None:
    line["questions"] = []


@pytest.mark.parametrize("command", WHOLE_CLASS)
@pytest.mark.parametrize(
    ("edit", "said"),
    [
        (edit_unit, "q1.v_x: unit or points differ from exam.json - expected the same"),
        (remove_question, "the asks differ from exam.json in q1.v_x - expected the same"),
    ],
)
def test_asks_that_are_not_those_of_the_exam_are_refused(
    place: Path, command: str, edit: Callable[[dict[str, Any]], None], said: str
) -> None:
    rewrite_first(place, edit)
    result = kinegrade(*commands(place)[command])
    assert result.exit_code == 2
    (line,) = result.stderr.splitlines()
    assert f'/key.jsonl: line 1: student "1": {said} - {RESTORE}' in line
    assert not (place / "OUT").exists()


def test_a_paper_without_its_numbers_is_reported_with_the_others(place: Path) -> None:
    rewrite_first(place, lambda line: line["questions"][0].update(parameters={}))
    result = kinegrade(*commands(place)["report"])
    assert result.exit_code == 0, result.stderr
    assert (place / "OUT").exists()


def test_a_pool_that_cannot_be_written_leaves_the_exam_as_it_was(place: Path) -> None:
    (place / "OUT").write_text("mine", encoding="utf-8")
    before = contents(place / "EXAM")
    assert kinegrade(*commands(place)["pool"]).exit_code == 2
    assert contents(place / "EXAM") == before
    assert kinegrade(*commands(place)["pool"], "--force").exit_code < 2
    assert (place / "EXAM" / "variants.jsonl").exists()


def rewrite_first(place: Path, edit: Callable[[dict[str, Any]], None]) -> None:
    """Another first line of the key."""
    key = place / "EXAM" / "key.jsonl"
    first, *others = key.read_text(encoding="utf-8").splitlines()
    line = json.loads(first)
    edit(line)
    key.write_text("\n".join([json.dumps(line), *others]) + "\n", encoding="utf-8")
