"""The bank, the roster and the key must be those of the exam that grows; what does not fit is
refused.
"""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

from tests.exam.adding.growing_class import (
    CLASS,
    LATE,
    WORDS,
    add,
    added,
    generate,
    generated,
    refused,
    roster,
    write,
)
from tests.small_class import contents, kinegrade


def test_the_bank_and_its_templates_must_be_those_of_the_exam(folder: Path) -> None:
    bank, crank = folder / "bank.toml", folder / "crank.toml"
    bank.write_text(bank.read_text(encoding="utf-8") + "\n# mine\n", encoding="utf-8")
    crank.write_text(crank.read_text(encoding="utf-8") + "\n# mine\n", encoding="utf-8")
    said = (
        "differs from what was given - expected the bank and the templates that the exam was "
        "generated from - give those, or write another exam"
    )
    assert refused(folder) == [f"EXAM/bank.toml: {said}", f"EXAM/templates/crank.toml: {said}"]


def test_an_exam_whose_shipped_template_another_version_has_otherwise_takes_late_students(
    folder: Path,
) -> None:
    copy = folder / "EXAM" / "templates" / "slider-crank.toml"
    earlier = f"{copy.read_text(encoding='utf-8')}# as an earlier version had it\n"
    copy.write_text(earlier, encoding="utf-8")
    said = added(folder).stderr
    assert (
        "the exam's copies hold of templates/slider-crank.toml, which differs from that of the "
        "installed kinegrade"
    ) in said
    assert copy.read_text(encoding="utf-8") == earlier
    assert (folder / "EXAM" / "papers" / "late1.pdf").exists()


def test_who_was_assigned_a_spare_paper_need_not_be_in_the_roster(tmp_path: Path) -> None:
    exam = generated(write(tmp_path), *WORDS, "--spare", "1") / "EXAM"
    code = json.loads((exam / "exam.json").read_text(encoding="utf-8"))["spares"][0]["paper"]
    assert kinegrade("assign", exam, code, "0099").exit_code == 0
    added(tmp_path)
    head = json.loads((exam / "exam.json").read_text(encoding="utf-8"))
    assert [each["student"] for each in head["students"]] == [*CLASS, "0099", *LATE]


def test_a_class_generated_again_needs_who_was_assigned_a_spare_paper_in_the_roster(
    tmp_path: Path,
) -> None:
    exam = generated(write(tmp_path), *WORDS, "--spare", "1") / "EXAM"
    code = json.loads((exam / "exam.json").read_text(encoding="utf-8"))["spares"][0]["paper"]
    assert kinegrade("assign", exam, code, "0099", "--name", "Dora").exit_code == 0
    result = generate(tmp_path, "--force")
    assert result.exit_code == 2
    assert "1 would be gone (0099)" in result.stderr
    assert "also who was assigned a spare paper or withdrew" in result.stderr
    key = (exam / "key.jsonl").read_text(encoding="utf-8")
    (tmp_path / "roster.csv").write_text(roster({**CLASS, "0099": "Dora"}), encoding="utf-8")
    generated(tmp_path, "--force")
    assert sorted((exam / "key.jsonl").read_text(encoding="utf-8").splitlines()) == sorted(
        key.splitlines()
    )


def test_a_bank_without_a_template_of_the_exam_is_refused(folder: Path) -> None:
    bank = folder / "bank.toml"
    text = bank.read_text(encoding="utf-8").replace('"crank.toml"', '"other.toml"')
    bank.write_text(text, encoding="utf-8")
    (folder / "crank.toml").rename(folder / "other.toml")
    lines = refused(folder)
    assert lines[0].startswith("EXAM/bank.toml: differs from what was given - ")
    assert lines[1].startswith("EXAM/templates: crank is not in the bank - expected the bank and")


def test_the_roster_must_be_that_of_the_exam(folder: Path) -> None:
    students = {"s0": "Anna", "s2": "Zoë", "new": "New"}
    (folder / "roster.csv").write_text(roster(students), encoding="utf-8")
    (folder / "late.csv").write_text(roster({"s2": "Zoë", "x": "X"}), encoding="utf-8")
    assert [line.replace("EXAM/exam.json", "HEAD") for line in refused(folder)] == [
        'roster.csv: no student "a/b" - expected everyone who has a paper in EXAM - add the line, '
        "or, where only the id has changed, use kinegrade exchange --new-id",
        'roster.csv:2: name "Anna" of student "s0" - expected "Ann", as in HEAD - correct the line',
        'roster.csv:4: student "new" has no paper in EXAM - expected the students of the exam - '
        "list late students in the file of --add alone",
        'late.csv:2: student "s2" (Zoë) has a paper in EXAM already - expected students without '
        "one - delete the line",
    ]


def test_an_id_that_would_rename_the_files_of_another_is_refused(tmp_path: Path) -> None:
    folder = generated(write(tmp_path, students={"S0": "Ann", "s2": "Zoë"}), *WORDS)
    (folder / "late.csv").write_text(roster({"s0": "Bob", "S2": "Tom"}), encoding="utf-8")
    assert refused(folder) == [
        'late.csv: an id differs from "S0" in capitals alone, so that their files would be one - '
        "expected ids that differ in more - correct the id, or write the exam again with --force "
        "and a roster of all"
    ]
    (folder / "late.csv").write_text(roster({"S2": "Tom"}), encoding="utf-8")
    added(folder)
    assert (folder / "EXAM" / "papers" / "%532.pdf").exists()


def test_a_folder_that_is_no_exam_is_refused(tmp_path: Path) -> None:
    (line,) = refused(write(tmp_path))
    assert line.startswith("EXAM/exam.json: cannot be read (No such file or directory) - ")


@pytest.mark.parametrize(
    "option", ["--new-numbers", "--lang=en", "--solutions", "--seed=x", "--engine=typst"]
)
def test_what_the_exam_says_is_not_said_again(folder: Path, option: str) -> None:
    before = contents(folder)
    result = add(folder, option)
    assert result.exit_code == 2
    name = option.partition("=")[0].replace("--no-s", "--s")
    assert f"--add makes papers like those of EXAM: leave out {name}\n" in result.stderr
    assert contents(folder) == before


@pytest.mark.parametrize("name", ["papers.pdf", "solutions.pdf"])
def test_a_book_that_is_missing_is_refused(folder: Path, name: str) -> None:
    assert kinegrade("solutions", folder / "EXAM").exit_code == 0
    (folder / "EXAM" / name).unlink()
    (line,) = refused(folder)
    assert line.startswith(f"EXAM/{name}: is missing - expected the {name[:-4]} of all students")


def test_a_key_that_says_otherwise_is_refused(folder: Path) -> None:
    key = folder / "EXAM" / "key.jsonl"
    text = key.read_text(encoding="utf-8")
    key.write_text(re.sub(r'"decimal": ?"', '"decimal": "123', text, count=1), encoding="utf-8")
    (line,) = refused(folder)
    assert "decimal, value state different numbers - expected the same one" in line


def test_a_key_of_other_tolerances_is_refused(folder: Path) -> None:
    key = folder / "EXAM" / "key.jsonl"
    text = key.read_text(encoding="utf-8")
    key.write_text(re.sub(r'"relative": ?0.01', '"relative": 0.005', text, count=1), "utf-8")
    assert [line for line in refused(folder) if 'student "s0", q1: ' not in line] == []


def test_a_secret_that_was_taken_out_is_refused(folder: Path) -> None:
    head = folder / "EXAM" / "exam.json"
    text = head.read_text(encoding="utf-8").replace('"reproducible"', '"taken"')
    head.write_text(text, encoding="utf-8")
    (line,) = refused(folder)
    assert line.startswith("EXAM/exam.json: does not hold the secret")


def test_a_name_that_no_font_prints_is_complained_of(folder: Path) -> None:
    (folder / "late.csv").write_text(roster({"x": "\U00012000"}), encoding="utf-8")
    said = "x: the name has characters that no font of its typesetter prints, they stand as code points"
    assert refused(folder, "--strict") == [said]
    result = add(folder)
    assert result.exit_code == 1
    assert f"complaint: {said}\n" in result.stderr


def test_a_late_id_that_an_exam_has_but_for_zeros_is_refused_unless_it_is_wanted(
    tmp_path: Path,
) -> None:
    folder = write(tmp_path, students={"03100111": "Ann"})
    (folder / "late.csv").write_text(roster({"3100111": "Ann"}), encoding="utf-8")
    files = folder / "bank.toml", folder / "roster.csv", "-o", folder / "EXAM"
    assert kinegrade("generate", *files).exit_code == 0
    late = "--add", folder / "late.csv"
    refused = kinegrade("generate", *files, *late)
    assert refused.exit_code == 2
    assert refused.stderr.splitlines() == [
        'error: late.csv:2: student "03100111" has a paper already, and "3100111" differs from that '
        "id by zeros in front alone - use one id for one person, or add --allow-odd-ids if they are "
        "several people"
    ]
    assert kinegrade("generate", *files, *late, "--allow-odd-ids").exit_code == 0


def test_a_seat_of_the_exam_is_not_that_of_a_late_student_too(tmp_path: Path) -> None:
    folder = write(tmp_path)
    seats = "student,name,room,seat\ns0,Ann,Hall,1\na/b,Bo,Hall,2\ns2,Cy,Aula,1\n"
    (folder / "roster.csv").write_text(seats, encoding="utf-8")
    generated(folder, *WORDS)
    late = "student,name,room,seat\ns7,Di,Hall,2\ns8,Ed,Aula,2\n"
    (folder / "late.csv").write_text(late, encoding="utf-8")
    assert refused(folder) == [
        'late.csv:2: seat 2 in room Hall is that of student "a/b" already - give another seat'
    ]
