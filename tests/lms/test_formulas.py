"""No title runs as a formula when somebody opens an exported file in a spreadsheet; ids stay the
keys that they are.
"""

from __future__ import annotations

import csv
import io
from pathlib import Path

import pytest

from kinegrade.lms.grades.systems import SYSTEMS
from tests.grading.marked_folder import RIGHT, mark_class
from tests.lms.marked_folder import write_exam, write_marks
from tests.small_class import kinegrade

WITH_TITLES = [name for name in SYSTEMS if name not in ("blackboard", "edx")]
SIGNS = ["=", "+", "-", "@", "＝"]
ODD_IDS = {"0012345": "=7", "0012346": "+8", "0012347": "-9", "0012348": "@1"}


def cells(path: Path) -> list[list[str]]:
    text = path.read_text(encoding="utf-8-sig")
    return list(csv.reader(io.StringIO(text, newline="")))


def exported(folder: Path, system: str, *options: str | Path) -> list[list[str]]:
    out = folder / "out.csv"
    arguments = "--to", system, "-o", out, "--force", "--ungraded"
    result = kinegrade("export", folder / "MARKS", *arguments, *options)
    assert result.exit_code == 0, result.stderr
    return cells(out)


@pytest.mark.parametrize("sign", SIGNS)
@pytest.mark.parametrize("system", WITH_TITLES)
def test_a_title_is_no_formula(tmp_path: Path, system: str, sign: str) -> None:
    write_marks(tmp_path / "MARKS")
    header = exported(tmp_path, system, "--title", f"{sign}HYPERLINK(1)")[0]
    assert any(name.startswith(f"'{sign}HYPERLINK") for name in header), header
    assert not any(name.startswith(sign) for name in header), header


def test_the_title_of_an_exam_is_no_formula_for_any_question(tmp_path: Path) -> None:
    write_marks(tmp_path / "MARKS")
    exam = write_exam(tmp_path / "EXAM", title="=cmd|' /C calc'!A0")
    header = exported(tmp_path, "canvas", "--exam", exam, "--per-question")[0]
    assert header[-2:] == ["'=cmd|' /C calc'!A0 q1", "'=cmd|' /C calc'!A0 q2"]


def test_the_header_of_an_existing_item_is_a_key_and_stays(tmp_path: Path) -> None:
    write_marks(tmp_path / "MARKS")
    header = exported(tmp_path, "canvas", "--title", "x", "--column", "=Quiz (7)")[0]
    assert header[-1] == "=Quiz (7)"


@pytest.mark.parametrize("system", WITH_TITLES)
def test_ids_are_never_changed(tmp_path: Path, system: str) -> None:
    write_marks(tmp_path / "MARKS", students=ODD_IDS)
    rows = exported(tmp_path, system, "--title", "Quiz")[1:]
    known = {cell.removeprefix("#") for row in rows for cell in row}
    assert known >= set(ODD_IDS.values())


def test_ids_are_never_changed_in_a_list_of_changes(tmp_path: Path) -> None:
    answers = {"=7": RIGHT, "@x": ("1", "", "")}
    exam, marks = mark_class(tmp_path, answers)
    policy = tmp_path / "policy.toml"
    policy.write_text("[questions.q2]\nvoid = 'drop'\n", encoding="utf-8")
    again = "grade", exam, tmp_path / "answers.csv", "-o", tmp_path / "AGAIN", "--policy", policy
    assert kinegrade(*again).exit_code == 0
    out = tmp_path / "changes.csv"
    assert kinegrade("diff", marks, tmp_path / "AGAIN", "-o", out).exit_code == 0
    assert {row[0] for row in cells(out)[1:]} == set(answers)
