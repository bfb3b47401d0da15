"""Bonus questions: their points come on top of the maximum, everywhere."""

from __future__ import annotations

import csv
import json
from pathlib import Path

import pytest
from click.testing import Result

from tests.printed_text import read_text
from tests.small_class import kinegrade, table

HEAD = """title = { en = "Midterm", zh = "期中测验" }
course = "Mechanics"
"""
CRANK = """
[[questions]]
template = "slider-crank"
asks = { v_B = 3, omega_AB = 4 }
"""
BONUS = """
[[questions]]
template = "bar-through-swivelling-sleeve"
asks = { omega_AB = 2 }
bonus = true
"""
DRAWN = """
[[questions]]
family = "rolling"
asks = "velocity"
points = 6
bonus = true
"""
THEORY = """
[[questions]]
text = { en = "Why?", zh = "为什么？" }
points = 1.5
bonus = true
"""
TAKEN = "1 student has more than the maximum, by bonus points"


def set_exam(folder: Path, bank: str, *options: str) -> Result:
    """What `generate` says of a bank for two students."""
    (folder / "bank.toml").write_text(HEAD + bank, encoding="utf-8")
    roster = "student,name\n1001,Ada Byron\n1002,Sofya Kovalevskaya\n"
    (folder / "roster.csv").write_text(roster, encoding="utf-8")
    files = folder / "bank.toml", folder / "roster.csv"
    return kinegrade("generate", *files, "-o", folder / "EXAM", *options)


def mark(folder: Path) -> Path:
    """A marks folder in which 1001 has everything right, and 1002 the bonus alone."""
    rows = []
    for line in map(json.loads, (folder / "EXAM" / "key.jsonl").read_text("utf-8").splitlines()):
        asks = {
            f"{each['question']}.{name}": ask["decimal"]
            for each in line["questions"]
            for name, ask in each["asks"].items()
            if line["student"] == "1001" or each["question"] == "q2"
        }
        rows.append({"student": line["student"], **asks})
    with (folder / "answers.csv").open("w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, list(rows[0]))
        writer.writeheader()
        writer.writerows(rows)
    marked = kinegrade("grade", folder / "EXAM", folder / "answers.csv", "-o", folder / "MARKS")
    assert marked.exit_code == 0, marked.stderr
    return folder / "MARKS"


def read_pdf(path: Path) -> str:
    """The text of all pages, its words one blank apart."""
    return read_text(path)


@pytest.mark.parametrize(
    ("language", "said", "rule", "by_hand"),
    [
        ("en", "2 bonus points", "Bonus points come on top", "to be marked by hand: 1.5 bonus points"),
        ("zh", "2 分（附加分）", "附加题的得分另行加入总分", "人工评分：1.5 分（附加分）"),
    ],
)  # fmt: skip
def test_papers_say_what_is_a_bonus_and_leave_it_out_of_their_total(
    tmp_path: Path, language: str, said: str, rule: str, by_hand: str
) -> None:
    made = set_exam(tmp_path, CRANK + BONUS + THEORY, "--lang", language)
    assert made.exit_code == 0, made.stderr
    paper = read_pdf(tmp_path / "EXAM" / "papers" / "1001.pdf")
    assert said in paper
    assert rule in paper
    assert " 7 +2 +1.5 7 " in paper  # the marker's table, whose last column is the total
    assert by_hand in read_pdf(tmp_path / "EXAM" / "key.pdf")


@pytest.mark.left(beside="test_papers_say_what_is_a_bonus_and_leave_it_out_of_their_total")
def test_a_paper_of_latex_says_so_too(tmp_path: Path) -> None:
    assert set_exam(tmp_path, CRANK + BONUS, "--engine", "latex").exit_code == 0
    paper = read_pdf(tmp_path / "EXAM" / "papers" / "1001.pdf")
    assert "2 bonus points" in paper
    assert "+2 7" in paper


def test_without_a_bonus_nothing_is_said_of_it(tmp_path: Path) -> None:
    assert set_exam(tmp_path, CRANK).exit_code == 0
    assert "onus" not in read_pdf(tmp_path / "EXAM" / "papers" / "1001.pdf")
    assert '"bonus"' not in (tmp_path / "EXAM" / "exam.json").read_text(encoding="utf-8")
    assert not (mark(tmp_path) / "bonus.csv").exists()


def test_points_of_a_bonus_are_added_and_the_maximum_is_without_it(tmp_path: Path) -> None:
    assert set_exam(tmp_path, CRANK + BONUS).exit_code == 0
    marks = mark(tmp_path)
    found = [
        (row["q1"], row["q2"], row["total"], row["out_of"], row["percent"])
        for row in table(marks / "grades.csv")
    ]
    assert found == [("7", "2", "9", "7", "128.57"), ("0", "2", "2", "7", "28.57")]
    assert (marks / "bonus.csv").read_text(encoding="utf-8") == "question,points\nq2,2\n"


def test_a_late_student_has_it_too_and_earlier_totals_stand_above_the_maximum(
    tmp_path: Path,
) -> None:
    assert set_exam(tmp_path, CRANK + BONUS).exit_code == 0
    exam, late = tmp_path / "EXAM", tmp_path / "late.csv"
    late.write_text("student,name\n1003,Lise Meitner\n", encoding="utf-8")
    files = tmp_path / "bank.toml", tmp_path / "roster.csv"
    added = kinegrade("generate", *files, "-o", exam, "--add", late)
    assert added.exit_code == 0, added.stderr
    assert "2 bonus points" in read_pdf(exam / "papers" / "1003.pdf")
    marks = mark(tmp_path)
    (tmp_path / "policy.toml").write_text('[questions.q2]\nvoid = "drop"\n', "utf-8")
    again = kinegrade(
        "grade", exam, tmp_path / "answers.csv", "-o", tmp_path / "AGAIN",
        "--policy", tmp_path / "policy.toml", "--never-lower", marks,
    )  # fmt: skip
    assert again.exit_code == 0, again.stderr
    totals = {row["student"]: row["total"] for row in table(tmp_path / "AGAIN" / "grades.csv")}
    assert totals == {"1001": "9", "1002": "2", "1003": "2"}


def test_feedback_and_report_tell_it_apart(tmp_path: Path) -> None:
    assert set_exam(tmp_path, CRANK + BONUS + THEORY).exit_code == 0
    exam, marks = tmp_path / "EXAM", mark(tmp_path)
    feedback = tmp_path / "FEEDBACK"
    assert kinegrade("feedback", exam, marks, "-o", feedback, "--format", "md").exit_code == 0
    sheet = (feedback / "sheets" / "1001.md").read_text(encoding="utf-8")
    assert "**Total: 9 / 7, with 1.5 points still to be marked by hand**" in sheet
    assert "(7 / 7)\n" in sheet
    assert "(2 / 2, bonus)\n" in sheet
    assert "(to be marked by hand, of 1.5, bonus)\n" in sheet
    assert kinegrade("report", exam, marks, "-o", tmp_path / "report.html").exit_code == 0
    report = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert "of 7 points; bonus questions add up to 3.5 on top" in report
    assert '<td class="number">+2</td>' in report


@pytest.mark.parametrize(
    ("system", "lines"),
    [
        ("moodle", ["1001,Ada Byron,9,1: 7/7; 2: +2/2"]),
        ("canvas", ["Ada Byron [1001],,1001,,,9"]),
        ("brightspace", ["MaxPoints:7>", "1001,9,"]),
    ],
)
def test_exports_have_totals_above_the_maximum_and_say_so(
    tmp_path: Path, system: str, lines: list[str]
) -> None:
    assert set_exam(tmp_path, CRANK + BONUS).exit_code == 0
    marks, grades = mark(tmp_path), tmp_path / "grades.csv"
    made = kinegrade("export", marks, "--to", system, "--title", "Midterm", "-o", grades)
    assert made.exit_code == 0, made.stderr
    assert TAKEN in made.stderr
    text = grades.read_text(encoding="utf-8-sig")
    assert [line for line in lines if line not in text] == []


def test_an_export_by_question_has_it_as_an_item_of_its_own(tmp_path: Path) -> None:
    assert set_exam(tmp_path, CRANK + BONUS).exit_code == 0
    grades = tmp_path / "grades.csv"
    arguments = ("--to", "generic", "--title", "Midterm", "--per-question", "-o", grades)
    made = kinegrade("export", mark(tmp_path), *arguments)
    assert made.exit_code == 0, made.stderr
    assert TAKEN not in made.stderr


def test_a_quiz_counts_it_like_any_other_and_says_so(tmp_path: Path) -> None:
    assert set_exam(tmp_path, CRANK + BONUS).exit_code == 0
    quiz = kinegrade("quiz", tmp_path / "EXAM", "--to", "qti21", "-o", tmp_path / "quiz.zip")
    assert quiz.exit_code == 1
    assert quiz.stderr.splitlines()[-1].endswith(
        "quiz.zip: question 2 is a bonus, which a quiz does not know: its points count toward the "
        "maximum there - grade the responses with kinegrade, or lower the maximum there"
    )


def test_questions_drawn_by_family_may_be_a_bonus(tmp_path: Path) -> None:
    assert set_exam(tmp_path, CRANK + DRAWN).exit_code == 0
    head = json.loads((tmp_path / "EXAM" / "exam.json").read_text(encoding="utf-8"))
    assert [each.get("bonus", False) for each in head["questions"]] == [False, True]


@pytest.mark.parametrize(
    ("bank", "fault"),
    [
        (BONUS, "questions: all questions that are marked here are bonus questions "
                "- expected one at least whose points count toward the maximum"),
        (BONUS + THEORY.replace("bonus = true", ""), "questions: all questions that are marked"),
        (CRANK + BONUS.replace("true", '"yes"'), 'questions[2].bonus: "yes" - expected true or false'),
    ],
)  # fmt: skip
def test_what_leaves_no_maximum_or_is_no_word_is_refused(
    tmp_path: Path, bank: str, fault: str
) -> None:
    made = set_exam(tmp_path, bank)
    assert made.exit_code == 2
    assert fault in made.stderr
