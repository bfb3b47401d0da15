"""`kinegrade papers`: what students may have, and nothing that gives the key away."""

from __future__ import annotations

import csv
import json
import os
import shutil
import stat
from pathlib import Path

import pytest

from kinegrade.exam.folder.exam_folder import open_exam
from tests.small_class import contents, generate, kinegrade, table, write_short_class

FILES = ["%3D2.pdf", "0012.pdf", "007.pdf", "a%2Fb.pdf"]


@pytest.fixture
def exam(small_class: Path, tmp_path: Path) -> Path:
    """A copy of the small exam, with a paper in two further kinds, and with things that nobody may
    see.
    """
    shutil.copytree(small_class / "EXAM", tmp_path / "EXAM")
    papers = tmp_path / "EXAM" / "papers"
    (papers / "007.docx").write_bytes(b"docx")
    (papers / "007.html").write_bytes(b"html")
    (papers / "key.pdf").write_bytes(b"the key")
    (papers / "notes.txt").write_text("answers", encoding="utf-8")
    return tmp_path / "EXAM"


def refusal(*arguments: str | Path) -> str:
    result = kinegrade("papers", *arguments)
    assert result.exit_code == 2
    (line,) = result.stderr.splitlines()
    return line


def test_students_get_their_papers_and_nothing_that_gives_the_key_away(
    exam: Path, tmp_path: Path
) -> None:
    result = kinegrade("papers", exam, "-o", tmp_path / "OUT")
    assert result.exit_code == 0
    assert "OUT: 4 papers, and nothing that gives the key away" in result.stderr
    found = contents(tmp_path / "OUT")
    assert sorted(found) == sorted([*FILES, "007.docx", "007.html"])
    assert found["007.pdf"] == (exam / "papers" / "007.pdf").read_bytes()


@pytest.mark.skipif(os.name != "posix", reason="modes of POSIX")
def test_what_is_handed_out_can_be_read_by_others(exam: Path, tmp_path: Path) -> None:
    before = os.umask(0o022)
    try:
        assert kinegrade("papers", exam, "-o", tmp_path / "OUT").exit_code == 0
    finally:
        os.umask(before)
    entries = (tmp_path / "OUT", tmp_path / "OUT" / "007.pdf")
    assert [stat.S_IMODE(entry.stat().st_mode) for entry in entries] == [0o755, 0o644]


@pytest.mark.parametrize("place", ["EXAM", "EXAM/out", "EXAM/papers", ".", "EXAM/../EXAM/x"])
def test_nothing_is_written_into_the_exam_or_around_it(
    exam: Path, tmp_path: Path, place: str
) -> None:
    before = contents(tmp_path)
    line = refusal(exam, "-o", tmp_path / place, "--force")
    assert "is, holds or lies in the exam folder" in line
    assert contents(tmp_path) == before


def test_papers_handed_out_before_are_replaced_on_demand_only(exam: Path, tmp_path: Path) -> None:
    out = tmp_path / "OUT"
    assert kinegrade("papers", exam, "-o", out).exit_code == 0
    assert "OUT: already exists" in refusal(exam, "-o", out)
    (out / "007.pdf").write_bytes(b"old")
    assert kinegrade("papers", exam, "-o", out, "--force").exit_code == 0
    assert (out / "007.pdf").read_bytes().startswith(b"%PDF")
    (out / "thesis.pdf").write_bytes(b"mine")
    assert "holds thesis.pdf, which would be lost" in refusal(exam, "-o", out, "--force")


def test_a_paper_that_is_missing_is_named(exam: Path, tmp_path: Path) -> None:
    (exam / "papers" / "0012.pdf").unlink()
    line = refusal(exam, "-o", tmp_path / "OUT")
    assert "0012.pdf: cannot be read (No such file or directory) - expected the paper of" in line
    assert not (tmp_path / "OUT").exists()


@pytest.mark.parametrize("file", ["key.pdf", "papers/../key.pdf", "/etc/passwd", 7, None])
def test_a_folder_that_names_other_files_as_papers_hands_out_nothing(
    exam: Path, tmp_path: Path, file: object
) -> None:
    head = json.loads((exam / "exam.json").read_text(encoding="utf-8"))
    head["students"][0]["file"] = file
    (exam / "exam.json").write_text(json.dumps(head), encoding="utf-8")
    line = refusal(exam, "-o", tmp_path / "OUT")
    assert "exam.json: the paper" in line or "exam.json:1: students[1]: is broken" in line
    assert line.endswith("restore the exam folder as it was generated")
    assert not (tmp_path / "OUT").exists()


def test_a_folder_that_is_no_exam_hands_out_nothing(tmp_path: Path) -> None:
    (tmp_path / "MARKS").mkdir()
    line = refusal(tmp_path / "MARKS", "-o", tmp_path / "OUT")
    assert "expected an exam folder made by kinegrade generate" in line


def test_a_link_in_a_strangers_folder_hands_nothing_else_out(exam: Path, tmp_path: Path) -> None:
    paper = exam / "papers" / "007.pdf"
    paper.unlink()
    paper.symlink_to(exam / "key.pdf")
    assert refusal(exam, "-o", tmp_path / "OUT") == (
        f"error: {paper}: is a link - expected the paper of a student, as a link may lead to what "
        "is not for students - restore the exam folder"
    )
    assert not (tmp_path / "OUT").exists()


def test_marks_in_place_of_the_exam_are_named(tmp_path: Path) -> None:
    marks = tmp_path / "MARKS"
    marks.mkdir()
    (marks / "marks.csv").write_text("student\n", encoding="utf-8")
    assert refusal(marks, "-o", tmp_path / "OUT") == (
        f"error: {marks}: you gave MARKS where EXAM is expected - expected an exam folder made by "
        "kinegrade generate - name that folder"
    )


def test_a_list_for_mail_merges_says_whose_each_file_is(small_class: Path, tmp_path: Path) -> None:
    folder, listed = tmp_path / "PAPERS", tmp_path / "send.csv"
    options = ("-o", folder, "--send-list", listed)
    result = kinegrade("papers", small_class / "EXAM", *options)
    assert result.exit_code == 0
    assert f"{listed}: a row for each student, 1 with an address" in result.stderr
    with listed.open(encoding="utf-8-sig", newline="") as file:
        rows = list(csv.DictReader(file))
    assert [row["email"] for row in rows] == ["wei@example.org", "", "", ""]
    assert rows[0]["student"] == "007"
    assert rows[3]["student"] == "'=2"  # no spreadsheet works it out
    assert [row for row in rows if not Path(row["file"]).is_file()] == []
    assert {Path(row["file"]) for row in rows} == set(folder.resolve().glob("*.pdf"))


def test_spare_papers_are_handed_out_with_the_others(tmp_path: Path) -> None:
    made, out = write_short_class(tmp_path), tmp_path / "OUT"
    assert generate(made, "EXAM", "--spare", "2").exit_code == 0
    exam = made / "EXAM"
    listed = tmp_path / "send.csv"
    result = kinegrade("papers", exam, "-o", out, "--send-list", listed)
    said = "OUT: 6 papers, and nothing that gives the key away; the spare ones are spare-1.pdf, "
    assert f"{said}spare-2.pdf" in result.stderr
    assert sorted(contents(out)) == sorted([*FILES, "spare-1.pdf", "spare-2.pdf"])
    assert (out / "spare-1.pdf").read_bytes() == (exam / "papers" / "spare-1.pdf").read_bytes()
    assert [row["student"] for row in table(listed)] == ["007", "0012", "a/b", "'=2"]
    code = open_exam(exam).head.spares[0].paper
    assert kinegrade("assign", exam, code, "0099").exit_code == 0
    again = kinegrade("papers", exam, "-o", out, "--force")
    assert again.exit_code == 0, again.stderr
    assert sorted(contents(out)) == sorted([*FILES, "0099.pdf", "spare-2.pdf"])


def test_the_list_may_not_lie_among_the_papers(small_class: Path, tmp_path: Path) -> None:
    folder = tmp_path / "PAPERS"
    options = ("-o", folder, "--send-list", folder / "send.csv")
    result = kinegrade("papers", small_class / "EXAM", *options)
    assert result.exit_code == 2
    (tmp_path / "TAKEN").mkdir()
    (tmp_path / "TAKEN" / "mine.txt").write_text("mine", encoding="utf-8")
    taken = ("-o", tmp_path / "TAKEN", "--send-list", tmp_path / "send.csv")
    assert kinegrade("papers", small_class / "EXAM", *taken).exit_code == 2
    assert not (tmp_path / "send.csv").exists()
    assert "would lie among the files" in result.stderr
    assert not folder.exists()
