"""Full points for a void ask: for everyone who handed in, and said where a hand gave less."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.exam.test_by_hand import CRANK, SLEEVE, THEORY, mark_right, set_exam
from tests.small_class import kinegrade, table

VOID = "[questions.q1]\nvoid = 'full'\n"
HEAD = "student,question,points,comment\n"


@pytest.fixture(scope="module")
def exam(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """EXAM with a question of 3 points, one of 2.5 by hand and one of 4; 1001 has a row of blanks,
    1002 answered the last question.
    """
    folder = tmp_path_factory.mktemp("void")
    assert set_exam(folder, CRANK + THEORY + SLEEVE, "--no-papers").exit_code == 0
    mark_right(folder)
    _, key = table(folder / "answers.csv")
    rows = f"student,q1.v_B,q3.omega_AB\n1001,,\n1002,,{key['q3.omega_AB']}\n"
    (folder / "answers.csv").write_text(rows, encoding="utf-8")
    (folder / "void.toml").write_text(VOID, encoding="utf-8")
    return folder


def grade(folder: Path, place: Path, by_hand: str = "") -> tuple[list[tuple[str, ...]], list[str]]:
    """Points for the void question, total and status of each; and what was said."""
    hand = place.with_suffix(".csv")
    hand.write_text(HEAD + by_hand, encoding="utf-8")
    options = "-o", place, "--policy", folder / "void.toml", "--manual", hand
    done = kinegrade("grade", folder / "EXAM", folder / "answers.csv", *options)
    assert done.exit_code in (0, 1), done.stderr
    rows = table(place / "grades.csv")
    found = [(row["q1"], row["total"], row["status"]) for row in rows]
    return found, done.stderr.splitlines()


def test_whoever_is_absent_gets_nothing_though_a_blank_row_was_typed(
    exam: Path, tmp_path: Path
) -> None:
    grades, _ = grade(exam, tmp_path / "MARKS")
    assert grades == [("0", "0", "absent"), ("3", "7", "marked")]


def test_whoever_wrote_words_alone_handed_in(exam: Path, tmp_path: Path) -> None:
    grades, _ = grade(exam, tmp_path / "MARKS", "1001,q2,0,\n1002,q2,2.5,\n")
    assert grades == [("3", "3", "marked"), ("3", "9.5", "marked")]


@pytest.mark.parametrize("column", ["q1.v_B", "q1"])
def test_a_mark_by_hand_that_gives_less_is_named(exam: Path, tmp_path: Path, column: str) -> None:
    grades, said = grade(exam, tmp_path / "MARKS", f"1002,{column},1.5,\n")
    assert grades[1] == ("1.5", "5.5", "marked")
    assert [line for line in said if "1002" in line] == [
        f'complaint: manual.csv: {column}: "1002": 1.5 by hand where everybody who handed in gets 3'
        " - the mark by hand stands - to take it back, delete its row in manual.csv and grade again"
    ]
    assert not any("1002" in line for line in grade(exam, tmp_path / "MORE", "1002,q1,3,\n")[1])
