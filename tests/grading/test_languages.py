"""In which language marking speaks: the terminal's there, the exam's in the folder of marks."""

from __future__ import annotations

import csv
from pathlib import Path

import pytest

from kinegrade.marks_folder.folder import MarksFolder
from tests.grading.small_exam import exam, paper, write_exam
from tests.small_class import kinegrade

ANSWERS = "student,q1.v_B,q1.omega_AB,q2.a_B\n007,1.76,0,?\n999,1,2,3\n"


def grade(folder: Path, language: str) -> tuple[list[str], list[list[str]]]:
    """What the terminal shows, and the rows of complaints.csv, for an exam in that language."""
    head = {**exam(), "language": language}
    papers = [paper(each["student"]) for each in head["students"]]
    written = write_exam(folder / "EXAM", head, papers)
    (folder / "answers.csv").write_text(ANSWERS, encoding="utf-8")
    done = kinegrade("grade", written, folder / "answers.csv", "-o", folder / "MARKS")
    assert done.exit_code == 1, done.stderr
    with (folder / "MARKS" / "complaints.csv").open(encoding="utf-8-sig", newline="") as file:
        return done.stderr.splitlines(), list(csv.reader(file))[1:]


def test_the_terminal_is_spoken_to_in_its_language_and_the_folder_written_in_the_exam_s(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("LC_ALL", "zh_CN.UTF-8")
    shown, rows = grade(tmp_path, "en")
    assert '注意：answers.csv:3: student: 本次考试没有学生 "999" - 未评分' in shown
    assert ['no student "999" in the exam', "not graded"] in [row[4:] for row in rows]


def test_an_exam_in_chinese_is_complained_of_in_chinese_whatever_the_terminal(
    tmp_path: Path,
) -> None:
    shown, rows = grade(tmp_path, "zh")
    assert 'complaint: answers.csv:3: student: no student "999" in the exam - not graded' in shown
    assert ['本次考试没有学生 "999"', "未评分"] in [row[4:] for row in rows]


def test_an_exam_in_chinese_has_its_reasons_in_chinese_too(tmp_path: Path) -> None:
    grade(tmp_path, "zh")
    with (tmp_path / "MARKS" / "marks.csv").open(encoding="utf-8", newline="") as file:
        found = {row["ask"]: row for row in csv.DictReader(file) if row["student"] == "007"}
    within = "正确答案 1.73205，相差 0.0279492，允许 0.0173205"
    assert (found["v_B"]["verdict"], found["v_B"]["reason"]) == ("wrong", within)
    assert (found["a_B"]["verdict"], found["a_B"]["reason"]) == ("unreadable", '"?" 不是一个数')


def test_what_marks_say_of_mistakes_and_the_policy_is_read_without_their_words(
    tmp_path: Path,
) -> None:
    grade(tmp_path, "zh")
    policy = tmp_path / "policy.toml"
    policy.write_text("tolerance = { relative = '2 %' }", encoding="utf-8")
    answers, marks = tmp_path / "answers.csv", tmp_path / "MARKS2"
    kinegrade("grade", tmp_path / "EXAM", answers, "-o", marks, "--policy", policy)
    first = next(MarksFolder(marks).answers())
    assert (first.verdict, first.by_policy, first.mistakes) == ("right", True, ())
    assert first.reason.endswith("（按评分政策）")
