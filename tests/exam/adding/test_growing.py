"""`kinegrade generate --add`: late students get papers of an exam that exists, and no other
paper changes.
"""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest
from openpyxl import load_workbook

from tests.exam.adding.growing_class import (
    CLASS,
    LATE,
    REWRITTEN,
    add,
    added,
    drawn,
    generate,
    generated,
    pages,
    refused,
    roster,
    write,
)
from tests.small_class import contents, key_lines, kinegrade, table


def test_nothing_else_changes(grown: Path) -> None:
    before, after = contents(grown / "EXAM-BEFORE"), contents(grown / "EXAM")
    new = {f"{kind}/{name}.pdf" for kind in ("papers", "solutions") for name in ("late1", "%3D2")}
    assert after.keys() == before.keys() | new
    assert {name for name in before if before[name] != after[name]} == REWRITTEN
    assert after["key.jsonl"].startswith(before["key.jsonl"])
    assert after["answers.csv"].startswith(before["answers.csv"])


def test_the_books_have_the_pages_of_all(grown: Path) -> None:
    for name in ("papers", "solutions"):
        before, after = (pages(grown / exam / f"{name}.pdf") for exam in ("EXAM-BEFORE", "EXAM"))
        assert after[: len(before)] == before
        first = pages(grown / "EXAM" / name / "late1.pdf")
        assert after[len(before) : len(before) + len(first)] == first
    key = " ".join(pages(grown / "EXAM" / "key.pdf"))
    codes = [line["paper"] for line in key_lines(grown / "EXAM")]
    assert len(set(codes)) == 5
    assert [code for code in codes if code not in key] == []


def test_late_students_stand_last_in_head_and_sheets(grown: Path) -> None:
    head = json.loads((grown / "EXAM" / "exam.json").read_text(encoding="utf-8"))
    students = [*CLASS, *LATE]
    assert [each["student"] for each in head["students"]] == students
    sheet = table(grown / "EXAM" / "answers.csv")
    assert [(row["student"], row["name"]) for row in sheet[3:]] == [
        ("late1", "Li, Late"),
        ("=2", "'=Later"),
    ]
    book = load_workbook(grown / "EXAM" / "answers.xlsx").active
    assert book is not None
    assert [row[0].value for row in book.iter_rows(min_row=3)] == students


def test_an_added_paper_is_printed_again_byte_for_byte(grown: Path) -> None:
    for name in ("late1", "s0"):
        for kind, options in (("papers", ()), ("solutions", ("--solution",))):
            paper = kinegrade("paper", grown / "EXAM", name, *options).stdout_bytes
            assert paper == (grown / "EXAM" / kind / f"{name}.pdf").read_bytes()


def test_it_is_the_exam_that_force_writes_for_a_grown_roster(grown: Path, tmp_path: Path) -> None:
    write(tmp_path, students={**CLASS, **LATE})
    shutil.copytree(grown / "EXAM-BEFORE", tmp_path / "EXAM")
    generated(tmp_path, "--force", "--solutions")
    books = {"papers.pdf", "solutions.pdf"}  # the same pages
    forced, grew = contents(tmp_path / "EXAM"), contents(grown / "EXAM")
    assert forced.keys() == grew.keys()
    assert {name for name in forced if forced[name] != grew[name]} <= books


def test_force_with_the_grown_roster_keeps_all_papers(grown: Path, tmp_path: Path) -> None:
    write(tmp_path, students={**LATE, **CLASS})
    shutil.copytree(grown / "EXAM", tmp_path / "EXAM")
    result = generate(tmp_path, "--force")
    assert "5 papers keep their numbers, 0 changed, 0 gone, 0 new" in result.stderr
    assert contents(tmp_path / "EXAM" / "papers") == contents(grown / "EXAM" / "papers")


def test_sorted_rosters_give_the_same_papers(grown: Path, tmp_path: Path) -> None:
    write(tmp_path, students=dict(sorted(CLASS.items())))
    shutil.copytree(grown / "EXAM-BEFORE", tmp_path / "EXAM")
    (tmp_path / "late.csv").write_text(roster(dict(sorted(LATE.items()))), encoding="utf-8")
    added(tmp_path)
    assert contents(tmp_path / "EXAM" / "papers") == contents(grown / "EXAM" / "papers")


@pytest.mark.sampled(6, by="options")
@pytest.mark.parametrize(
    ("bank", "options"),
    [
        ("", ("--also", "html")),
        ("", ()),
        ("versions = 2", ("--paper-size", "letter", "--share-with-group", "--solutions")),
        ("versions = 5", ()),
        ('engine = "latex"', ()),
        ('engine = "latex"', ("--solutions",)),
        ("shuffle = true", ("--seed", "x", "--lang", "zh", "--method", "pole", "--solutions")),
    ],
)
def test_papers_are_like_those_of_the_others(
    tmp_path: Path, bank: str, options: tuple[str, ...]
) -> None:
    generated(write(tmp_path, bank), *options)
    before, mode = contents(tmp_path / "EXAM"), (tmp_path / "EXAM").stat().st_mode
    added(tmp_path)
    after = contents(tmp_path / "EXAM")
    kept = {name for name in before if name not in {*REWRITTEN, "tex/key.tex"}}
    assert {name: after[name] for name in kept} == {name: before[name] for name in kept}
    new = {name.replace("s0", "late1") for name in before if "/s0." in name}
    assert new <= after.keys()
    assert (tmp_path / "EXAM").stat().st_mode == mode
    earlier, later = drawn(tmp_path, 0)[:3], drawn(tmp_path, 0)[3:]
    assert later
    assert "versions = 2" in bank or [each for each in later if each in earlier] == []
    paper = kinegrade("paper", tmp_path / "EXAM", "late1").stdout_bytes
    assert paper == after["papers/late1.pdf"]
    assert generate(tmp_path, "--force").exit_code == 2  # the others' roster
    (tmp_path / "roster.csv").write_text(roster({**CLASS, **LATE}), encoding="utf-8")
    again = generate(
        tmp_path, "--force", *(each for each in options if each not in ("--seed", "x"))
    )
    assert "5 papers keep their numbers, 0 changed, 0 gone, 0 new" in again.stderr
    assert contents(tmp_path / "EXAM" / "papers") == contents_of(after, "papers")


def contents_of(files: dict[str, bytes], folder: str) -> dict[str, bytes]:
    start = f"{folder}/"
    return {
        name.removeprefix(start): data for name, data in files.items() if name.startswith(start)
    }


def test_a_class_grows_twice(folder: Path) -> None:
    added(folder)
    before = contents(folder / "EXAM")
    (folder / "roster.csv").write_text(roster({**LATE, **CLASS}), encoding="utf-8")
    (folder / "late.csv").write_text(roster({f"x{n}": "N" for n in range(9)}), encoding="utf-8")
    assert "9 papers added, 5 stay as they are" in added(folder, "--jobs", "2").stderr
    after = contents(folder / "EXAM")
    kept = before.keys() - REWRITTEN
    assert {name: after[name] for name in kept} == {name: before[name] for name in kept}
    assert after["key.jsonl"].startswith(before["key.jsonl"])
    assert [len(set(drawn(folder, question))) for question in (0, 1)] == [14, 14]
    assert sorted(line["place"] for line in key_lines(folder / "EXAM")) == list(range(14))


@pytest.mark.left(beside="test_a_class_grows_twice")
def test_several_processes_print_the_same(folder: Path, tmp_path: Path, small_parts: int) -> None:
    late = {f"x{number}": "N" for number in range(2 * small_parts)}
    (folder / "late.csv").write_text(roster(late), encoding="utf-8")
    other = Path(shutil.copytree(folder, tmp_path / "other"))
    added(folder, "--jobs", "1")
    added(other, "--jobs", "2")
    assert contents(folder) == contents(other)


def test_too_few_combinations_are_said_or_refused(folder: Path) -> None:
    late = {f"x{number}": "N" for number in range(18)}
    (folder / "late.csv").write_text(roster(late), encoding="utf-8")
    said = "q2 (crank): 20 of the 20 combinations of values are fit for 21 students, so some have"
    (line,) = refused(folder, "--strict")
    assert line.startswith(said)
    result = add(folder)
    assert result.exit_code == 1
    assert f"complaint: {said}" in result.stderr
    assert "18 papers added, 3 stay as they are" in result.stderr
