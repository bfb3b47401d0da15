"""Questions without a mechanism: printed with room for an answer, and open until somebody has
marked them.
"""

from __future__ import annotations

import csv
import json
from pathlib import Path

import pytest
from click.testing import Result
from pypdf import PdfReader

from tests.printed_text import read_text
from tests.small_class import kinegrade

HEAD = """title = { en = "Midterm", zh = "期中测验" }
course = "Mechanics"
"""
CRANK = """
[[questions]]
template = "slider-crank"
asks = { v_B = 3 }
"""
THEORY = """
[[questions]]
text = { en = "Why has a body with $\\\\omega \\\\ne 0$ one *pole*?", zh = "为什么只有一个速度瞬心？" }
title = { en = "Poles", zh = "瞬心" }
points = 2.5
space = "5 cm"
"""
SLEEVE = """
[[questions]]
template = "bar-through-swivelling-sleeve"
asks = { omega_AB = 4 }
"""
WHEEL = """
[[questions]]
template = "rolling-wheel-rim-points"
asks = "velocity"
points = 4
"""
OPEN = "question 2 is still to be marked by hand (2.5 points): totals are of the points marked here"


def set_exam(folder: Path, bank: str, *options: str) -> Result:
    """What `generate` says of a bank for two students."""
    (folder / "bank.toml").write_text(HEAD + bank, encoding="utf-8")
    roster = "student,name\n1001,Ada Byron\n1002,Sofya Kovalevskaya\n"
    (folder / "roster.csv").write_text(roster, encoding="utf-8")
    files = folder / "bank.toml", folder / "roster.csv"
    return kinegrade("generate", *files, "-o", folder / "EXAM", *options)


def read_pdf(path: Path) -> str:
    """The text of all pages, its words one blank apart."""
    return read_text(path)


def mark_right(folder: Path) -> Path:
    """A marks folder in which everybody answered what the key says."""
    lines = (folder / "EXAM" / "key.jsonl").read_text(encoding="utf-8").splitlines()
    rows = []
    for line in map(json.loads, lines):
        asks = {
            f"{each['question']}.{name}": ask["decimal"]
            for each in line["questions"]
            for name, ask in each["asks"].items()
        }
        rows.append({"student": line["student"], **asks})
    with (folder / "answers.csv").open("w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, list(rows[0]))
        writer.writeheader()
        writer.writerows(rows)
    marked = kinegrade("grade", folder / "EXAM", folder / "answers.csv", "-o", folder / "MARKS")
    assert marked.exit_code == 0, marked.stderr
    assert marked.stderr.splitlines()[-1] == OPEN
    return folder / "MARKS"


@pytest.mark.parametrize(
    ("language", "text", "points"), [("en", "Why has a body with", "2.5 points"), ("zh", "为什么只有", "2.5 分")]
)  # fmt: skip
def test_it_is_printed_with_number_and_points_and_in_the_key(
    tmp_path: Path, language: str, text: str, points: str
) -> None:
    made = set_exam(tmp_path, CRANK + THEORY + SLEEVE, "--lang", language)
    assert made.exit_code == 0, made.stderr
    exam = tmp_path / "EXAM"
    paper = read_pdf(exam / "papers" / "1001.pdf")
    assert text in paper
    assert points in paper
    assert "9.5" in paper  # the total of the marker's table
    key = read_pdf(exam / "key.pdf")
    assert {"en": "to be marked by hand: 2.5 points", "zh": "人工评分：2.5 分"}[language] in key
    header = (exam / "answers.csv").read_text(encoding="utf-8-sig").splitlines()[0]
    assert header == "student,name,q1.v_B,q3.omega_AB"


def test_a_paper_is_printed_again_and_a_late_student_gets_one(tmp_path: Path) -> None:
    assert set_exam(tmp_path, CRANK + THEORY + SLEEVE, "--solutions").exit_code == 0
    exam, again = tmp_path / "EXAM", tmp_path / "again.pdf"
    assert kinegrade("paper", exam, "1002", "-o", again).exit_code == 0
    assert again.read_bytes() == (exam / "papers" / "1002.pdf").read_bytes()
    late = tmp_path / "late.csv"
    late.write_text("student,name\n1003,Lise Meitner\n", encoding="utf-8")
    files = tmp_path / "bank.toml", tmp_path / "roster.csv"
    added = kinegrade("generate", *files, "-o", exam, "--add", late)
    assert added.exit_code == 0, added.stderr
    assert "Poles" in read_pdf(exam / "papers" / "1003.pdf")


def test_marks_leave_it_open_and_never_count_it_as_zero(tmp_path: Path) -> None:
    assert set_exam(tmp_path, CRANK + THEORY + SLEEVE).exit_code == 0
    marks = mark_right(tmp_path)
    with (marks / "grades.csv").open(encoding="utf-8-sig", newline="") as file:
        rows = list(csv.DictReader(file))
    assert [(row["q1"], row["q3"], row["total"], row["out_of"]) for row in rows] == [
        ("3", "4", "7", "7")
    ] * 2
    assert "q2" not in rows[0]
    (exam,) = (marks / "exam.csv").read_text(encoding="utf-8").splitlines()[1:]
    assert (marks / "open.csv").read_text(encoding="utf-8-sig") == (
        "student,name,paper,question,out_of,points,comment,exam\n"
        f"1001,Ada Byron,,q2,2.5,,,{exam}\n1002,Sofya Kovalevskaya,,q2,2.5,,,{exam}\n"
    )


def test_points_typed_for_one_exam_are_not_taken_for_the_next(tmp_path: Path) -> None:
    assert set_exam(tmp_path, CRANK + THEORY + SLEEVE).exit_code == 0
    kept = tmp_path / "typed.csv"
    opened = (mark_right(tmp_path) / "open.csv").read_text(encoding="utf-8-sig")
    kept.write_text(opened.replace(",2.5,,,", ",2.5,2,,"), encoding="utf-8")
    (tmp_path / "MARKS").rename(tmp_path / "FIRST")
    assert set_exam(tmp_path, CRANK + THEORY + SLEEVE, "--force", "--new-numbers").exit_code == 0
    mark_right(tmp_path)
    again = "grade", tmp_path / "EXAM", tmp_path / "answers.csv", "-o", tmp_path / "MARKS"
    refused = kinegrade(*again, "--force", "--manual", kept)
    assert refused.exit_code == 2
    assert refused.stderr == (
        f"error: {kept}: the points in it are for another exam - give the open.csv that marking "
        "this exam wrote\n"
    )
    refused = kinegrade(*again, "--force", "--manual", tmp_path / "FIRST" / "open.csv")
    assert refused.exit_code == 2
    assert "these are marks of another exam than" in refused.stderr


def test_a_column_exam_of_a_marker_is_their_own(tmp_path: Path) -> None:
    assert set_exam(tmp_path, CRANK + THEORY + SLEEVE).exit_code == 0
    mark_right(tmp_path)
    own = tmp_path / "own.csv"
    own.write_text("exam,student,question,points\nmidterm,1001,q2,2\n", encoding="utf-8")
    again = "grade", tmp_path / "EXAM", tmp_path / "answers.csv", "-o", tmp_path / "MARKS"
    marked = kinegrade(*again, "--force", "--manual", own)
    assert "another exam" not in marked.stderr
    assert "1001,q2,2,2.5,," in (tmp_path / "MARKS" / "manual.csv").read_text(encoding="utf-8-sig")


def test_feedback_report_and_exports_say_what_is_open(tmp_path: Path) -> None:
    assert set_exam(tmp_path, CRANK + THEORY + SLEEVE).exit_code == 0
    exam, marks = tmp_path / "EXAM", mark_right(tmp_path)
    feedback = tmp_path / "FEEDBACK"
    assert kinegrade("feedback", exam, marks, "-o", feedback, "--format", "md").exit_code == 0
    sheet = (feedback / "sheets" / "1001.md").read_text(encoding="utf-8")
    assert "**Total: 7 / 7, with 2.5 points still to be marked by hand**" in sheet
    headings = [line for line in sheet.splitlines() if line.startswith("## ")]
    assert [line.split(" · ")[0] for line in headings] == [f"## Question {n}" for n in (1, 2, 3)]
    assert headings[1] == "## Question 2 · Poles (to be marked by hand, of 2.5)"
    assert kinegrade("report", exam, marks, "-o", tmp_path / "report.html").exit_code == 0
    report = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert "of the 7 points marked here; 2.5 more are to be marked by hand" in report
    for system in ("moodle", "generic", "xlsx"):
        made = kinegrade("export", marks, "--to", system, "-o", tmp_path / f"grades.{system}")
        assert made.exit_code == 1
        said = made.stderr.splitlines()[-1]
        assert said.endswith(f"grades.{system}: {OPEN} - add their points there")
    moodle = (tmp_path / "grades.moodle").read_text(encoding="utf-8-sig")
    assert "1: 3/3; 3: 4/4" in moodle


def test_a_quiz_leaves_it_out_and_says_so(tmp_path: Path) -> None:
    assert set_exam(tmp_path, CRANK + THEORY + SLEEVE).exit_code == 0
    quiz = kinegrade("quiz", tmp_path / "EXAM", "--to", "qti21", "-o", tmp_path / "quiz.zip")
    assert quiz.exit_code == 1
    assert quiz.stderr.splitlines()[-1].endswith(
        "quiz.zip: question 2 is to be marked by hand and was left out "
        "- ask on paper, or add an essay question there"
    )


def test_shuffled_papers_keep_its_number(tmp_path: Path) -> None:
    bank = "shuffle = true\n" + CRANK + THEORY + SLEEVE + WHEEL
    assert set_exam(tmp_path, bank, "--reproducible", "any order").exit_code == 0
    orders = [
        tuple(json.loads(line)["printed"])
        for line in (tmp_path / "EXAM" / "key.jsonl").read_text(encoding="utf-8").splitlines()
    ]
    assert any(order != ("q1", "q3", "q4") for order in orders), orders
    marks = mark_right(tmp_path)
    moodle = tmp_path / "moodle.csv"
    kinegrade("export", marks, "--to", "moodle", "-o", moodle)
    points = {"q1": "3/3", "q3": "4/4", "q4": "4/4"}
    for order, line in zip(
        orders, moodle.read_text(encoding="utf-8-sig").splitlines()[1:], strict=True
    ):
        said = zip((1, 3, 4), order, strict=True)
        assert line.endswith("; ".join(f"{number}: {points[name]}" for number, name in said))


@pytest.mark.parametrize(
    ("entry", "fault"),
    [
        ('text = "Why?"', ":8: questions[2].points: missing"),
        ('text = ""\npoints = 1', ':9: questions[2].text: "" - expected a text'),
        ('text = "Why?"\npoints = 0', ":10: questions[2].points: 0 - expected points above 0"),
        (
            'text = "Why?"\npoints = 1\nasks = { v_B = 1 }',
            ":11: questions[2].asks: unknown key - known here: bonus, points, space, text, title",
        ),
    ],
)
def test_what_is_missing_or_does_not_belong_there_is_refused(
    tmp_path: Path, entry: str, fault: str
) -> None:
    made = set_exam(tmp_path, f"{CRANK}\n[[questions]]\n{entry}\n")
    assert made.exit_code == 2
    assert fault in made.stderr


def test_one_question_at_least_has_a_template(tmp_path: Path) -> None:
    made = set_exam(tmp_path, THEORY)
    assert made.exit_code == 2
    assert made.stderr.endswith(
        "questions: all questions are to be marked by hand - expected one at least with a template\n"
    )


def test_a_language_that_its_text_lacks_is_refused(tmp_path: Path) -> None:
    made = set_exam(
        tmp_path, CRANK + THEORY.replace(', zh = "为什么只有一个速度瞬心？"', ""), "--lang", "zh"
    )
    assert made.exit_code == 2
    assert "q2.text" in made.stderr


@pytest.mark.parametrize("number", ["q1", "second"])
def test_a_damaged_number_is_refused(tmp_path: Path, number: str) -> None:
    assert set_exam(tmp_path, CRANK + THEORY + SLEEVE).exit_code == 0
    head = tmp_path / "EXAM" / "exam.json"
    content = json.loads(head.read_text(encoding="utf-8"))
    content["by_hand"][0]["question"] = number
    head.write_text(json.dumps(content), encoding="utf-8")
    refused = kinegrade("solutions", tmp_path / "EXAM")
    assert refused.exit_code == 2
    assert f'by_hand[1] is "{number}" - expected a number of its own, like q3' in refused.stderr


def test_damaged_points_of_an_open_question_are_refused(tmp_path: Path) -> None:
    assert set_exam(tmp_path, CRANK + THEORY + SLEEVE).exit_code == 0
    marks = mark_right(tmp_path)
    (marks / "open.csv").write_text("question,points\nq2,many\n", encoding="utf-8")
    refused = kinegrade("export", marks, "--to", "moodle", "-o", tmp_path / "moodle.csv")
    assert refused.exit_code == 2
    assert "open.csv:2: points" in refused.stderr


def test_its_texts_may_stand_beside_the_bank(tmp_path: Path) -> None:
    drawn = '\n[[questions]]\ntag = "rolling"\nnumber = 2\nasks = "velocity"\npoints = 8\n'
    theory = (
        '\n[[questions]]\ntext = { en = "What is a pole?" }\ntitle = { en = "Poles" }\npoints = 5\n'
    )
    bank = tmp_path / "bank.toml"
    bank.write_text(f'title = "Quiz"\ncourse = "Mechanics"\n{drawn}{theory}', encoding="utf-8")
    beside = '[q3]\ntext = "什么是速度瞬心？"\ntitle = "瞬心"\n'
    (tmp_path / "bank.zh.toml").write_text(beside, encoding="utf-8")
    proof = tmp_path / "proof.pdf"
    done = kinegrade("sample", bank, "-o", proof, "--lang", "zh")
    assert done.exit_code == 0, done.stderr
    text = "".join(page.extract_text() for page in PdfReader(proof).pages)
    assert "什么是速度瞬心" in text
    assert "瞬心" in text
