"""A student who takes a crossed belt for an open one: the mistake is named, what follows counts."""

from __future__ import annotations

import csv
import json
from pathlib import Path

import pytest

from tests.small_class import generate, kinegrade

BANK = """title = "Belts"
course = "Mechanics"
[[questions]]
template = "crossed-belt-drive"
asks = { omega_II = 1, v_B = 2 }
draw = { omega1 = [9] }
"""
SENTENCES = {
    "en": "An open and a crossed belt were confused: the sense of rotation is reversed.",
    "de": "Offener und gekreuzter Riemen wurden verwechselt: Der Drehsinn ist umgekehrt.",
    "zh": "混淆了开口传动与交叉传动，转向取反了。",
}


@pytest.fixture
def marked(tmp_path: Path) -> Path:
    """A marked exam of one student, whose answers are those of an open belt."""
    (tmp_path / "bank.toml").write_text(BANK, encoding="utf-8")
    (tmp_path / "roster.csv").write_text("student,name\n1,Ann\n", encoding="utf-8")
    generate(tmp_path)
    key = json.loads((tmp_path / "EXAM/key.jsonl").read_text(encoding="utf-8"))
    asks = key["questions"][0]["asks"].values()
    answers = [ask["mistakes"]["belt-reversed"] for ask in asks]
    file = tmp_path / "EXAM" / "answers.csv"
    with file.open(encoding="utf-8-sig", newline="") as stream:
        header = next(csv.reader(stream))
    with file.open("w", encoding="utf-8", newline="") as stream:
        csv.writer(stream).writerows([header, ["1", "Ann", *answers]])
    result = kinegrade("grade", tmp_path / "EXAM", file, "-o", tmp_path / "MARKS")
    assert result.exit_code == 0, result.output
    return tmp_path


def test_the_mistake_is_named_and_what_follows_from_it_is_right(marked: Path) -> None:
    with (marked / "MARKS/marks.csv").open(encoding="utf-8-sig", newline="") as stream:
        first, second = csv.DictReader(stream)
    assert (first["verdict"], second["verdict"]) == ("mistake", "follow-through")
    assert (first["points"], second["points"]) == ("0", "2")


@pytest.mark.parametrize("language", SENTENCES)
def test_feedback_says_what_was_confused(marked: Path, language: str) -> None:
    folders = marked / "EXAM", marked / "MARKS"
    options = "--format", "md", "--lang", language
    kinegrade("feedback", *folders, "-o", marked / "OUT", *options)
    (sheet,) = (marked / "OUT").rglob("*.md")
    assert SENTENCES[language] in sheet.read_text(encoding="utf-8")
