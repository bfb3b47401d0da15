"""Full points for a void ask: for everyone who handed in, and said where a hand gave less."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.exam.test_by_hand import CRANK, SLEEVE, THEORY, mark_right, set_exam
from tests.small_class import kinegrade, table

VOID = "[questions.q1]\nvoid = 'full'\n"
PARTLY = "[questions.q4.asks.v_B]\nvoid = 'full'\n"
TWO = """
[[questions]]
template = "slider-crank"
asks = { v_B = 3, omega_AB = 2 }
"""
HEAD = "student,question,points,comment\n"


@pytest.fixture(scope="module")
def exam(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """EXAM with questions of 3 points, of 2.5 by hand, of 4, and of 3 and 2; 1001 has a row of
    blanks, 1002 answered the third and half of the fourth.
    """
    folder = tmp_path_factory.mktemp("void")
    assert set_exam(folder, CRANK + THEORY + SLEEVE + TWO, "--no-papers").exit_code == 0
    mark_right(folder)
    _, key = table(folder / "answers.csv")
    header = "student,q1.v_B,q3.omega_AB,q4.omega_AB"
    rows = f"{header}\n1001,,,\n1002,,{key['q3.omega_AB']},{key['q4.omega_AB']}\n"
    (folder / "answers.csv").write_text(rows, encoding="utf-8")
    (folder / "void.toml").write_text(VOID, encoding="utf-8")
    (folder / "partly.toml").write_text(PARTLY, encoding="utf-8")
    return folder


def grade(
    folder: Path, place: Path, by_hand: str = "", policy: str = "void.toml"
) -> tuple[list[tuple[str, ...]], list[str]]:
    """Points for the void question, total and status of each; and what was said."""
    hand = place.with_suffix(".csv")
    hand.write_text(HEAD + by_hand, encoding="utf-8")
    options = "-o", place, "--policy", folder / policy, "--manual", hand
    done = kinegrade("grade", folder / "EXAM", folder / "answers.csv", *options)
    assert done.exit_code in (0, 1), done.stderr
    rows = table(place / "grades.csv")
    found = [(row["q1"], row["total"], row["status"]) for row in rows]
    return found, done.stderr.splitlines()


def test_whoever_is_absent_gets_nothing_though_a_blank_row_was_typed(
    exam: Path, tmp_path: Path
) -> None:
    grades, _ = grade(exam, tmp_path / "MARKS")
    assert grades == [("0", "0", "absent"), ("3", "9", "marked")]


def test_whoever_wrote_words_alone_handed_in(exam: Path, tmp_path: Path) -> None:
    grades, _ = grade(exam, tmp_path / "MARKS", "1001,q2,0,\n1002,q2,2.5,\n")
    assert grades == [("3", "3", "marked"), ("3", "11.5", "marked")]


@pytest.mark.parametrize("column", ["q1.v_B", "q1"])
def test_a_mark_by_hand_that_gives_less_is_named(exam: Path, tmp_path: Path, column: str) -> None:
    grades, said = grade(exam, tmp_path / "MARKS", f"1002,{column},1.5,\n")
    assert grades[1] == ("1.5", "7.5", "marked")
    assert [line for line in said if "1002" in line] == [
        f'complaint: manual.csv: {column}: "1002": 1.5 by hand where everybody who handed in gets 3 '
        "for q1.v_B - the mark by hand stands - to take it back, delete its row in manual.csv and "
        "grade again"
    ]
    assert [
        line for line in grade(exam, tmp_path / "MORE", "1002,q1,3,\n")[1] if "1002" in line
    ] == []


def test_what_everybody_gets_of_a_question_is_what_is_void_in_it(
    exam: Path, tmp_path: Path
) -> None:
    given = "1001,q4,2.5,\n1002,q4,3,\n"
    _, said = grade(exam, tmp_path / "MARKS", given, "partly.toml")
    told = [line for line in said if "by hand where" in line]
    assert [line.partition(" - ")[0] for line in told] == [
        'complaint: manual.csv: q4: "1001": 2.5 by hand where everybody who handed in gets 3 '
        "for q4.v_B"
    ]
