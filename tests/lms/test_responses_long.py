"""Answers one below the other: by id or code, in any order, under the names that people have for
asks.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from click.testing import Result

from kinegrade.exam.folder.exam_folder import open_exam
from tests.small_class import asks_of, generate, kinegrade, table, write_class


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A class with its exam; not to be changed."""
    made = write_class(tmp_path_factory.mktemp("long"))
    assert generate(made).exit_code == 0
    return made


def grade(folder: Path, out: Path, text: str) -> Result:
    """Mark a long table."""
    file = out / "long.csv"
    file.write_text(text, encoding="utf-8")
    return kinegrade("grade", folder / "EXAM", file, "-o", out / "MARKS", "--own-papers")


def right(folder: Path, student: str, column: str) -> str:
    """The right answer."""
    return str(asks_of(folder / "EXAM")[student, column]["decimal"])


def test_lines_of_a_student_are_gathered_whatever_names_them(folder: Path, tmp_path: Path) -> None:
    head = open_exam(folder / "EXAM").head
    code = head.candidates["007"].paper
    columns = head.columns
    names = ("1a", "q1.a_B", "2.v_x", "2b", "omega_AB", "Q3(b)")
    lines = [
        f"{code if number % 2 else '007'},{name},{right(folder, '007', column)}"
        for number, (name, column) in enumerate(zip(names, columns, strict=True))
    ]
    lines.insert(3, f"0012,1a,{right(folder, '0012', columns[0])}")
    done = grade(folder, tmp_path, "\n".join(["id,ask,answer", *lines[::-1]]) + "\n")
    assert "long.csv: taken for answers one below the other" in done.stderr
    totals = {row["student"]: row["total"] for row in table(tmp_path / "MARKS" / "grades.csv")}
    assert (totals["007"], totals["0012"]) == ("15.5", "3")


def test_lines_that_cannot_be_taken_are_named_one_by_one(folder: Path, tmp_path: Path) -> None:
    text = "student,question,ask,answer\n007,q1,v_B,1\n007,1,v_B,2\n007,q9,z,1\n007,q1,v_B,1\n8,1a,,1\n"
    done = grade(folder, tmp_path, text)
    assert done.exit_code == 1
    for said in (
        'long.csv:3: is "2" here and "1" at long.csv:2 - that at long.csv:2 counts',
        'long.csv:4: "q9.z" is no ask of the exam - not graded',
        'long.csv:6: student: no student "8" in the exam',
    ):
        assert said in done.stderr
    (line,) = [row for row in table(tmp_path / "MARKS" / "marks.csv") if row["response"]]
    assert (line["ask"], line["response"]) == ("v_B", "1")


def test_a_complaint_about_an_answer_names_its_own_line(folder: Path, tmp_path: Path) -> None:
    done = grade(folder, tmp_path, "student,ask,answer\n007,1a,1\n0012,1a,1\n007,q1.a_B,?\n")
    assert 'long.csv:4: q1.a_B: "?" is not a number' in done.stderr


def test_numbers_alone_are_refused_where_papers_are_shuffled(tmp_path: Path) -> None:
    made = write_class(tmp_path)
    bank = made / "bank.toml"
    bank.write_text("shuffle = true\n" + bank.read_text(encoding="utf-8"), encoding="utf-8")
    assert generate(made).exit_code == 0
    refused = grade(made, tmp_path, "student,ask,answer\n007,1a,1\n")
    assert refused.exit_code == 2
    assert (
        "long.csv: names questions by their numbers, and the papers are shuffled: a number is "
        "another question on each - expected names such as q1.v_B"
    ) in refused.stderr
    assert grade(made, tmp_path, "student,ask,answer\n007,q1a,1\n").exit_code in (0, 1)


def test_a_table_that_is_not_long_is_refused_as_such(folder: Path, tmp_path: Path) -> None:
    file = tmp_path / "wide.csv"
    file.write_text("student,q1.v_B\n007,1\n", encoding="utf-8")
    done = kinegrade("grade", folder / "EXAM", file, "-o", tmp_path / "M", "--from", "long")
    assert done.exit_code == 2
    assert (
        "wide.csv: no columns of students, asks and answers - expected columns such as student, "
        "ask, answer - name them so"
    ) in done.stderr


def test_headers_of_other_languages_are_known(folder: Path, tmp_path: Path) -> None:
    for number, header in enumerate(("Matrikelnummer;Frage;Antwort", "学号;小问;答案"), 1):
        place = tmp_path / str(number)
        place.mkdir()
        value = right(folder, "007", "q1.v_B")
        grade(folder, place, f"{header}\n007;1a;{value}\n")
        totals = {row["student"]: row["total"] for row in table(place / "MARKS" / "grades.csv")}
        assert totals["007"] == "3"
