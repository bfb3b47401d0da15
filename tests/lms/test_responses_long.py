"""Answers one below the other: by id or code, in any order, under the names that people have for
asks.
"""

from __future__ import annotations

from fractions import Fraction
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


@pytest.mark.parametrize("header", ["unit", "Einheit", "单位"])
def test_a_unit_beside_the_answer_is_read_with_it(
    folder: Path, tmp_path: Path, header: str
) -> None:
    value = Fraction(right(folder, "007", "q1.v_B")) * 100
    done = grade(
        folder,
        tmp_path,
        f"student,ask,answer,{header}\n007,1a,{float(value):.6g},cm/s\n0012,1a,5 m/s,m/s\n",
    )
    answers = {
        (row["student"], row["ask"]): row
        for row in table(tmp_path / "MARKS" / "marks.csv")
        if row["response"]
    }
    assert answers["007", "v_B"]["verdict"] == "right"
    assert answers["007", "v_B"]["response"] == f"{float(value):.6g} cm/s"
    assert answers["0012", "v_B"]["response"] == "5 m/s"
    assert "not an answer column" not in done.stderr


@pytest.mark.parametrize(
    ("answer", "unit", "response"),
    [
        ("5", "", "5"),
        ("5", "-", "5"),
        ("", "m/s", ""),
        ("5π/3", "cm/s", "5π/3 cm/s"),
        ("25 mm/s", "m/s", "25 mm/s m/s"),
        ("2", "kg", "2 kg"),
    ],
)
def test_unit_and_answer_are_joined_as_if_typed_so(
    folder: Path, tmp_path: Path, answer: str, unit: str, response: str
) -> None:
    grade(folder, tmp_path, f"student,ask,answer,unit\n007,1a,{answer},{unit}\n0012,1a,1,\n")
    (line,) = [
        row
        for row in table(tmp_path / "MARKS" / "marks.csv")
        if (row["student"], row["question"], row["ask"]) == ("007", "q1", "v_B")
    ]
    assert line["response"] == response
    refused = line["verdict"] in ("wrong unit", "unreadable")
    assert refused is (response in ("25 mm/s m/s", "2 kg"))


def test_what_is_no_unit_beside_an_answer_is_told_of(folder: Path, tmp_path: Path) -> None:
    done = grade(folder, tmp_path, "student,ask,answer,unit\n007,1a,2500,12\n")
    assert 'long.csv:2: unit: "12" is no unit' in done.stderr
    (line,) = [row for row in table(tmp_path / "MARKS" / "marks.csv") if row["response"]]
    assert line["response"] == "2500"


def test_columns_that_are_not_known_are_told_of_as_in_wide_sheets(
    folder: Path, tmp_path: Path
) -> None:
    text = "student,name,ask,answer,Dimension,,sure\n007,Bond,1a,1,cm,,\n0012,,1a,2,m,,\n"
    done = grade(folder, tmp_path, text)
    assert (
        "long.csv: Dimension: not an answer column of the exam, or its second one - "
        "ignored; its cells are kept here only"
    ) in done.stderr
    assert "long.csv: sure: not an answer column" in done.stderr
    assert done.stderr.count("not an answer column") == 2
