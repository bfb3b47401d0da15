"""An exam is set and marked: who types the key's answers, however spelt, gets full marks."""

from __future__ import annotations

import shutil
from pathlib import Path

from tests.prove.draws import seeded_template
from tests.small_class import asks_of, kinegrade, table
from tests.spellings import SPELLINGS, type_answers

ROSTER = "student,name\n007,王伟\nS9,Bo\n"
BANK = """title = "Round trip"
course = "Mechanics"
tolerance = "honest"
questions = [{ template = "{{first}}" }, { template = "{{second}}" }]
shuffle = true
"""


def hold(seed: int, folder: Path) -> None:
    """Set an exam of two templates, answer it in one spelling, and look at the grades."""
    place = folder / "round trip"
    place.mkdir()
    try:
        _make_and_mark(seed, place)
    finally:
        shutil.rmtree(place)


def _make_and_mark(seed: int, place: Path) -> None:
    names = [seeded_template(each).name for each in (seed, seed + 1)]
    bank = BANK.replace("{{first}}", names[0]).replace("{{second}}", names[1])
    (place / "bank.toml").write_text(bank, encoding="utf-8")
    (place / "roster.csv").write_text(ROSTER, encoding="utf-8")
    exam, answers, marks = place / "EXAM", place / "answers.csv", place / "MARKS"
    made = kinegrade(
        *("generate", place / "bank.toml", place / "roster.csv", "-o", exam),
        *("--reproducible", f"prove {seed}"),
    )
    assert made.exit_code == 0, made.stderr
    keys = asks_of(exam)
    spelling = list(SPELLINGS)[seed % len(SPELLINGS)]
    type_answers(exam, answers, lambda *box: SPELLINGS[spelling](keys[box]))
    marked = kinegrade("grade", exam, answers, "-o", marks)
    assert marked.exit_code == 0, f"{names}, {spelling}: {marked.stderr}"
    percents = [row["percent"] for row in table(marks / "grades.csv")]
    assert percents == ["100", "100"], f"{names}, {spelling}: {percents}"
