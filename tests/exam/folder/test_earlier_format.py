"""An exam folder of version 0.1 goes through every command that takes one."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest

from tests.small_class import kinegrade, table

EARLIER = Path(__file__).parent.parent.parent / "data" / "exam-of-0.1"
ANSWERS = """student,name,q1.v_B,q1.a_B,q2.omega_AB,q2.alpha_AB
007,x,1.773,18.457,13.06,91.44
"""  # of which a_B has the wrong sign
NO_ROW = 1  # a complaint: the other student handed in nothing


@pytest.fixture(scope="module")
def marked(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """(EXAM, MARKS)"""
    folder = tmp_path_factory.mktemp("earlier")
    exam, marks = folder / "EXAM", folder / "MARKS"
    shutil.copytree(EARLIER, exam)
    (folder / "answers.csv").write_text(ANSWERS, encoding="utf-8")
    done = kinegrade("grade", exam, folder / "answers.csv", "-o", marks)
    assert done.exit_code == NO_ROW, done.stderr
    return exam, marks


def test_it_is_marked(marked: tuple[Path, Path]) -> None:
    rows = [row for row in table(marked[1] / "marks.csv") if row["student"] == "007"]
    assert [(row["ask"], row["verdict"]) for row in rows] == [
        ("v_B", "right"),
        ("a_B", "mistake"),
        ("omega_AB", "right"),
        ("alpha_AB", "right"),
    ]
    assert rows[0]["reason"] == "key 1.77284, difference 0.000163346, allowed 0.0177284"


def test_it_is_marked_by_a_policy_that_names_its_parameters(
    marked: tuple[Path, Path], tmp_path: Path
) -> None:
    policy, answers = tmp_path / "policy.toml", tmp_path / "answers.csv"
    policy.write_text(
        '[questions.q1.asks.v_B]\naccept = [{ value = "r*omega" }]\n', encoding="utf-8"
    )
    answers.write_text("student,q1.v_B\n007,2.45\n", encoding="utf-8")  # 0.35 m by 7 rad/s
    marks = tmp_path / "MARKS"
    kinegrade("grade", marked[0], answers, "-o", marks, "--policy", policy)
    assert table(marks / "marks.csv")[0]["verdict"] == "accepted"


@pytest.mark.parametrize(
    ("form", "file"), [("md", "007.md"), ("html", "007.html"), ("pdf", "007.pdf")]
)
def test_its_feedback_is_written(
    marked: tuple[Path, Path], tmp_path: Path, form: str, file: str
) -> None:
    done = kinegrade("feedback", *marked, "-o", tmp_path / "FEEDBACK", "--format", form)
    assert done.exit_code == 0, done.stderr
    sheet = (tmp_path / "FEEDBACK" / "sheets" / file).read_bytes()
    if form == "md":
        assert "# Resit: Feedback\n" in sheet.decode()
        assert r"$\frac{49}{40} + \frac{49 \sqrt{5}}{200}$ ≈ 1.77284" in sheet.decode()
        assert "Paper: **WJPK-SNPQ**" in sheet.decode()


def test_its_class_is_reported(marked: tuple[Path, Path], tmp_path: Path) -> None:
    page = tmp_path / "report.html"
    assert kinegrade("report", *marked, "-o", page).exit_code == 0
    assert "<title>Class report · Resit</title>" in page.read_text(encoding="utf-8")


def test_its_class_is_searched_for_sharing(marked: tuple[Path, Path], tmp_path: Path) -> None:
    found = kinegrade("sharing", *marked, "-o", tmp_path / "sharing.csv")
    assert found.exit_code == 0, found.stderr
    assert "of 2" in found.stderr


def test_its_grades_are_exported_by_the_addresses_it_keeps(
    marked: tuple[Path, Path], tmp_path: Path
) -> None:
    exam, marks = marked
    file = tmp_path / "moodle.csv"
    by_email = ("--to", "moodle", "--by", "email", "--exam", exam, "-o", file)
    done = kinegrade("export", marks, *by_email)
    assert done.exit_code == 0, done.stderr
    assert "wei@example.org" in file.read_text(encoding="utf-8")


@pytest.mark.parametrize("solutions", ["--solutions", "--no-solutions"])
@pytest.mark.parametrize("system", ["moodle-xml", "qti12", "qti21", "blackboard"])
def test_it_is_put_as_a_quiz(
    marked: tuple[Path, Path], tmp_path: Path, system: str, solutions: str
) -> None:
    quiz = tmp_path / "quiz"
    done = kinegrade("quiz", marked[0], "--to", system, solutions, "-o", quiz, "--jobs", "1")
    assert done.exit_code < 2, done.stderr  # 1 where a system cannot carry something
    assert quiz.stat().st_size > 1000


def test_its_papers_are_handed_out(marked: tuple[Path, Path], tmp_path: Path) -> None:
    exam = tmp_path / "EXAM"
    shutil.copytree(marked[0], exam)
    (exam / "papers").mkdir()
    for student in ("007", "0012"):
        (exam / "papers" / f"{student}.pdf").write_bytes(b"%PDF")
    assert kinegrade("papers", exam, "-o", tmp_path / "PAPERS").exit_code == 0
    assert sorted(file.name for file in (tmp_path / "PAPERS").iterdir()) == ["0012.pdf", "007.pdf"]


@pytest.mark.parametrize(
    "command",
    [
        ("grade", "EXAM", "answers.csv", "-o", "OUT"),
        ("feedback", "EXAM", "MARKS", "-o", "OUT"),
        ("report", "EXAM", "MARKS", "-o", "OUT"),
        ("sharing", "EXAM", "MARKS", "-o", "OUT"),
        ("export", "MARKS", "--to", "moodle", "--exam", "EXAM", "-o", "OUT"),
        ("quiz", "EXAM", "--to", "moodle-xml", "-o", "OUT"),
        ("papers", "EXAM", "-o", "OUT"),
    ],
    ids=lambda command: command[0],
)
def test_a_format_that_is_not_known_is_refused_by_every_command(
    marked: tuple[Path, Path], tmp_path: Path, command: tuple[str, ...]
) -> None:
    for folder in marked:
        shutil.copytree(folder, tmp_path / folder.name)
    (tmp_path / "answers.csv").write_text(ANSWERS, encoding="utf-8")
    head = tmp_path / "EXAM" / "exam.json"
    stated = json.loads(head.read_text(encoding="utf-8"))
    head.write_text(json.dumps({**stated, "format": 3}), encoding="utf-8")
    names = {"EXAM", "MARKS", "answers.csv", "OUT"}
    refused = kinegrade(*(tmp_path / each if each in names else each for each in command))
    assert refused.exit_code == 2
    assert refused.stderr == (
        f"error: {head}:1: format: 3 - expected 1 or 2, the only ones this kinegrade reads - "
        "use a kinegrade at least as new as the one that made the folder\n"
    )
    assert not (tmp_path / "OUT").exists()
