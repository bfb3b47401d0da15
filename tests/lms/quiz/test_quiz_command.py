"""`kinegrade quiz` as instructors call it: every form, whole or not at all, refusals in one
line.
"""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from kinegrade.cli.quiz import quiz
from kinegrade.lms.quiz.formats import FORMATS
from tests.lms.quiz.moodle_rules import faults, read


def put(*arguments: str | Path) -> Result:
    result = CliRunner().invoke(quiz, list(map(str, arguments)))
    if result.exception is not None and not isinstance(result.exception, SystemExit):
        raise result.exception
    return result


@pytest.mark.parametrize("system", FORMATS)
def test_every_form_is_written(small_class: Path, tmp_path: Path, system: str) -> None:
    target = tmp_path / "quiz"
    result = put(small_class / "EXAM", "--to", system, "-o", target, "--no-mistakes")
    assert result.exit_code in (0, 1), result.stderr
    assert f"{target}: written; it gives the key away, for instructors only" in result.stderr
    assert (
        "marked there, every number is marked alone: only kinegrade grade on its responses gives"
        in result.stderr
    )
    assert target.stat().st_size > 2000


def test_moodle_in_chinese_one_number_a_question_with_solutions(
    small_class: Path, tmp_path: Path
) -> None:
    target = tmp_path / "quiz.xml"
    result = put(
        shutil.copytree(small_class / "EXAM", tmp_path / "EXAM"),  # the pool is stored there
        "--to",
        "moodle-xml",
        "-o",
        target,
        "--as",
        "numerical",
        "--lang",
        "zh",
        "--variants",
        "2",
        "--solutions",
        "--mistake-credit",
        "33.33333",
        "--method",
        "pole",
    )
    assert result.exit_code == 1, result.stderr
    assert result.stderr.splitlines()[2:] == [
        "complaint: moodle-xml: Moodle adds a random question to a quiz with mark 1, whatever its "
        "variants are worth - set the "
        "mark of each there: q1 v_B 3, q1 a_B 2.5, q2 v_x 1, q2 v_y 2, q3 omega_AB 3, q3 alpha_AB 4"
    ]
    text = target.read_text(encoding="utf-8")
    assert faults(text) == []
    questions = read(text)
    assert len(questions) == 12
    assert "曲柄" in questions[0].text
    assert questions[0].feedback
    assert {str(answer.share) for question in questions for answer in question.boxes[0][1]} == {
        "100",
        "3333333/100000",
    }


def test_what_is_left_to_do_is_a_complaint(small_class: Path, tmp_path: Path) -> None:
    result = put(small_class / "EXAM", "--to", "moodle-xml", "-o", tmp_path / "quiz.xml")
    assert result.exit_code == 1
    assert "complaint: marks in Moodle are 2 times the points" in result.stderr


def test_a_file_that_stands_there_is_replaced_only_by_force(
    small_class: Path, tmp_path: Path
) -> None:
    target = tmp_path / "quiz.xml"
    target.write_text("mine", encoding="utf-8")
    wanted = small_class / "EXAM", "--to", "moodle-xml", "--as", "numerical", "-o"
    result = put(*wanted, target)
    assert (result.exit_code, target.read_text(encoding="utf-8")) == (2, "mine")
    assert (
        "already exists - expected a new file - add --force to replace it, or choose another name"
        in result.stderr
    )
    assert put(*wanted, target, "--force").exit_code == 1
    assert target.stat().st_size > 2000
    assert (
        "is not a plain file - expected a file to write - choose another name"
        in put(*wanted, tmp_path).stderr
    )


def test_refusals_are_one_line_and_leave_nothing(small_class: Path, tmp_path: Path) -> None:
    target = tmp_path / "quiz.xml"
    result = put(small_class / "EXAM", "--to", "moodle-xml", "-o", target, "--mistake-credit", "33")
    assert result.exit_code == 2
    assert result.stderr.startswith(
        "error: credit of 33 per cent for known mistakes: Moodle has no such share"
    )
    assert put(tmp_path / "nowhere", "--to", "moodle-xml", "-o", target).exit_code == 2
    assert (
        put(small_class / "EXAM", "--to", "moodle-xml", "--variants", "9", "-o", target).exit_code
        == 2
    )
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("system", FORMATS)
def test_a_place_that_cannot_hold_a_file_is_named_in_one_line(
    small_class: Path, tmp_path: Path, system: str
) -> None:
    (tmp_path / "file").write_text("mine", encoding="utf-8")
    result = put(small_class / "EXAM", "--to", system, "-o", tmp_path / "file" / "quiz.zip")
    assert result.exit_code == 2
    assert result.stderr.startswith(f"error: {tmp_path}/file/quiz.zip: cannot be written (")
    assert result.stderr.count("\n") == 1
    assert [entry.name for entry in tmp_path.iterdir()] == ["file"]


def test_a_quiz_in_parts_stays_below_the_upload_limit_and_loses_nothing(
    small_class: Path, tmp_path: Path
) -> None:
    exam = shutil.copytree(small_class / "EXAM", tmp_path / "EXAM")  # the pool is stored there
    wanted = exam, "--to", "moodle-xml", "--variants", "4"
    assert put(*wanted, "-o", tmp_path / "whole.xml").exit_code == 1
    whole = read((tmp_path / "whole.xml").read_text(encoding="utf-8"))
    limit = (tmp_path / "whole.xml").stat().st_size * 2 // 3
    result = put(*wanted, "--split", str(limit / 10**6), "-o", tmp_path / "parts")
    assert result.exit_code == 1, result.stderr
    parts = sorted((tmp_path / "parts").iterdir())
    assert [part.name for part in parts] == ["quiz-1.xml", "quiz-2.xml"]
    assert [part for part in parts if part.stat().st_size > limit] == []
    texts = [part.read_text(encoding="utf-8") for part in parts]
    assert [faults(text) for text in texts] == [[], []]
    assert [question for text in texts for question in read(text)] == whole


def test_parts_of_an_earlier_quiz_do_not_stay_among_new_ones(
    small_class: Path, tmp_path: Path
) -> None:
    exam = shutil.copytree(small_class / "EXAM", tmp_path / "EXAM")  # the pool is stored there
    wanted = exam, "--to", "moodle-xml", "--variants", "4", "-o", tmp_path / "parts"
    assert put(*wanted, "--split", "0.05").exit_code == 1
    assert len(list((tmp_path / "parts").iterdir())) > 1
    again = put(*wanted, "--split", "2")
    assert again.exit_code == 2
    assert "already exists - expected a new folder - add --force" in again.stderr
    assert put(*wanted, "--split", "2", "--force").exit_code == 1
    assert [part.name for part in (tmp_path / "parts").iterdir()] == ["quiz-1.xml"]
    (tmp_path / "parts" / "mine.txt").write_text("mine", encoding="utf-8")
    assert "holds mine.txt, which would be lost" in put(*wanted, "--split", "2", "--force").stderr


def test_parts_that_are_too_small_or_of_another_system_are_refused(
    small_class: Path, tmp_path: Path
) -> None:
    wanted = small_class / "EXAM", "-o", tmp_path / "parts", "--split"
    small = put(*wanted, "0.01", "--to", "moodle-xml")
    assert small.exit_code == 2
    assert small.stderr.startswith("error: quiz: paper 1 alone takes 0.0")
    assert small.stderr.endswith(
        "MB of Moodle XML - expected to fit into a file of 0.01 MB - give --split a larger number\n"
    )
    package = put(*wanted, "2", "--to", "qti12")
    assert package.exit_code == 2
    assert package.stderr == (
        "error: --split: qti12 is one package - expected moodle-xml, whose files are imported "
        "one after the other - leave --split out, or write for fewer with --variants\n"
    )
    assert list(tmp_path.iterdir()) == []
