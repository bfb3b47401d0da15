"""Before the exam: rows 1 to 7 and 12 of the term, and the help of row 25."""

from __future__ import annotations

import shutil
import tomllib
from collections.abc import Callable, Sequence
from fractions import Fraction
from pathlib import Path

import pytest

from tests.printed_text import read_text
from tests.small_class import key_lines, kinegrade
from tests.term.banks import QUESTION, write_bank
from tests.term.people import (
    CLASS,
    Person,
    people,
    write_chinese,
    write_gradebook,
    write_participants,
    write_registrar,
)

HEAD = 'title = "Quiz"\ncourse = "Mechanics"\n'
SVG = '<svg xmlns="http://www.w3.org/2000/svg" width="20" height="20"><path d="M0 0H20V20z"/></svg>'


def sample(folder: Path, bank: str, *options: str) -> str:
    """The text of a first proof of a bank."""
    proof = folder / "proof.pdf"
    result = kinegrade("sample", write_bank(folder, bank), "-o", proof, "--force", *options)
    assert result.exit_code == 0, result.stderr
    return read_text(proof)


def generate(folder: Path, bank: str) -> tuple[Path, str]:
    """An exam of four students, and what was said."""
    roster = write_participants(folder / "roster.csv", people(4))
    exam = folder / "EXAM"
    result = kinegrade("generate", write_bank(folder, bank), roster, "-o", exam, "--jobs", "1")
    assert result.exit_code == 0, result.stderr
    return exam, result.stderr


def test_row_1_problems_are_chosen_by_what_they_need_and_how_hard_they_are() -> None:
    wishes = "--asks", "coriolis", "--difficulty", "2..3", "--without-joint", "mesh"
    listed = kinegrade("list", *wishes)
    assert listed.exit_code == 0, listed.stderr
    lines = [line.split("\t") for line in listed.output.splitlines()]
    assert len(lines) > 3
    for _, _, title, difficulty, minutes, tags in lines:
        assert title
        assert difficulty in "23"
        assert int(minutes) > 0
        assert "coriolis" in tags.split()
    assert "coriolis" in kinegrade("list", "--tags").output
    shown = kinegrade("show", lines[0][0]).output
    assert "coriolis" in shown
    assert "\\frac" not in shown


def test_row_2_a_bank_begins_with_a_starter_that_can_be_printed(tmp_path: Path) -> None:
    bank = tmp_path / "own.toml"
    assert kinegrade("new", "own", "--bank", "-o", bank).exit_code == 0
    text = bank.read_text(encoding="utf-8")
    assert len(tomllib.loads(text)["questions"]) >= 3
    assert "Kinematics midterm" in sample(tmp_path, text)


def test_row_3_papers_have_a_header(tmp_path: Path) -> None:
    (tmp_path / "crest.svg").write_text(SVG, encoding="utf-8")
    header = (
        '[header]\ninstitution = "University of Ulm"\nlogo = "crest.svg"\nduration = "90 minutes"\n'
        'aids = "calculator"\ninstructions = "Show your working."\n'
    )
    text = sample(tmp_path, f"{HEAD}{header}{QUESTION}asks = {{ v_B = 1 }}\n")
    for stated in ("University of Ulm", "90 minutes", "calculator", "Show your working."):
        assert stated in text


def test_row_4_numbers_are_restricted_and_what_that_costs_is_said(tmp_path: Path) -> None:
    entries = (
        f"{QUESTION}asks = {{ v_B = 1 }}\ndraw = {{ phi = [30, 45, 60], k = 2 }}\n"
        f"{QUESTION}asks = {{ a_B = 1 }}\nsame = true\n"
        f"{QUESTION}asks = {{ omega_AB = 1 }}\n"
        "draw = { phi = 30, k = 2, r = 1, omega = [2, 3], alpha = 5 }\nrepeats = true\n"
    )
    exam, said = generate(tmp_path, f"{HEAD}{entries}")
    first, second, _ = zip(*(line["questions"] for line in key_lines(exam)), strict=True)
    assert {each["drawn"]["phi"] for each in first} <= {"30", "45", "60"}
    assert {each["drawn"]["k"] for each in first} == {"2"}
    assert len({str(each["drawn"]) for each in second}) == 1
    assert "q2: everybody has the same numbers" in said
    assert "q3: 2 sets of numbers for 4 students" in said


def test_row_4_two_templates_share_a_slot(tmp_path: Path) -> None:
    entry = '\n[[questions]]\nany = ["slider-crank", "bent-rod-two-sleeves"]\npoints = 6\n'
    exam, _ = generate(tmp_path, f'{HEAD}{entry}asks = "velocity"\n')
    held = [[each["question"] for each in line["questions"]] for line in key_lines(exam)]
    assert sorted(held) == [["q1a"], ["q1a"], ["q1b"], ["q1b"]]


def test_row_5_numbers_without_a_mechanism_are_asked_in_a_few_lines(tmp_path: Path) -> None:
    own = """
[[questions]]
name = "car-from-rest"
title = "A car that starts"
statement = "A car starts from rest with {{ a }}. How fast is it after {{ t }}?"
parameters.a = { unit = "m/s^2", draw = ["3/2", 2, "5/2"] }
parameters.t = { unit = "s", draw = "4 .. 12 step 1" }
steps.v = "a*t"
asks.v = { unit = "m/s", points = 3, means = "its speed" }
"""
    exam, _ = generate(tmp_path, f"{HEAD}{own}")
    for [question] in (line["questions"] for line in key_lines(exam)):
        acceleration, time = (Fraction(question["drawn"][name]) for name in "at")
        assert Fraction(question["asks"]["v"]["exact"]) == acceleration * time


def test_row_5_a_theory_question_stands_beside_the_others(tmp_path: Path) -> None:
    theory = '\n[[questions]]\ntext = "What is a pole?"\npoints = 5\nspace = "6 cm"\n'
    text = sample(tmp_path, f"{HEAD}{QUESTION}asks = {{ v_B = 1 }}\n{theory}")
    assert "What is a pole?" in text
    assert "5 points" in text


def test_row_6_room_for_working_and_german(tmp_path: Path) -> None:
    bank = (
        'title = { en = "Quiz", de = "Klausur" }\ncourse = { en = "Mechanics", de = "Mechanik" }\n'
        'space = "4 cm"\n[[questions]]\ntemplate = "bar-through-swivelling-sleeve"\n'
        "asks = { omega_AB = 3 }\n"
    )
    text = sample(tmp_path, bank, "--lang", "de")
    assert "Klausur" in text
    assert "Punkte" in text
    assert "Seite 1 von 1" in text
    again = bank.partition("[[questions]]")[2]
    much = bank.replace("4 cm", "14 cm") + f"[[questions]]{again}"
    assert "Seite 1 von 2" in sample(tmp_path, much, "--lang", "de")


@pytest.mark.parametrize(
    ("write", "name"),
    [
        (write_registrar, "list.xlsx"),
        (write_participants, "participants.csv"),
        (write_gradebook, "gradebook.csv"),
        (write_chinese, "roster.csv"),
    ],
)
def test_row_7_rosters_are_read_as_they_come_and_said(
    tmp_path: Path, write: Callable[[Path, Sequence[Person]], Path], name: str
) -> None:
    class_ = people()
    result = kinegrade("roster", write(tmp_path / name, class_))
    first = f'{name}: {CLASS} students, the first "{class_[0].student}" {class_[0].name}'
    assert first in result.stdout
    assert f"{name}: read as student from" in result.stdout
    encoding = "read as GB18030; look at the names" if write is write_chinese else ""
    assert encoding in result.stderr
    assert len(result.stderr.splitlines()) == bool(encoding)


def test_row_7_a_column_is_named_where_its_header_does_not_tell(tmp_path: Path) -> None:
    roster = tmp_path / "odd.csv"
    roster.write_text("Code,Who\n007,Ada\n", encoding="utf-8")
    assert kinegrade("roster", roster).exit_code == 2
    wishes = "--column", "student=Code", "--column", "name=Who"
    assert kinegrade("roster", roster, *wishes).exit_code == 0


def test_row_25_what_is_misspelt_gets_a_few_suggestions(tmp_path: Path) -> None:
    said = kinegrade("show", "slider-cranc").stderr
    assert 'did you mean "slider-crank"' in said
    bank = write_bank(tmp_path, f"{HEAD}{QUESTION}asks = {{ v_b = 1 }}\n")
    said = kinegrade("sample", bank, "-o", tmp_path / "proof.pdf").stderr
    assert 'did you mean "v_B"' in said
    assert said.count('"') <= 8


def test_row_25_curly_quotes_are_named(tmp_path: Path) -> None:
    bank = write_bank(tmp_path, f"{HEAD}{QUESTION}asks = {{ v_B = 1 }}\n".replace('"', "”"))
    (said,) = kinegrade("sample", bank, "-o", tmp_path / "proof.pdf").stderr.splitlines()
    assert "bank.toml:1" in said
    assert "straight" in said


def test_row_25_files_of_windows_are_read(tmp_path: Path) -> None:
    text = f"{HEAD}{QUESTION}asks = {{ v_B = 1 }}\n"
    bank = write_bank(tmp_path, text)
    bank.write_bytes(b"\xef\xbb\xbf" + text.replace("\n", "\r\n").encode())
    assert kinegrade("sample", bank, "-o", tmp_path / "proof.pdf").exit_code == 0


def test_row_25_swapped_folders_are_named(small_class: Path, tmp_path: Path) -> None:
    exam = Path(shutil.copytree(small_class / "EXAM", tmp_path / "EXAM"))
    assert kinegrade("grade", exam, exam / "answers.csv", "-o", tmp_path / "MARKS").exit_code < 2
    (said,) = kinegrade(
        "feedback", tmp_path / "MARKS", exam, "-o", tmp_path / "F"
    ).stderr.splitlines()
    assert "MARKS" in said
    assert "EXAM" in said
    assert "No such file" not in said


def test_row_12_a_practice_sheet_takes_answers_and_holds_its_keys(tmp_path: Path) -> None:
    bank = write_bank(tmp_path, f"{HEAD}{QUESTION}asks = {{ v_B = 1 }}\n")
    page = tmp_path / "practice.html"
    made = kinegrade("practice", bank, "-o", page, "--draws", "2")
    assert made.exit_code == 0, made.stderr
    assert "for practice only" in made.stderr
    assert '<input type="text"' in page.read_text(encoding="utf-8")
