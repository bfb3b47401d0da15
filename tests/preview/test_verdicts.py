"""A box of the preview says of an answer what `kinegrade grade` says of it."""

from __future__ import annotations

import csv
from pathlib import Path

import kinegrade as api
from kinegrade.grading.verdict_names import name_verdict
from kinegrade.language import ENGLISH
from kinegrade.language.catalogue import open_catalogue
from kinegrade.preview.parts import Shown, write_part, write_verdict
from kinegrade.preview.subject import read_subjects
from kinegrade.preview.verdict import judge_typed
from tests.small_class import kinegrade, table

BANK = """title = "Sheet"
course = "Mechanics"
date = 2026-05-01
tolerance = { relative = "1 %" }

[[questions]]
template = "slider-crank"
same = true
draw = { r = [1], k = ["sqrt(3)"], phi = [60], omega = [1], alpha = [0] }
asks = { v_B = 3, omega_AB = 2 }
"""
TYPED = {
    "v_B": ["1.1547", "1,1547 m/s", "115.5 cm/s", "2/sqrt(3)", "1.167", "-1.1547", "1.1547 kg"],
    "omega_AB": ["0.3333", "1/3 rad/s", "0.577", "0.333 clockwise", "abc", "-0.3333", "1e400"],
}


def grade(folder: Path) -> dict[tuple[str, str], str]:
    """What marking says of each answer: the verdict in words, and why."""
    (folder / "bank.toml").write_text(BANK, encoding="utf-8")
    students = "".join(f"s{number},Ann\n" for number in range(sum(map(len, TYPED.values()))))
    (folder / "roster.csv").write_text(f"student,name\n{students}", encoding="utf-8")
    files = folder / "bank.toml", folder / "roster.csv"
    assert kinegrade("generate", *files, "-o", folder / "EXAM").exit_code in (0, 1)
    rows = table(folder / "EXAM" / "answers.csv")
    with (folder / "answers.csv").open("w", encoding="utf-8", newline="") as sheet:
        writer = csv.DictWriter(sheet, rows[0])
        writer.writeheader()
        for row, typed in zip(rows, list_typed(), strict=True):
            writer.writerow({**row, **typed})
    answers = folder / "answers.csv"
    kinegrade("grade", folder / "EXAM", answers, "-o", folder / "MARKS", "--own-papers")
    words = open_catalogue(ENGLISH)
    return {
        (each.ask, each.typed): " ".join((words.write(name_verdict(each.verdict)), each.reason))
        for each in api.open_marks(folder / "MARKS").answers()
    }


def list_typed() -> list[dict[str, str]]:
    """What each student answers: one text of `TYPED`, and the truth to the other ask, so that
    nothing follows from a wrong answer.
    """
    return [
        {**{f"q1.{other}": texts[0] for other, texts in TYPED.items()}, f"q1.{ask}": text}
        for ask, texts in TYPED.items()
        for text in texts
    ]


def test_boxes_say_what_marking_says(tmp_path: Path) -> None:
    marked = grade(tmp_path)
    (subject,) = read_subjects(tmp_path / "bank.toml")
    for (ask, typed), said in marked.items():
        verdict, *rest = judge_typed(subject, ask, typed, ENGLISH)
        assert said.startswith(" ".join([verdict, *rest[:1]])), typed
    assert len({said.split()[0] for said in marked.values()}) >= 4


def test_a_known_mistake_is_told_in_a_sentence(tmp_path: Path) -> None:
    (tmp_path / "bank.toml").write_text(BANK, encoding="utf-8")
    (subject,) = read_subjects(tmp_path / "bank.toml")
    *_, sentence = judge_typed(subject, "omega_AB", "0.57735", ENGLISH)
    assert sentence.endswith(".")


def test_nothing_is_said_of_what_is_not_asked(tmp_path: Path) -> None:
    bank = tmp_path / "bank.toml"
    bank.write_text(BANK, encoding="utf-8")
    assert write_verdict(Shown(bank, 0, ENGLISH), "a_B", "1").strip() == ""


def test_a_text_that_was_typed_is_no_tag(tmp_path: Path) -> None:
    bank = tmp_path / "bank.toml"
    bank.write_text(BANK, encoding="utf-8")
    said = write_verdict(Shown(bank, 0, ENGLISH), "v_B", "<img src=x>")
    assert "unreadable" in said
    assert "<img" not in said


def test_a_verdict_on_a_faulty_file_says_what_is_wrong(tmp_path: Path) -> None:
    bank = tmp_path / "bank.toml"
    bank.write_text(BANK.replace("slider-crank", "slider-krank"), encoding="utf-8")
    assert "slider-krank" in write_verdict(Shown(bank, 0, ENGLISH), "v_B", "1")
    assert write_part("problem", Shown(bank, 0, ENGLISH)).count("<li>") == 1
