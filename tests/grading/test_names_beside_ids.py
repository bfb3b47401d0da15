"""The name, or a second id, beside an id: where it is that of somebody else in the class, the table
was sorted by one column alone, and the row may be anybody's.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.files.csv_writing import write_csv_text
from tests.small_class import generate, kinegrade, write_class

ZOE, WANG = "O'Neil, Zoë", "王伟"


@pytest.fixture(scope="module")
def exam(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """An exam of the small class."""
    folder = write_class(tmp_path_factory.mktemp("named"))
    assert generate(folder).exit_code == 0
    return folder / "EXAM"


def mark(exam: Path, folder: Path, header: list[str], rows: list[list[str]]) -> str:
    """What is said of a sheet in which each row has these cells, and one answer."""
    column = open_exam(exam).head.columns[0]
    text = write_csv_text([*header, column], [[*row, "1"] for row in rows])
    (folder / "answers.csv").write_text(text, encoding="utf-8")
    return kinegrade("grade", exam, folder / "answers.csv", "-o", folder / "MARKS").stderr


def test_names_that_were_sorted_away_from_their_ids_are_told(exam: Path, tmp_path: Path) -> None:
    said = mark(exam, tmp_path, ["student", "name"], [["007", ZOE], ["0012", WANG]])
    done = "by the id or code; correct the row if the name is right"
    for line, own, other in ((2, "007", "0012"), (3, "0012", "007")):
        whose = f'answers.csv:{line}: name: the name in this row is that of "{other}"'
        assert f'{whose} - marked as the paper of "{own}", {done}' in said


@pytest.mark.parametrize(
    ("header", "name"),
    [
        (["student", "First name", "Last name"], ["ZOE", "O'neil"]),
        (["student", "Vorname", "Name"], ["Zoë", "O'Neil"]),
        (["student", "Full name"], ["Zoë O'Neil"]),
    ],
)
def test_a_name_is_known_however_it_is_written(
    exam: Path, tmp_path: Path, header: list[str], name: list[str]
) -> None:
    assert 'name in this row is that of "0012"' in mark(exam, tmp_path, header, [["007", *name]])
    (tmp_path / "again").mkdir()
    said = mark(exam, tmp_path / "again", header, [["0012", *name]])
    assert "name in this row" not in said


@pytest.mark.parametrize(
    ("header", "own", "other"),
    [
        (["student", "student"], "007", "0012"),
        (["student", "ID number"], "0012", "007"),
        (["学号", "student"], "007", "0012"),
    ],
)
def test_a_second_column_of_ids_that_says_otherwise_is_told(
    exam: Path, tmp_path: Path, header: list[str], own: str, other: str
) -> None:
    said = mark(exam, tmp_path, header, [["007", "0012"]])
    [told] = [each for each in said.splitlines() if "the id in this column" in each]
    assert f'student: the id in this column is that of "{other}"' in told
    assert f'marked as the paper of "{own}", by another column of ids' in told


@pytest.mark.parametrize("name", ["", "Zoe", "Nobody Here", "王 伟"])
def test_a_name_that_nobody_else_has_is_not_told(exam: Path, tmp_path: Path, name: str) -> None:
    assert "name in this row" not in mark(exam, tmp_path, ["student", "name"], [["007", name]])


def test_points_by_hand_beside_the_name_of_another_are_refused(exam: Path, tmp_path: Path) -> None:
    mark(exam, tmp_path, ["student", "name"], [["007", WANG]])
    points = tmp_path / "points.csv"
    points.write_text(f"student,name,question,points\n0012,{WANG},q1,2\n", encoding="utf-8")
    place = "-o", tmp_path / "MARKS", "--force"
    result = kinegrade("grade", exam, tmp_path / "answers.csv", *place, "--manual", points)
    assert result.exit_code == 2
    what = f'{points}:2: the name in this row is that of "007"'
    assert f'{what} - correct the name or the id; the id is that of "0012"' in result.stderr
