"""`kinegrade explain`: why a student's answers have the points they have.

The car starts with 2 m/s² and runs for 5 s: 10 m/s, 25 m.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.exam.test_own_questions import CAR, set_exam
from tests.small_class import kinegrade

ANSWERS = """student,q1.v,q1.s
1001,12,30
1002,12,"31,5 m"
1003,"1000 cm/s",50
"""
WIDER = "tolerance = { relative = 0.3 }\n"


@pytest.fixture(scope="module")
def car(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with EXAM and MARKS, and WIDE, marked by a policy that allows 30 %."""
    folder = tmp_path_factory.mktemp("car")
    exam = set_exam(folder, CAR)
    (folder / "answers.csv").write_text(ANSWERS, encoding="utf-8")
    (folder / "wider.toml").write_text(WIDER, encoding="utf-8")
    files = exam, folder / "answers.csv", "-o"
    kinegrade("grade", *files, folder / "MARKS")
    kinegrade("grade", *files, folder / "WIDE", "--policy", folder / "wider.toml")
    return folder


def explain(folder: Path, *arguments: str, marks: str = "MARKS") -> list[str]:
    """What is said, line by line, single-spaced."""
    done = kinegrade("explain", folder / "EXAM", folder / marks, *arguments)
    assert done.exit_code == 0, done.stderr
    return [" ".join(line.split()) for line in done.output.splitlines()]


def refusal(folder: Path, *arguments: str) -> str:
    """Why nothing is explained."""
    done = kinegrade("explain", folder / "EXAM", folder / "MARKS", *arguments)
    assert done.exit_code == 2
    assert not done.output or done.output == done.stderr
    return done.stderr


def test_what_was_typed_what_is_right_and_by_which_rule(car: Path) -> None:
    said = explain(car, "1002", "q1.s")
    assert 'typed "31,5 m"' in said
    assert "read as 31.5 m" in said
    assert "right answer 25 m" in said
    assert "rule 1 %, as on the paper: right from 24.75 to 25.25 m" in said
    assert "verdict wrong" in said
    assert "points 0 of 2.5" in said


def test_what_would_have_been_right_with_the_own_earlier_answer(car: Path) -> None:
    would = "carried on with the student's own q1.v = 12, 30 m would follow: from 29.7 to 30.3 m"
    for student, points in (("1001", "2.5 of 2.5"), ("1002", "0 of 2.5")):
        said = explain(car, student, "q1.s")
        assert would in said
        assert f"points {points}" in said


def test_a_mistake_is_named_in_its_own_words_and_nothing_follows_from_right_answers(
    car: Path,
) -> None:
    said = explain(car, "1003")
    assert "mistake It is not at its final speed all the time." in said
    assert "points 1.25 of 2.5" in said
    assert not [line for line in said if line.startswith("carried on")]


def test_the_rule_of_a_policy_is_told_apart_from_that_of_the_paper(car: Path) -> None:
    said = explain(car, "1002", "1.s", marks="WIDE")
    by_policy = "rule 30 %, by the policy and not as on the paper: right from 17.5 to 32.5 m"
    assert by_policy in said
    assert "verdict right" in said


def test_what_a_hand_gave_is_told_beside_the_machine_and_may_be_asked_for(car: Path) -> None:
    (car / "manual.csv").write_text(
        "student,question,points,comment\n1002,q1.v,1,work shown\n1002,bonus,2,\n",
        encoding="utf-8",
    )
    files = car / "EXAM", car / "answers.csv", "-o", car / "HANDS"
    kinegrade("grade", *files, "--manual", car / "manual.csv")
    said = explain(car, "1002", marks="HANDS")
    place = said.index("Marked by hand")
    assert said[place + 1].startswith("q1.v 1 of ")
    assert said[place + 1].endswith("; in place of 0 by the machine; work shown")
    assert said[place + 2] == "bonus 2 on top of everything"
    alone = explain(car, "1002", "bonus", marks="HANDS")
    assert "bonus 2 on top of everything" in alone
    assert [line for line in alone if "q1.v" in line] == []


def test_the_code_of_a_paper_stands_for_its_student(car: Path) -> None:
    head, *_ = explain(car, "1001")
    assert head.endswith(": 2.5 of 5.5 points")
    code = head.partition("paper ")[2].partition(":")[0]
    assert explain(car, code.lower().replace("-", " ")) == explain(car, "1001")


def test_paper_and_solution_are_named_by_file_or_by_the_command_that_makes_them(car: Path) -> None:
    *_, paper, solution = explain(car, "1001")
    assert Path(paper.removeprefix("Paper: ")).is_file()
    command = solution.removeprefix("To print the worked solution: kinegrade ").split()
    where = car / "solution.pdf"
    done = kinegrade(*[str(where) if word.endswith(".pdf") else word for word in command])
    assert done.exit_code == 0, done.stderr
    assert where.read_bytes().startswith(b"%PDF")


@pytest.mark.parametrize(
    ("language", "line"),
    [("zh_CN", "错误 平均速度是末速度的一半。"), ("de_DE", "richtig ist 25 m")],
)
def test_it_is_said_in_the_language_of_the_terminal(
    car: Path, monkeypatch: pytest.MonkeyPatch, language: str, line: str
) -> None:
    monkeypatch.setenv("LC_ALL", f"{language}.UTF-8")
    assert line in explain(car, "1003", "q1.s")


def test_whom_and_what_nobody_has_is_refused_with_what_is_near(car: Path) -> None:
    assert "no student" in refusal(car, "1009")
    assert "expected the id of a student, or the code of a paper" in refusal(car, "1009")
    said = refusal(car, "1001", "q1.w")
    assert 'the paper of "1001" has no "q1.w" - expected a question as in the answer sheet' in said
    assert "q1.v" in said


def test_marks_of_another_class_by_an_earlier_version_are_refused(
    car: Path, tmp_path: Path
) -> None:
    other = set_exam(tmp_path, CAR)
    (tmp_path / "answers.csv").write_text(ANSWERS, encoding="utf-8")
    kinegrade("grade", other, tmp_path / "answers.csv", "-o", tmp_path / "MARKS")
    marks = tmp_path / "MARKS"
    (marks / "exam.csv").unlink()  # which such marks do not have
    for file in ("marks.csv", "grades.csv"):
        text = (marks / file).read_text(encoding="utf-8")
        (marks / file).write_text(text.replace("1003", "2003"), encoding="utf-8")
    done = kinegrade("explain", car / "EXAM", marks, "1003")
    assert done.exit_code == 2
    assert 'student "1003" has no marks there - name the folder by which they were made' in (
        done.stderr
    )
