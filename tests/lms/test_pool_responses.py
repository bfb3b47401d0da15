"""Answers to questions that Moodle drew from a pool are marked by the key of what was drawn, or
refused.
"""

from __future__ import annotations

import json
import re
import shutil
from fractions import Fraction
from pathlib import Path

import pytest

from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.exam.follow_through import FollowThrough
from kinegrade.exam.quiz.quiz import read_quiz
from tests.lms.pooled_quiz import Drawn, attempt, download, perfect, pool
from tests.lms.response_files import csv_text
from tests.small_class import (
    STUDENTS,
    asks_of,
    generate,
    key_lines,
    kinegrade,
    table,
    write_class,
)

ALL = ("Question", "Response", "Right answer")


@pytest.fixture(scope="module")
def exam(small_class: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the class's exam, of which a pool of three variants was made: pool.xml beside
    it.
    """
    folder = tmp_path_factory.mktemp("pooled")
    exam = Path(shutil.copytree(small_class / "EXAM", folder / "EXAM"))
    assert quiz(exam, folder / "pool.xml", 3) in (0, 1)
    return exam


def quiz(exam: Path, file: Path, count: int) -> int:
    """The exit status of writing a pool; 1 where the marks of half points are said to be
    doubled.
    """
    options = ("--to", "moodle-xml", "--variants", str(count), "-o", file)
    return kinegrade("quiz", exam, *options).exit_code


def drawn(exam: Path) -> dict[str, list[Drawn]]:
    quiz = exam.parent / "pool.xml"
    return {student: attempt(quiz, number) for number, student in enumerate(STUDENTS)}


def grade(exam: Path, folder: Path, content: str, *options: str) -> tuple[int, str]:
    (folder / "responses.csv").write_text(content, encoding="utf-8-sig")
    done = kinegrade(
        "grade", exam, folder / "responses.csv", "-o", folder / "MARKS", "--force", *options
    )
    return done.exit_code, done.stderr


def points(folder: Path) -> list[tuple[str, str]]:
    return [(row["total"], row["out_of"]) for row in table(folder / "MARKS" / "grades.csv")]


@pytest.mark.parametrize("columns", [ALL, ("Response", "Right answer"), ("Question", "Response")])
def test_perfect_students_of_a_pool_get_all_points(
    exam: Path, tmp_path: Path, columns: tuple[str, ...]
) -> None:
    rows = [(student, each, perfect(each)) for student, each in drawn(exam).items()]
    status, said = grade(exam, tmp_path, download(rows, columns))
    assert status == 0, said
    assert points(tmp_path) == [("15.5", "15.5")] * len(STUDENTS)


def test_right_answers_with_a_decimal_comma_tell_the_variant_too(
    exam: Path, tmp_path: Path
) -> None:
    rows = [(student, each, perfect(each)) for student, each in drawn(exam).items()]
    content = download(rows, ("Response", "Right answer"), decimal=",")
    assert grade(exam, tmp_path, content)[0] == 0
    assert points(tmp_path) == [("15.5", "15.5")] * len(STUDENTS)


def test_mistakes_and_what_follows_from_them_are_those_of_the_variant(
    exam: Path, tmp_path: Path
) -> None:
    rows = []
    for student, each in drawn(exam).items():
        typed = perfect(each)
        typed[2][0] = f"{-float(typed[2][0]):.8g}"
        rows.append((student, each, typed))
    assert grade(exam, tmp_path, download(rows))[0] == 0
    wrong = [row for row in table(tmp_path / "MARKS" / "marks.csv") if row["verdict"] != "right"]
    assert {row["verdict"] for row in wrong} == {"mistake"}
    assert {(row["question"], row["ask"]) for row in wrong} == {("q3", "omega_AB")}


def test_a_download_that_does_not_tell_what_was_drawn_is_refused_whole(
    exam: Path, tmp_path: Path
) -> None:
    rows = [(student, each, perfect(each)) for student, each in drawn(exam).items()]
    status, said = grade(exam, tmp_path, download(rows, ("Response",)))
    assert status == 2
    assert "the exam has a pool of 3 variants" in said
    assert "tick the question text and the right answer" in said
    assert not (tmp_path / "MARKS").exists()


def test_a_question_that_is_no_variant_is_refused_whole(exam: Path, tmp_path: Path) -> None:
    rows = [(student, each, perfect(each)) for student, each in drawn(exam).items()]
    strange = Drawn("another question", tuple("7.25" for _ in rows[0][1][0].right))
    rows[1] = (rows[1][0], [strange, *rows[1][1][1:]], rows[1][2])
    status, said = grade(exam, tmp_path, download(rows))
    assert status == 2
    assert "1 answered question is not certainly one variant of the pool of 3 (line " in said
    assert re.search(r"\(line \d+, q1.v_B, q1.a_B: none of them may be meant\)", said)
    assert not (tmp_path / "MARKS").exists()


def test_right_answers_that_contradict_the_text_are_refused_whole(
    exam: Path, tmp_path: Path
) -> None:
    rows = [(student, each, perfect(each)) for student, each in drawn(exam).items()]
    first, *others = next(iter(pool(exam.parent / "pool.xml").values()))
    student, put, typed = rows[0]
    rows[0] = (student, [Drawn(first.text, others[0].right), *put[1:]], typed)
    status, said = grade(exam, tmp_path, download(rows))
    assert status == 2
    assert re.search(r"\(line \d+, q1.v_B, q1.a_B: none of them may be meant\)", said)
    assert not (tmp_path / "MARKS").exists()


def test_a_text_that_is_no_variant_s_is_not_taken_for_the_only_one(
    exam: Path, tmp_path: Path
) -> None:
    alone = Path(shutil.copytree(exam, tmp_path / "EXAM"))
    lines = (alone / "variants.jsonl").read_text(encoding="utf-8").splitlines()
    (alone / "variants.jsonl").write_text(f"{lines[0]}\n", encoding="utf-8")
    put = [each[0] for each in pool(exam.parent / "pool.xml").values()]
    strange = [Drawn("some other question with 7.25", put[0].right), *put[1:]]
    content = download([(STUDENTS[0], strange, perfect(put))], ("Question", "Response"))
    status, said = grade(alone, tmp_path, content)
    assert (status, "none of them may be meant" in said) == (2, True)


def test_answers_to_a_pool_that_are_typed_into_the_sheet_stop_the_marking(
    exam: Path, tmp_path: Path
) -> None:
    columns = [
        f"{question['question']}.{ask['ask']}"
        for question in json.loads((exam / "exam.json").read_text())["questions"]
        for ask in question["asks"]
    ]
    others = [*STUDENTS[1:], STUDENTS[0]]
    lines = [",".join(["student", *columns])]
    asks = key_values(exam)
    for student, other in zip(STUDENTS, others, strict=True):
        lines.append(",".join([student, *(asks[other, column] for column in columns)]))
    (tmp_path / "answers.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")
    refused = kinegrade("grade", exam, tmp_path / "answers.csv", "-o", tmp_path / "MARKS")
    assert refused.exit_code == 2
    assert "most are right on other papers of this exam" in refused.stderr
    assert not (tmp_path / "MARKS").exists()
    forced = kinegrade(
        "grade", exam, tmp_path / "answers.csv", "-o", tmp_path / "MARKS", "--own-papers"
    )
    assert forced.exit_code == 0


def key_values(exam: Path) -> dict[tuple[str, str], str]:
    """The right answers as somebody types them."""
    return {place: f"{float(ask['value']):.5g}" for place, ask in asks_of(exam).items()}


def test_feedback_and_sharing_know_what_was_drawn(exam: Path, tmp_path: Path) -> None:
    rows = []
    for student, each in drawn(exam).items():
        typed = perfect(each)
        typed[0][0] = "99"
        rows.append((student, each, typed))
    assert grade(exam, tmp_path, download(rows))[0] == 0
    options = ("--format", "md", "-o", tmp_path / "FEEDBACK")
    sheets = kinegrade("feedback", exam, tmp_path / "MARKS", *options)
    assert sheets.exit_code == 0, sheets.stderr
    for student, file in zip(STUDENTS, table(tmp_path / "FEEDBACK" / "feedback.csv"), strict=True):
        text = (tmp_path / "FEEDBACK" / file["file"]).read_text(encoding="utf-8")
        first = float(drawn(exam)[student][0].right[0])
        assert f"{first:.6g}"[:4] in text.replace("\u2212", "-")
    found = kinegrade("sharing", exam, tmp_path / "MARKS", "-o", tmp_path / "sharing.csv")
    assert "No pair of students stands out" in found.output
    refused = kinegrade(
        "feedback", exam, tmp_path / "MARKS", "--solutions", *options[:3], tmp_path / "F2"
    )
    assert refused.exit_code == 2
    assert "questions from a pool" in refused.stderr


def test_the_stored_variants_are_extended_and_never_changed(exam: Path, tmp_path: Path) -> None:
    stored = (exam / "variants.jsonl").read_text(encoding="utf-8")
    assert stored.splitlines() == (exam / "key.jsonl").read_text(encoding="utf-8").splitlines()[:3]
    for count in ("2", "3"):
        assert quiz(exam, tmp_path / f"{count}.xml", int(count)) in (0, 1)
        assert (exam / "variants.jsonl").read_text(encoding="utf-8") == stored


def test_variants_of_another_key_are_not_replaced(exam: Path, tmp_path: Path) -> None:
    stored = (exam / "variants.jsonl").read_text(encoding="utf-8")
    lines = stored.splitlines()
    (exam / "variants.jsonl").write_text("\n".join(lines[1:]) + "\n", encoding="utf-8")
    try:
        refused = kinegrade(
            "quiz", exam, "--to", "moodle-xml", "--variants", "3", "-o", tmp_path / "x.xml"
        )
        assert refused.exit_code == 2
        assert "variants.jsonl: has variants of another key" in refused.stderr
        assert not (tmp_path / "x.xml").exists()
    finally:
        (exam / "variants.jsonl").write_text(stored, encoding="utf-8")


def test_the_pool_has_a_category_for_each_question(exam: Path) -> None:
    assert [len(each) for each in pool(exam.parent / "pool.xml").values()] == [3, 3, 3]


FOLLOWING = """title = { en = "Quiz", zh = "测验" }
course = { en = "Mechanics", zh = "力学" }
date = 2026-05-01
tolerance = { relative = "1 %" }

[[questions]]
template = "slider-crank"
asks = { omega_AB = 1, a_B = 1 }
"""


def test_what_follows_from_an_own_answer_is_worked_out_with_the_numbers_of_the_variant(
    tmp_path: Path,
) -> None:
    write_class(tmp_path)
    (tmp_path / "bank.toml").write_text(FOLLOWING, encoding="utf-8")
    assert generate(tmp_path).exit_code == 0
    exam, (student, donor) = tmp_path / "EXAM", STUDENTS[2:4]
    assert quiz(exam, tmp_path / "pool.xml", 4) in (0, 1)
    [every] = pool(tmp_path / "pool.xml").values()
    put = every[STUDENTS.index(donor)]
    own = round(Fraction(put.right[0]) * Fraction(117, 100), 6)
    follows, *_ = FollowThrough(open_exam(exam))(donor, "q1", {"omega_AB": own}, "a_B")
    typed = [[f"{float(own):.6f}", f"{float(follows):.8g}"]]
    assert grade(exam, tmp_path, download([(student, [put], typed)]))[0] == 1  # others are absent
    marks = {
        row["ask"]: row["verdict"]
        for row in table(tmp_path / "MARKS" / "marks.csv")
        if row["student"] == student
    }
    assert marks == {"omega_AB": "wrong", "a_B": "follow-through"}


def test_canvas_draws_every_ask_by_itself(exam: Path, tmp_path: Path) -> None:
    """Its Student Analysis has a column for each variant of each ask, headed by the text of the
    question.
    """
    asks = list(dict.fromkeys(column for _, column in asks_of(exam)))
    donors = STUDENTS[:3]
    statements = {
        (paper.code, question.sheet.identifier): question.sheet.statement
        for paper in read_quiz(open_exam(exam), variants=3).papers
        for question in paper.questions
    }
    codes = {line["student"]: line["paper"] for line in key_lines(exam)}
    header, places = ["name", "sis_id", "submitted"], {}
    for column in asks:
        for donor in donors:
            text = statements[codes[donor], column.partition(".")[0]]
            places[column, donor] = len(header)
            header += [f"{len(header)}: {text} [{column}]", "1.0"]
    values, rows = key_values(exam), []
    for number, student in enumerate(STUDENTS):
        row = ["x", student, "2026-05-01 20:01:01 UTC", *[""] * (len(header) - 3)]
        for place, column in enumerate(asks):
            donor = donors[(number + place) % 3]
            row[places[column, donor]] = values[donor, column]
        rows.append(row)
    status, said = grade(exam, tmp_path, csv_text(header, *rows), "--from", "canvas")
    assert status == 0, said
    assert points(tmp_path) == [("15.5", "15.5")] * len(STUDENTS)


def test_a_pool_of_an_older_version_is_marked_after_it_is_written_again(
    exam: Path, tmp_path: Path
) -> None:
    older = Path(shutil.copytree(exam, tmp_path / "EXAM"))
    (older / "variants.jsonl").unlink()
    rows = [(student, each, perfect(each)) for student, each in drawn(exam).items()]
    status, said = grade(older, tmp_path, download(rows))
    assert status == 2
    assert "students were given other papers than their own" in said
    assert "write it again by kinegrade quiz --variants" in said
    assert quiz(older, tmp_path / "again.xml", 3) in (0, 1)
    assert grade(older, tmp_path, download(rows))[0] == 0
    assert points(tmp_path) == [("15.5", "15.5")] * len(STUDENTS)


def test_a_student_who_left_the_roster_still_gives_the_pool_a_variant(
    exam: Path, tmp_path: Path
) -> None:
    """The lines of variants.jsonl are enough to mark by, where key.jsonl has them no more."""
    left = Path(shutil.copytree(exam, tmp_path / "EXAM"))
    gone = STUDENTS[0]
    head = json.loads((left / "exam.json").read_text(encoding="utf-8"))
    head["students"] = [each for each in head["students"] if each["student"] != gone]
    (left / "exam.json").write_text(json.dumps(head), encoding="utf-8")
    lines = [json.dumps(line) for line in key_lines(left) if line["student"] != gone]
    (left / "key.jsonl").write_text("\n".join(lines) + "\n", encoding="utf-8")
    rows = [
        (student, each, perfect(each)) for student, each in drawn(exam).items() if student != gone
    ]
    status, said = grade(left, tmp_path, download(rows))
    assert status == 0, said
    assert points(tmp_path) == [("15.5", "15.5")] * (len(STUDENTS) - 1)
    assert gone in (tmp_path / "MARKS" / "variants.csv").read_text(encoding="utf-8")
    done = kinegrade(
        "feedback", left, tmp_path / "MARKS", "--format", "md", "-o", tmp_path / "FEEDBACK"
    )
    assert done.exit_code == 0, done.stderr


def test_broken_variants_are_one_line(exam: Path, tmp_path: Path) -> None:
    broken = Path(shutil.copytree(exam, tmp_path / "EXAM"))
    (broken / "variants.jsonl").write_text("{}\n", encoding="utf-8")
    rows = [(student, each, perfect(each)) for student, each in drawn(exam).items()]
    status, said = grade(broken, tmp_path, download(rows))
    assert status == 2
    assert "variants.jsonl: line 1: is broken (" in said
