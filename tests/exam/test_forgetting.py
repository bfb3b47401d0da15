"""`kinegrade forget`: nobody is left in an exam and its marks, and statistics are as before."""

from __future__ import annotations

import csv
import errno
import os
import re
import shutil
from pathlib import Path

import pytest

from kinegrade.exam.folder.exam_folder import open_exam
from tests.exam.test_own_questions import CAR
from tests.small_class import contents, kinegrade, table

ROSTER = """student,name,email,group,room
70011,Ada Lovelace,ada@example.org,A,Hall 7
70012,王伟,wei@example.org,B,Hall 7
70013,Grace Hopper,grace@example.org,B,Annex
"""
ANSWERS = """student,q1.v,q1.s
70011,10,25
70012,12,30
70013,"I am Grace",25
"""
PERSONAL = ("7001", "Ada", "Grace", "Lovelace", "王伟", "example.org", "Hall 7", "Annex", "secret")
APPEAL = '[questions.q1.asks.v]\naccept = [{ value = "12", student = ["70012"] }]\n'


@pytest.fixture(scope="module")
def forgotten(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with EXAM and MARKS of three, as they were (BEFORE) and as they are."""
    folder = tmp_path_factory.mktemp("forgotten")
    texts = {"bank.toml": CAR, "roster.csv": ROSTER, "answers.csv": ANSWERS, "appeal.toml": APPEAL}
    for name, text in texts.items():
        (folder / name).write_text(text, encoding="utf-8")
    exam = folder / "EXAM"
    made = kinegrade("generate", folder / "bank.toml", folder / "roster.csv", "-o", exam)
    assert made.exit_code == 0, made.stderr
    files = exam, folder / "answers.csv", "-o"
    kinegrade("grade", *files, folder / "FIRST")
    since = "--since", folder / "FIRST", "--reason", "Ada's letter", "--policy"
    kinegrade("grade", *files, folder / "MARKS", *since, folder / "appeal.toml")
    for name in ("EXAM", "MARKS"):
        shutil.copytree(folder / name, folder / "BEFORE" / name)
    done = kinegrade("forget", exam, folder / "MARKS", folder / "FIRST", "--yes")
    assert done.exit_code == 0, done.stderr
    assert f"{exam}: 3 people forgotten" in done.stderr
    return folder


def test_a_disk_that_is_full_is_told_of_in_one_line(
    forgotten: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The templates were copied by shutil, which has a list of refusals in place of one."""
    shutil.copytree(forgotten / "BEFORE", tmp_path, dirs_exist_ok=True)
    before = contents(tmp_path)

    def refuse(here: object, there: object, **_: object) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), str(there))

    with monkeypatch.context() as patched:
        patched.setattr(shutil, "copyfile", refuse)
        done = kinegrade("forget", tmp_path / "EXAM", tmp_path / "MARKS", "--yes")
    assert done.exit_code == 2
    (line,) = done.stderr.splitlines()
    assert line.startswith("error: ")
    assert "No space left on device" in line
    assert "[(" not in line
    assert contents(tmp_path) == before


@pytest.mark.parametrize("name", ["EXAM", "MARKS"])
def test_nobody_is_left(forgotten: Path, name: str) -> None:
    def find(folder: Path) -> set[str]:
        everything = b"".join(contents(folder).values())
        names = "".join(contents(folder))
        return {each for each in PERSONAL if each.encode() in everything or each in names}

    assert find(forgotten / "BEFORE" / name) >= {"7001", "Ada", "王伟"}
    assert find(forgotten / name) <= {"secret"}  # of which INSTRUCTOR-ONLY.txt warns
    assert open_exam(forgotten / "EXAM").head.drawn_from is None
    assert {each.paper for each in open_exam(forgotten / "EXAM").keys.lines()} == {""}


def test_points_verdicts_and_numbers_stay(forgotten: Path) -> None:
    def find(folder: Path) -> list[tuple[str, ...]]:
        columns = "question", "ask", "read_as", "verdict", "points", "out_of"
        return sorted(
            tuple(row[name] for name in columns) for row in table(folder / "MARKS" / "marks.csv")
        )

    assert find(forgotten) == find(forgotten / "BEFORE")
    totals = [
        sorted(row["total"] for row in table(folder / "MARKS" / "grades.csv"))
        for folder in (forgotten, forgotten / "BEFORE")
    ]
    assert totals[0] == totals[1] == ["2.5", "5.5", "5.5"]
    with (forgotten / "MARKS" / "changes.csv").open(encoding="utf-8") as lines:
        assert {row["reason"] for row in csv.DictReader(lines)} == {""}


def test_the_report_is_that_of_before(forgotten: Path) -> None:
    pages = []
    for folder in (forgotten, forgotten / "BEFORE"):
        page = folder / "report.html"
        done = kinegrade("report", folder / "EXAM", folder / "MARKS", "-o", page, "--force")
        assert done.exit_code == 0, done.stderr
        text = re.sub(r"<[^>]+>", " ", page.read_text(encoding="utf-8"))
        figures, complaints, _ = text.partition(" Complaints ")
        assert complaints
        pages.append(figures.split())
    assert {"81.8", "Groups"} <= {*pages[0]}
    assert pages[0] == pages[1]


def test_the_key_is_still_verified(forgotten: Path) -> None:
    done = kinegrade("verify", forgotten / "EXAM", "--all")
    assert done.exit_code == 0, done.stderr
    assert "3 of 3 papers solved again" in done.stderr


def test_without_yes_it_is_said_what_would_go_and_nothing_changes(forgotten: Path) -> None:
    before = contents(forgotten / "BEFORE")
    done = kinegrade("forget", forgotten / "BEFORE" / "EXAM", forgotten / "BEFORE" / "MARKS")
    assert done.exit_code == 0
    assert "would be deleted: answers.csv, answers.xlsx, key.pdf, papers, papers.pdf" in done.stderr
    assert "ids, names, addresses, codes" in done.stderr
    assert "everything typed in words would be removed" in done.stderr
    assert "cannot be undone" in done.stderr
    assert "add --yes" in done.stderr
    assert contents(forgotten / "BEFORE") == before


def test_a_second_time_is_refused_and_the_names_that_were_dealt_stay(
    forgotten: Path, tmp_path: Path
) -> None:
    for name in ("EXAM", "MARKS"):
        shutil.copytree(forgotten / name, tmp_path / name)
    before = contents(tmp_path)
    for marks in ((), (tmp_path / "MARKS",), (forgotten / "BEFORE" / "MARKS",)):
        done = kinegrade("forget", tmp_path / "EXAM", *marks, "--yes")
        assert done.exit_code == 2
        assert "EXAM: its people were forgotten already - expected" in done.stderr
        assert "restore the exam from its archive and name it with all its marks" in done.stderr
    assert contents(tmp_path) == before


def test_marks_beside_the_exam_are_named_too_before_anything_is_lost(
    forgotten: Path, tmp_path: Path
) -> None:
    shutil.copytree(forgotten / "BEFORE", tmp_path, dirs_exist_ok=True)
    before = contents(tmp_path)
    told = kinegrade("forget", tmp_path / "EXAM")
    assert told.exit_code == 0
    assert f"{tmp_path / 'MARKS'}: marks of this exam that are not named here" in told.stderr
    assert "name all at once" in told.stderr
    done = kinegrade("forget", tmp_path / "EXAM", "--yes")
    assert done.exit_code == 2
    assert f"marks of it beside it are not named: {tmp_path / 'MARKS'}" in done.stderr
    assert contents(tmp_path) == before


def test_files_of_ones_own_in_the_folder_are_not_lost(forgotten: Path, tmp_path: Path) -> None:
    shutil.copytree(forgotten / "BEFORE", tmp_path, dirs_exist_ok=True)
    (tmp_path / "MARKS" / "notes.txt").write_text("mine", encoding="utf-8")
    before = contents(tmp_path)
    done = kinegrade("forget", tmp_path / "EXAM", tmp_path / "MARKS", "--yes")
    assert done.exit_code == 2
    assert "notes.txt" in done.stderr
    assert contents(tmp_path) == before


def test_templates_that_share_a_mechanism_stay_with_it(tmp_path: Path) -> None:
    bank = '[[questions]]\ntemplate = "pose-four-bar-coupler"\n'
    (tmp_path / "bank.toml").write_text(f'title = "Poses"\ncourse = "M"\n{bank}', encoding="utf-8")
    (tmp_path / "roster.csv").write_text(ROSTER, encoding="utf-8")
    exam = tmp_path / "EXAM"
    files = tmp_path / "bank.toml", tmp_path / "roster.csv", "-o", exam
    assert kinegrade("generate", *files, "--no-papers").exit_code == 0
    before = {each for each in contents(exam) if "templates/" in each}
    done = kinegrade("forget", exam, "--yes")
    assert done.exit_code == 0, done.stderr
    assert {each for each in contents(exam) if "templates/" in each} == before
    assert any("mechanisms/" in each for each in before), before
    assert kinegrade("verify", exam, "--all").exit_code == 0


def test_a_term_says_which_marks_have_nobody_left(forgotten: Path, tmp_path: Path) -> None:
    known = tmp_path / "KNOWN"
    generated = "generate", forgotten / "bank.toml", forgotten / "roster.csv", "-o", tmp_path / "E"
    assert kinegrade(*generated).exit_code == 0
    kinegrade("grade", tmp_path / "E", forgotten / "answers.csv", "-o", known, "--own-papers")
    done = kinegrade("term", forgotten / "MARKS", known, "-o", tmp_path / "term.csv")
    assert done.exit_code == 1
    assert "MARKS: the people of these marks were forgotten (p1)" in done.stderr
    assert "KNOWN: the people" not in done.stderr
