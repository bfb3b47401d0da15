"""Points by hand whose column was sorted alone are remarked on; whole rows in another order, and
points that stand in order by chance, are not.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import pytest

from tests.grading.by_hand.hand_marking import give
from tests.grading.marked_folder import RIGHT, mark_class

STUDENTS = [f"{1001 + place}" for place in range(12)]
POINTS = ["0", "2.5", "1", "2", "2.5", "0.5", "1", "0", "2", "1.5", "1", "2.5"]
SAID = (
    "the 12 points for q2 stand in order, beside students in the order of the roster - perhaps "
    "their column was sorted alone - they count as they stand; check the column"
)


def say(folder: Path, students: Sequence[str], points: Sequence[str]) -> str:
    """What marking says where these students have these points."""
    mark_class(folder, dict.fromkeys(STUDENTS, RIGHT))
    rows = (f"{student},q2,{each},\n" for student, each in zip(students, points, strict=True))
    marked = give(folder, "".join(rows))
    assert marked.exit_code == 0
    return marked.stderr


@pytest.mark.parametrize("falling", [False, True])
def test_points_that_were_sorted_alone_are_told(tmp_path: Path, falling: bool) -> None:
    said = say(tmp_path, STUDENTS, sorted(POINTS, key=float, reverse=falling))
    assert f"{tmp_path}/by-hand.csv: {SAID}" in said


def test_rows_that_were_sorted_whole_are_not_told(tmp_path: Path) -> None:
    rows = sorted(zip(POINTS, STUDENTS, strict=True), key=lambda row: float(row[0]))
    said = say(tmp_path, [student for _, student in rows], [each for each, _ in rows])
    assert "stand in order" not in said


def test_few_kinds_of_points_that_may_stand_so_by_chance_are_not_told(tmp_path: Path) -> None:
    said = say(tmp_path, STUDENTS, ["0"] * 3 + ["2.5"] * 9)
    assert "stand in order" not in said
