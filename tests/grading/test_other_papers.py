"""A marking by the wrong papers stops, and one of a hard exam does not."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.small_class import STUDENTS, asks_of, kinegrade


def sheet(exam: Path, folder: Path, whose: dict[str, str], spoiled: str, wrong: str) -> Path:
    """An answer sheet in which everybody answers somebody's paper, but for the asks `spoiled`."""
    asks = asks_of(exam)
    columns = list(dict.fromkeys(column for _, column in asks))
    lines = [",".join(["student", *columns])]
    for student, other in whose.items():
        cells = [
            wrong if column in spoiled.split() else f"{float(asks[other, column]['value']):.5g}"
            for column in columns
        ]
        lines.append(",".join([student, *cells]))
    file = folder / "answers.csv"
    file.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return file


ORDER = dict(zip(STUDENTS, (*STUDENTS[1:], STUDENTS[0]), strict=True))
OWN = dict(zip(STUDENTS, STUDENTS, strict=True))
ALL = "q1.v_B q1.a_B q2.v_x q2.v_y q3.omega_AB q3.alpha_AB"


@pytest.mark.parametrize("spoiled", ["", "q1.a_B", "q3.alpha_AB"])
def test_papers_in_another_order_stop_the_marking_though_students_err(
    small_class: Path, tmp_path: Path, spoiled: str
) -> None:
    exam = small_class / "EXAM"
    answers = sheet(exam, tmp_path, ORDER, spoiled, "77.7")
    refused = kinegrade("grade", exam, answers, "-o", tmp_path / "MARKS")
    assert refused.exit_code == 2
    assert "most are right on other papers of this exam - expected each student's answers to " in (
        refused.stderr
    )
    assert not (tmp_path / "MARKS").exists()


@pytest.mark.parametrize(
    ("whose", "spoiled"), [(OWN, ALL), (OWN, "q1.v_B q1.a_B q2.v_y q3.omega_AB"), (OWN, "")]
)
def test_a_hard_exam_is_marked(
    small_class: Path, tmp_path: Path, whose: dict[str, str], spoiled: str
) -> None:
    exam = small_class / "EXAM"
    answers = sheet(exam, tmp_path, whose, spoiled, "77.7")
    assert kinegrade("grade", exam, answers, "-o", tmp_path / "MARKS").exit_code == 0


def test_a_row_that_slipped_by_a_line_names_whose_answers_it_holds(
    small_class: Path, tmp_path: Path
) -> None:
    exam, slipped = small_class / "EXAM", {STUDENTS[2]: STUDENTS[1]}
    answers = sheet(exam, tmp_path, OWN | slipped, "", "")
    marked = kinegrade("grade", exam, answers, "-o", tmp_path / "MARKS")
    assert marked.exit_code == 1
    complaints = (tmp_path / "MARKS/complaints.csv").read_text(encoding="utf-8")
    assert complaints.count("perhaps the rows slipped") == 1
    assert (
        f"all numbers of student {quoted(STUDENTS[2])} are right on the paper of student"
        f" {quoted(STUDENTS[1])}, and not on the own one - perhaps the rows slipped,"
        " or papers were mixed up"
    ) in complaints.replace('""', '"')
    spoiled = sheet(exam, tmp_path, OWN | slipped, "q1.v_B", "77.7")
    marked = kinegrade("grade", exam, spoiled, "-o", tmp_path / "MARKS", "--force")
    assert "perhaps the rows slipped" not in marked.output


def quoted(student: str) -> str:
    return f'"{student}"'
