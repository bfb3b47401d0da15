"""A unit in the header of an answer sheet that is not the exam's: the numbers below it are in it."""

from __future__ import annotations

from pathlib import Path

import pytest

from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.files.csv_writing import write_csv_text
from tests.small_class import asks_of, generate, kinegrade, table, write_class


@pytest.fixture(scope="module")
def exam(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """An exam of the small class, whose first ask is a velocity in m/s."""
    folder = write_class(tmp_path_factory.mktemp("units"))
    assert generate(folder).exit_code == 0
    return folder / "EXAM"


def mark(exam: Path, folder: Path, title: str, factor: float) -> tuple[str, str]:
    """The verdict on a right first answer times a factor, under a header of that title; and what
    is said.
    """
    student, column = "0012", open_exam(exam).head.columns[0]
    right = float(asks_of(exam)[student, column]["value"])
    rows = [[student, f"{factor * right:.6g}"]]
    text = write_csv_text(["student", title], rows)
    (folder / "answers.csv").write_text(text, encoding="utf-8")
    done = kinegrade("grade", exam, folder / "answers.csv", "-o", folder / "MARKS")
    lines = table(folder / "MARKS" / "marks.csv")
    [verdict] = [row["verdict"] for row in lines if row["response"]]
    return verdict, done.stderr


@pytest.mark.parametrize(
    ("title", "factor"),
    [
        ("q1.v_B (cm/s)", 100),
        ("q1.v_B [km/h]", 3.6),
        ("Q1.v_b (mm/s)", 1000),
        ("q1.v_B (m·s⁻¹)", 1),
        ("q1.v_B (-)", 1),
    ],
)
def test_numbers_are_in_the_unit_of_their_header(
    exam: Path, tmp_path: Path, title: str, factor: float
) -> None:
    verdict, said = mark(exam, tmp_path, title, factor)
    assert verdict == "right"
    assert "no unit" not in said


def test_a_unit_that_cannot_be_converted_is_told(exam: Path, tmp_path: Path) -> None:
    verdict, said = mark(exam, tmp_path, "q1.v_B (3 points)", 1)
    assert verdict == "right"
    assert (
        'q1.v_B (3 points): "3 points" is no unit that can be converted into m/s - numbers without '
        "a unit are read in m/s"
    ) in said
