"""Feedback for a Moodle assignment and for mail merges. What Moodle does with the name of a file in
the zip (`mod/assign/feedback/file/importziplib.php`) is restated here.
"""

from __future__ import annotations

import csv
from pathlib import Path
from zipfile import ZipFile

import pytest
from click.testing import Result

from tests.small_class import kinegrade

WORKSHEET = """\ufeffIdentifier,Full name,Email address,Status,Grade,"Maximum grade"
Participant 901,王伟,WEI@example.org,,,10
"Participant 902","O'Neil, Zoë",0012,,,10
Participant 950,A stranger,other@example.org,,,10
"""
GERMAN = """ID;Vollständiger Name;E-Mail-Adresse;ID-Nummer
Teilnehmer/in901;王伟;wei@example.org;
Teilnehmer/in902;Zoë;;="0012"
"""


@pytest.fixture
def exam(small_class: Path, tmp_path: Path) -> Path:
    """The small class's exam, marked, beside MARKS."""
    marks = tmp_path / "MARKS"
    done = kinegrade("grade", small_class / "EXAM", small_class / "EXAM/answers.csv", "-o", marks)
    assert done.exit_code == 0, done.stderr
    return small_class / "EXAM"


def give_back(exam: Path, folder: Path, *options: str | Path) -> Result:
    """`kinegrade feedback` into FEEDBACK."""
    files = exam, folder / "MARKS", "-o", folder / "FEEDBACK", "--format", "md"
    return kinegrade("feedback", *files, *options)


def whose(path: str) -> tuple[int, str] | None:
    """The participant for whom Moodle takes a file of the zip, and the file's name there."""
    parts = path.split("/")
    while parts:
        pieces = parts.pop(0).split("_", 4)
        if len(pieces) < 4 or not pieces[1].isdigit():
            continue
        if pieces[2:4] != ["assignfeedback", "file"]:
            continue
        rest = pieces[4] if len(pieces) > 4 else ""
        return int(pieces[1]), "/".join([rest, *parts]).lstrip("/")
    return None


@pytest.mark.parametrize("text", [WORKSHEET, GERMAN])
def test_moodle_finds_whose_each_file_is(exam: Path, tmp_path: Path, text: str) -> None:
    worksheet = tmp_path / "worksheet.csv"
    worksheet.write_text(text, encoding="utf-8")
    done = give_back(exam, tmp_path, "--moodle", worksheet)
    packed = tmp_path / "FEEDBACK" / "moodle.zip"
    with ZipFile(packed) as archive:
        found = {whose(name): archive.read(name) for name in archive.namelist()}
    sheets = tmp_path / "FEEDBACK" / "sheets"
    assert found == {
        (901, "007.md"): (sheets / "007.md").read_bytes(),
        (902, "0012.md"): (sheets / "0012.md").read_bytes(),
    }
    assert f"{packed}: feedback of 2 students for Moodle" in done.stderr


def test_who_gets_no_file_is_said(exam: Path, tmp_path: Path) -> None:
    worksheet = tmp_path / "worksheet.csv"
    worksheet.write_text(WORKSHEET, encoding="utf-8")
    done = give_back(exam, tmp_path, "--moodle", worksheet)
    assert done.exit_code == 1
    assert 'worksheet.csv: no row for student "a/b", by address or id - gets no file' in done.stderr
    assert 'worksheet.csv:4: "Participant 950" is no student of this exam' in done.stderr
    again = give_back(exam, tmp_path, "--moodle", worksheet, "--force")
    assert again.exit_code == 1


def test_a_file_that_is_no_worksheet_is_refused(exam: Path, tmp_path: Path) -> None:
    done = give_back(exam, tmp_path, "--moodle", exam / "answers.csv")
    assert done.exit_code == 2
    assert "answers.csv: no row has the number of a participant in its first column" in done.stderr
    assert "expected the grading worksheet of a Moodle assignment - download it" in done.stderr
    assert not (tmp_path / "FEEDBACK").exists()


def test_a_mail_merge_is_told_who_gets_which_sheet(exam: Path, tmp_path: Path) -> None:
    listed = tmp_path / "send.csv"
    done = give_back(exam, tmp_path, "--send-list", listed)
    assert done.exit_code == 0, done.stderr
    assert f"{listed}: a row for each student, 1 with an address" in done.stderr
    with listed.open(encoding="utf-8-sig", newline="") as file:
        rows = list(csv.DictReader(file))
    assert [row["email"] for row in rows] == ["wei@example.org", "", "", ""]
    files = {Path(row["file"]) for row in rows}
    assert files == set((tmp_path / "FEEDBACK" / "sheets").resolve().iterdir())


def test_the_list_may_not_lie_among_the_sheets(exam: Path, tmp_path: Path) -> None:
    for place in ("FEEDBACK/send.csv", "FEEDBACK/sheets/send.csv"):
        done = give_back(exam, tmp_path, "--send-list", tmp_path / place)
        assert done.exit_code == 2
        assert "Traceback" not in done.stderr
        assert "would lie among" in done.stderr
        assert not (tmp_path / "FEEDBACK").exists()
