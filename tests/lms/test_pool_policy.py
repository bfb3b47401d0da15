"""What a policy accepts, and what the class report says, where questions came from a pool: by what
was put.
"""

from __future__ import annotations

import json
import re
from math import isnan
from pathlib import Path

import pytest

from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.marks_folder.folder import MarksFolder
from kinegrade.reports.paper_record import PaperRecords
from tests.lms.test_canvas_pool import analysis, groups, pooled
from tests.lms.test_pool_texts import STUDENTS, set_exam
from tests.problem.crank import crank_text
from tests.small_class import asks_of, kinegrade, table

BANK = """title = "Quiz"
course = "Mechanics"
tolerance = { relative = "1 %" }

[[questions]]
template = "crank.toml"
draw = { h = ["1/2"], r = [1], omega = [2, 3, 4, 5] }
asks = { v_x = 1, v_y = 2 }
"""
# of the right answer to the other ask of the same variant, which nobody was put, and of the numbers
# drawn for it
CLOSE = "close, but outside the tolerance"  # a guess that holds for the key of what was put alone
POLICY = """[questions.q1.asks.v_y]
accept = [{ value = "v_y - 5*v_x" }, { value = "100*r*omega", credit = "1/2" }]
"""


@pytest.fixture(scope="module")
def exam(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("pool")
    (folder / "crank.toml").write_text(crank_text(), encoding="utf-8")
    exam = set_exam(folder, BANK)
    pooled(exam, folder / "pool.zip", 4)
    (folder / "policy.toml").write_text(POLICY, encoding="utf-8")
    return exam


def speed(exam: Path, student: str) -> float:
    """r*omega on a student's line of the key."""
    for line in (exam / "key.jsonl").read_text(encoding="utf-8").splitlines():
        paper = json.loads(line)
        if paper["student"] == student:
            drawn = paper["questions"][0]["parameters"]
            return float(drawn["r"]["value"] * drawn["omega"]["value"])
    raise LookupError(student)


def answers(exam: Path, typed: dict[str, str]) -> str:
    """Everybody is put the second ask of another variant than the first; `typed` are answers to it,
    by student.
    """
    first, second = groups(exam.parent / "pool.zip")
    found = {}
    for place, student in enumerate(STUDENTS):
        one, other = (place + 1) % 4, (place + 2) % 4
        right = f"{float(second[other].right):.4f}"
        found[student] = [(one, first[one].right), (other, typed.get(student, right))]
    return analysis(exam.parent / "pool.zip", found)


def graded(exam: Path, folder: Path, typed: dict[str, str]) -> Path:
    (folder / "a.csv").write_text(answers(exam, typed), encoding="utf-8")
    options = ("--from", "canvas", "--policy", exam.parent / "policy.toml")
    done = kinegrade("grade", exam, folder / "a.csv", "-o", folder / "MARKS", *options)
    assert done.exit_code == 0, done.stderr
    return folder / "MARKS"


def test_what_a_policy_accepts_is_of_the_variant_and_of_no_other_paper(
    exam: Path, tmp_path: Path
) -> None:
    right = asks_of(exam)
    put = {student: STUDENTS[(place + 2) % 4] for place, student in enumerate(STUDENTS)}
    values = {
        student: right[put[student], "q1.v_y"]["value"] - 5 * right[put[student], "q1.v_x"]["value"]
        for student in STUDENTS
    }
    drawn, own = 100 * speed(exam, put["S2"]), 100 * speed(exam, "S3")
    typed = {"S1": f"{values['S1']:.4f}", "S2": f"{drawn:.4f}", "S3": f"{own:.4f}"}
    totals = table(graded(exam, tmp_path, typed) / "grades.csv")
    assert [row["total"] for row in totals] == ["3", "2", "1", "3"]


def test_the_report_explains_losses_by_what_was_put(exam: Path, tmp_path: Path) -> None:
    right = asks_of(exam)
    typed = {
        student: f"{1.03 * right[STUDENTS[(place + 2) % 4], 'q1.v_y']['value']:.4f}"
        for place, student in enumerate(STUDENTS)
    }
    marks = graded(exam, tmp_path, typed)
    done = kinegrade("report", exam, marks, "-o", tmp_path / "report.html")
    assert done.exit_code == 0, done.stderr
    page = (tmp_path / "report.html").read_text(encoding="utf-8")
    [row] = [row for row in re.findall("<tr>.*?</tr>", page, re.DOTALL) if CLOSE in row]
    assert re.findall(r">([0-9]+)<", row)[0] == "4"


def test_explain_names_the_paper_whose_numbers_were_put(exam: Path, tmp_path: Path) -> None:
    marks = graded(exam, tmp_path, {})
    told = kinegrade("explain", exam, marks, "S1", "q1.v_x").stdout
    assert "q1 came from a pool, with numbers of another paper" in told
    assert f"kinegrade paper --solution {exam} S2 -o S2-solution.pdf" in told
    assert "Paper: " not in told


def test_numbers_of_several_variants_are_no_numbers_of_one_question(
    exam: Path, tmp_path: Path
) -> None:
    """The report asks whether a drawn number made a question harder; here there were two of
    each.
    """
    marks = graded(exam, tmp_path, {})
    papers = PaperRecords(open_exam(exam), MarksFolder(marks).put)
    found = papers.marked("S1", ["q1.v_x", "q1.v_y"])
    assert [number for number in found.parameters.values() if not isnan(number)] == []
    assert {column: float(answer.value) for column, answer in found.answers.items()} == {
        "q1.v_x": asks_of(exam)["S2", "q1.v_x"]["value"],
        "q1.v_y": asks_of(exam)["S3", "q1.v_y"]["value"],
    }
