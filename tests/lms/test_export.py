"""`kinegrade export`: what is written, what is told, and with which exit status."""

from __future__ import annotations

from pathlib import Path

import pytest
from click.testing import Result
from openpyxl import load_workbook

from kinegrade.lms.grades.systems import SYSTEMS
from tests.lms.marked_folder import write_exam, write_marks
from tests.small_class import kinegrade

SAMPLE = Path(__file__).parent / "samples" / "moodle-gradebook-en.csv"


def export(folder: Path, *arguments: str | Path, name: str = "out.csv") -> Result:
    marks = folder / "MARKS"
    if not marks.exists():
        write_marks(marks)
        write_exam(folder / "EXAM")
    return kinegrade("export", marks, "-o", folder / name, *arguments)


@pytest.mark.parametrize(
    "system", [name for name in (*SYSTEMS, "xlsx") if name not in ("blackboard", "edx")]
)
def test_every_system_gets_a_file_from_scratch(tmp_path: Path, system: str) -> None:
    name = "out.xlsx" if system == "xlsx" else "out.csv"
    result = export(tmp_path, "--to", system, "--exam", tmp_path / "EXAM", name=name)
    assert (result.exit_code, result.stdout) == (0, "")
    assert (tmp_path / name).stat().st_size > 100


def test_it_says_who_is_left_alone(tmp_path: Path) -> None:
    assert (
        "out.csv: grades of 3 students for Moodle; 1 handed in nothing and is left alone"
        in export(tmp_path, "--to", "moodle").stderr
    )
    assert (
        "grades of 4 students for Moodle\n"
        in export(tmp_path, "--to", "moodle", "--ungraded", "--force").stderr
    )


def test_filling_in_with_complaints_ends_with_status_1(tmp_path: Path) -> None:
    result = export(
        tmp_path, "--to", "moodle", "--into", SAMPLE, "--by", "email", "--exam", tmp_path / "EXAM"
    )
    assert result.exit_code == 1
    assert (
        "complaint: moodle-gradebook-en.csv:4: no student of the marked class has Email address"
        in result.stderr
    )
    before, after = (
        SAMPLE.read_text(encoding="utf-8"),
        (tmp_path / "out.csv").read_text(encoding="utf-8"),
    )
    assert after == before.replace('2.94,"29.41 %",,', '4,"29.41 %",1: 4/7; 2: 0/3,', 1).replace(
        '5.29,"52.94 %",,', '8.25,"52.94 %",1: 7/7; 2: 1.25/3,'
    )


def test_questions_of_their_own(tmp_path: Path) -> None:
    assert (
        export(
            tmp_path,
            "--to",
            "canvas",
            "--per-question",
            "--column",
            "q1=A (1)",
            "--column",
            "q2=B=C (2)",
            "--title",
            "x",
        ).exit_code
        == 0
    )
    assert (
        (tmp_path / "out.csv")
        .read_text(encoding="utf-8")
        .splitlines()[0]
        .endswith(",A (1),B=C (2)")
    )


def test_a_spreadsheet_for_people(tmp_path: Path) -> None:
    assert (
        kinegrade(
            "export", write_marks(tmp_path / "M"), "--to", "xlsx", "-o", tmp_path / "m.xlsx"
        ).exit_code
        == 0
    )
    assert load_workbook(tmp_path / "m.xlsx")["grades"]["A2"].value == "0012345"


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (
            ("--to", "edx"),
            "error: Open edX: its rows are identified by numbers that only it assigns",
        ),
        (("--to", "canvas"), "error: Canvas: the item has no title"),
        (
            ("--to", "moodle", "--column", "a", "--column", "b"),
            "expected one for the total; several need --per-question",
        ),
        (
            ("--to", "moodle", "--per-question", "--column", "q9=a"),
            '"q9=a": expected QUESTION=HEADER, once for each of q1, q2',
        ),
        (
            ("--to", "moodle", "--maximum", "ten"),
            '"ten": expected a number above zero, like 10 or 12.5',
        ),
        (("--to", "moodle", "--maximum", "0"), '"0": expected a number above zero'),
        (
            ("--to", "xlsx", "--into", "a.csv"),
            "error: a.csv: cannot be read (No such file or directory) - expected a workbook",
        ),
        (("--to", "moodle", "--into", "missing.csv"), "error: missing.csv: cannot be read"),
    ],
)
def test_what_cannot_be_done_ends_with_status_2(
    tmp_path: Path, arguments: tuple[str, ...], message: str
) -> None:
    result = export(tmp_path, *arguments)
    assert result.exit_code == 2
    assert message in result.stderr
    assert not (tmp_path / "out.csv").exists()
