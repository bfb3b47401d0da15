"""`grade --pseudonymous`: nobody's name stands in the marks, and exports still have them."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.grading.marked_folder import RIGHT, mark_class
from tests.small_class import contents, kinegrade, table

NAMES = ("Student 007", "Student 0012")


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A class of two, marked with names (MARKS) and without (UNNAMED)."""
    mark_class(tmp_path, {"007": RIGHT, "0012": ("1.732", "9", "9")})
    files = tmp_path / "EXAM", tmp_path / "answers.csv", "-o", tmp_path / "UNNAMED"
    assert kinegrade("grade", *files, "--pseudonymous").exit_code in (0, 1)
    return tmp_path


def find_names(folder: Path) -> set[str]:
    everything = b"".join(contents(folder).values())
    return {name for name in NAMES if name.encode() in everything}


def test_names_are_left_out_and_points_are_the_same(folder: Path) -> None:
    assert find_names(folder / "MARKS") == {*NAMES}
    assert find_names(folder / "UNNAMED") == set()
    points = [
        [(row["student"], row["total"]) for row in table(folder / name / "grades.csv")]
        for name in ("MARKS", "UNNAMED")
    ]
    assert points[0] == points[1]


def test_explanation_and_comparison_name_nobody(folder: Path) -> None:
    exam, unnamed = folder / "EXAM", folder / "UNNAMED"
    assert NAMES[0] not in kinegrade("explain", exam, unnamed, "007").output
    assert NAMES[0] in kinegrade("explain", exam, folder / "MARKS", "007").output
    assert kinegrade("diff", unnamed, unnamed).exit_code == 0


def test_a_file_for_another_system_takes_names_from_the_exam(folder: Path) -> None:
    files = {}
    for name in ("MARKS", "UNNAMED"):
        target = folder / f"{name}.csv"
        to = "--to", "canvas", "--exam", folder / "EXAM", "-o", target
        done = kinegrade("export", folder / name, *to)
        assert done.exit_code in (0, 1), done.stderr
        files[name] = target.read_bytes()
    assert files["MARKS"] == files["UNNAMED"]
    assert NAMES[0].encode() in files["UNNAMED"]
