"""A folder of marks that somebody changed: refused in one line, with the line that is at fault."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from tests.small_class import kinegrade


@pytest.mark.parametrize("number", ["12a", "1e9999999999", "nan"])
@pytest.mark.parametrize("column", ["read_as", "points"])
def test_a_number_in_marks_that_is_none_is_refused_with_its_line(
    small_class: Path, tmp_path: Path, number: str, column: str
) -> None:
    answers, marks = tmp_path / "answers.csv", tmp_path / "MARKS"
    answers.write_text("student,q1.v_B\n007,12.5\n0012,1\na/b,1\n=2,1\n", encoding="utf-8")
    kinegrade("grade", small_class / "EXAM", answers, "-o", marks)
    lines = (marks / "marks.csv").read_text(encoding="utf-8").splitlines()
    cells = lines[1].split(",")
    cells[lines[0].split(",").index(column)] = number
    (marks / "marks.csv").write_text("\n".join([lines[0], ",".join(cells), *lines[2:]]) + "\n")
    copied = shutil.copytree(marks, tmp_path / "CHANGED")
    result = kinegrade("report", small_class / "EXAM", copied, "-o", tmp_path / "report.html")
    assert result.exit_code == 2
    assert "marks.csv:2: " in result.stderr
    assert f'"{number}"' in result.stderr
    assert result.stderr.count("\n") == 1
    assert not (tmp_path / "report.html").exists()
