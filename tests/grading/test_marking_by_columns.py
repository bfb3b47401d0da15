"""A class is marked by the arrays beside its key as it is by the key itself, byte for byte, and as
every answer is decided exactly.
"""

from __future__ import annotations

import csv
import json
import re
from collections.abc import Callable, Iterator
from dataclasses import replace
from fractions import Fraction
from itertools import cycle
from pathlib import Path

import pytest

from benchmarks.large_class import COLUMNS, write_class
from kinegrade.exam.folder.columns import reading, writing
from kinegrade.exam.folder.columns.gathering import read_right_answers
from kinegrade.exam.folder.columns.part import PartKeys
from kinegrade.exam.folder.columns.writing import write_columns
from kinegrade.exam.folder.contents import KEY, KEY_COLUMNS
from kinegrade.exam.folder.exam_folder import ExamFolder, open_exam
from kinegrade.exam.folder.keys import Key
from kinegrade.exam.keyed_exam import read_whole
from kinegrade.files.tables import parse_table
from kinegrade.grading import marking
from kinegrade.grading.fast import block_judge
from kinegrade.grading.grade import MarkingWishes, grade
from kinegrade.grading.marking import MarkingTerms, mark
from kinegrade.grading.marks import Mark
from kinegrade.grading.policy.policy import AS_PRINTED
from kinegrade.grading.sheets.class_sheet import read_sheet
from kinegrade.numbers.decimals import round_to_decimal
from tests.grading.one_by_one import marks_one_by_one
from tests.said import said

POLICIES = {
    "as printed": "",
    "another rule": 'attempts = "first"\ntolerance = { relative = "2 %" }\n',
    "shares for mistakes": 'credit = { mistakes = { sense-reversed = "1/4" }, wrong-unit = "1/2" }\n',
    "figures": "tolerance = { figures = 3 }\n",
    "the best row": 'attempts = "best"\n',
}


def repeat_rows(sheet: bytes) -> bytes:
    """Every other row twice, and once more with an answer changed."""
    head, *rows = sheet.splitlines(keepends=True)
    more = (row for each in rows[::2] for row in (each, each.replace(b".", b".9", 1)))
    return b"".join([head, *rows, *more])


#: What people, programs and spreadsheets leave in cells
STRANGE = (
    "nan", "-inf", "1e999", f"{7**400}", "0." + "0" * 300 + "1", "\uff11\uff12.\uff15",
    "\u0663\u066b\u0665", '"1,5"', '"say ""2.5"""', "  3.5\u00a0", "+2.25", "-.5", "7.", "--1", "1.2.3",
    "1 234.5", "=1+1", "\u221212.5", "1e-3", "0x10", "'2.5", "\U0001d7d9.5",
)  # fmt: skip


def type_strangely(sheet: bytes) -> bytes:
    """Every third cell of every fifth row holds something strange."""
    head, *rows = sheet.decode().splitlines()
    strange = cycle(STRANGE)
    for place in range(0, len(rows), 5):
        cells = rows[place].split(",")
        cells[2::3] = [next(strange) for _ in cells[2::3]]
        rows[place] = ",".join(cells)
    return "\n".join([head, *rows, ""]).encode()


SHEETS: dict[str, Callable[[bytes], bytes]] = {
    "as typed": lambda sheet: sheet,
    "a byte-order mark and CR LF": lambda sheet: b"\xef\xbb\xbf" + sheet.replace(b"\n", b"\r\n"),
    "quoted cells": lambda sheet: re.sub(rb",(Student \d+),", rb',"\1",', sheet),
    "repeated rows": repeat_rows,
    "unknown and missing students": lambda sheet: sheet.replace(b"\n0000", b"\nx", 9),
    "no rows": lambda sheet: sheet.partition(b"\n")[0],
    "strange cells": type_strangely,
    "short rows": lambda sheet: sheet.replace(b"1,", b"1\n", 40),
}


def contents(folder: Path) -> dict[str, bytes]:
    return {file.name: file.read_bytes() for file in sorted(folder.iterdir())}


def mark_twice(folder: Path, wishes: MarkingWishes) -> tuple[dict[str, bytes], dict[str, bytes]]:
    """The marks of the class by the arrays, and by the key alone."""

    def mark_class(name: str) -> dict[str, bytes]:
        grade(open_exam(folder / "EXAM"), folder / "answers.csv", folder / name, wishes)
        return contents(folder / name)

    by_columns = mark_class("BY_COLUMNS")
    (folder / "EXAM" / KEY_COLUMNS).unlink()
    return by_columns, mark_class("BY_KEY")


@pytest.mark.parametrize("policy", POLICIES.values(), ids=POLICIES)
def test_marks_by_columns_are_marks_by_the_key(tmp_path: Path, policy: str) -> None:
    write_class(tmp_path, 300, 0.1)
    file = tmp_path / "policy.toml"
    file.write_text(policy, encoding="utf-8")
    wishes = MarkingWishes(policy=file if policy else None, own_papers=True)
    by_columns, by_key = mark_twice(tmp_path, wishes)
    assert by_columns == by_key
    assert by_key["marks.csv"].count(b"\n") > 3000


@pytest.mark.parametrize("change", SHEETS.values(), ids=SHEETS)
def test_so_they_are_for_any_sheet(tmp_path: Path, change: Callable[[bytes], bytes]) -> None:
    write_class(tmp_path, 300, 0.1)
    sheet = tmp_path / "answers.csv"
    sheet.write_bytes(change(sheet.read_bytes()))
    by_columns, by_key = mark_twice(tmp_path, MarkingWishes(own_papers=True))
    assert by_columns == by_key
    assert by_key["marks.csv"].count(b"\n") > 3000


def test_so_they_are_where_blocks_join_parts_of_the_arrays(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for module in (writing, reading):
        monkeypatch.setattr(module, "PART", 30)
    monkeypatch.setattr(marking, "choose_block", lambda _: 90)
    write_class(tmp_path, 200, 0.1)
    by_columns, by_key = mark_twice(tmp_path, MarkingWishes(own_papers=True))
    assert by_columns == by_key


def drop_rows(sheet: bytes) -> bytes:
    """Without every ninth row: these students have none."""
    head, *rows = sheet.splitlines(keepends=True)
    return b"".join([head, *(row for place, row in enumerate(rows) if place % 9)])


@pytest.mark.parametrize("odd_share", [0, 0.1])
@pytest.mark.parametrize("change", SHEETS.values(), ids=SHEETS)
def test_marks_of_a_grid_are_those_of_listed_rows(
    tmp_path: Path, change: Callable[[bytes], bytes], odd_share: float
) -> None:
    write_class(tmp_path, 120, odd_share)
    sheet = parse_table(change(drop_rows((tmp_path / "answers.csv").read_bytes())), "answers.csv")
    marks = []
    for name, rows in {"GRID": sheet.rows, "LISTED": tuple(sheet.rows)}.items():
        wishes = MarkingWishes(own_papers=True)
        grade(open_exam(tmp_path / "EXAM"), replace(sheet, rows=rows), tmp_path / name, wishes)
        marks.append(contents(tmp_path / name))
    assert marks[0] == marks[1]
    assert marks[0]["complaints.csv"].count(b"no row") > 10


# Below, at and above a bound, and where only digits beyond double precision decide
STEPS = (
    Fraction(0),
    Fraction(1, 10**12),
    Fraction(-1, 10**12),
    Fraction(1, 10**30),
    Fraction(-1, 10**30),
)


def type_at_bounds(exam: ExamFolder) -> Iterator[list[str]]:
    """A row for each paper, whose answers are at the bounds of what is right, and of what mistakes
    lead to.
    """
    steps = cycle(STEPS)
    for paper in exam.papers():
        keys = [paper.key(ask) for ask in range(len(COLUMNS))]
        bounds = [_choose_bound(key, ask) for ask, key in enumerate(keys)]
        typed = [bound * (1 + next(steps)) for bound in bounds]
        yield [paper.student, *(f"{round_to_decimal(each, 45):f}" for each in typed)]


def _choose_bound(key: Key, ask: int) -> Fraction:
    low, high = key.interval
    wrong = [*key.mistakes.values()][ask % len(key.mistakes)]
    return (low, high, wrong, key.rule.interval(wrong)[0], key.value)[ask % 5]


def state(marks: list[Mark]) -> list[object]:
    return [
        (each.student, each.ask, each.verdict.kind, said(each.verdict.reason), each.points)
        for each in marks
    ]


def test_at_the_bounds_each_answer_is_decided_exactly(tmp_path: Path) -> None:
    write_class(tmp_path, 60, 0.0)
    exam = open_exam(tmp_path / "EXAM")
    with (tmp_path / "typed.csv").open("w", encoding="utf-8", newline="") as stream:
        csv.writer(stream).writerows([["student", *COLUMNS], *type_at_bounds(exam)])
    table = parse_table((tmp_path / "typed.csv").read_bytes(), "typed.csv")
    sheet = read_sheet(table, exam)
    assert [paper for paper in exam.papers() if not isinstance(paper.keys, PartKeys)] == []
    marks = mark(exam, sheet, MarkingTerms(AS_PRINTED)).marks
    exactly = marks_one_by_one(read_whole(exam), sheet, AS_PRINTED)
    assert state([*marks]) == state(exactly)
    assert {each.verdict.kind for each in marks} >= {"right", "wrong", "mistake"}


def test_strange_cells_are_decided_exactly(tmp_path: Path) -> None:
    write_class(tmp_path, 60, 0.0)
    exam = open_exam(tmp_path / "EXAM")
    typed = type_strangely((tmp_path / "answers.csv").read_bytes())
    sheet = read_sheet(parse_table(typed, "typed.csv"), exam)
    marks = mark(exam, sheet, MarkingTerms(AS_PRINTED)).marks
    exactly = marks_one_by_one(read_whole(exam), sheet, AS_PRINTED)
    assert state([*marks]) == state(exactly)
    assert {each.verdict.kind for each in marks} >= {"right", "wrong", "mistake", "unreadable"}


@pytest.mark.parametrize("kept", [KEY_COLUMNS, KEY])
def test_answers_as_round_as_the_key_are_decided_side_by_side(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, kept: str
) -> None:
    write_class(tmp_path, 60, 0.0)
    folder, sheet = tmp_path / "EXAM", [",".join(["student", *COLUMNS])]
    lines = [json.loads(line) for line in (folder / KEY).read_text().splitlines()]
    for line in lines:
        for question in line["questions"]:
            for key in question["asks"].values():
                key.update(
                    exact="27/2", value=13.5, decimal="13.5", mistakes={"wrong-pole": "7.25"}
                )
        sheet.append(",".join([line["student"], *["13.5", "7.25"] * 5]))
    (folder / KEY).write_text("".join(f"{json.dumps(line)}\n" for line in lines))
    (tmp_path / "answers.csv").write_text("\n".join(sheet))
    write_columns(folder / KEY_COLUMNS, folder / KEY, open_exam(folder).head)
    if kept == KEY:
        (folder / KEY_COLUMNS).unlink()
    monkeypatch.setattr(block_judge, "decide", None)  # one by one, which takes fifty times as long
    found = grade(open_exam(folder), tmp_path / "answers.csv", tmp_path / "MARKS").grades
    assert {each.total for each in found} == {15}
    assert b"difference 0, allowed 0.135" in (tmp_path / "MARKS" / "marks.csv").read_bytes()


def slip_rows(sheet: bytes) -> bytes:
    """The answers of every fourth student are those of the next."""
    head, *rows = sheet.splitlines(keepends=True)
    cells = [row.split(b",", 2) for row in rows]
    slipped = (
        b",".join([*mine[:2], (cells[place + 1] if place % 4 == 0 else mine)[2]])
        for place, mine in enumerate(cells)
    )
    return b"".join([head, *slipped])


def test_rows_of_other_students_are_told_alike(tmp_path: Path) -> None:
    write_class(tmp_path, 1200, 0.0)
    sheet = tmp_path / "answers.csv"
    sheet.write_bytes(slip_rows(sheet.read_bytes()))
    by_columns, by_key = mark_twice(tmp_path, MarkingWishes())
    assert by_columns == by_key
    assert by_key["complaints.csv"].count(b"right on the paper of") > 5


def list_right_answers(exam: ExamFolder) -> list[tuple[list[float], object]]:
    """What is right on each paper, and by which rules."""
    parts = list(read_right_answers(exam))
    assert {(*part.periods,) for part in parts if len(part.values)} == {(0,) * len(COLUMNS)}
    return [
        (values.tolist(), rules)
        for part in parts
        for values, rules in zip(part.values, part.rules, strict=True)
    ]


def test_what_is_right_on_all_papers_is_read_from_the_arrays(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write_class(tmp_path, 1200, 0.0)
    folder = tmp_path / "EXAM"
    with monkeypatch.context() as change:
        change.setattr(ExamFolder, "papers", None)
        by_columns = list_right_answers(open_exam(folder))
    assert [len(values) for values, _ in by_columns] == [len(COLUMNS)] * 1200
    damaged = bytearray((folder / KEY_COLUMNS).read_bytes())
    place = damaged.rindex(b"1/values.npy", 0, damaged.rindex(b"1/values.npy")) + 400
    damaged[place] ^= 1
    (folder / KEY_COLUMNS).write_bytes(damaged)
    assert list_right_answers(open_exam(folder)) == by_columns
    (folder / KEY_COLUMNS).unlink()
    assert list_right_answers(open_exam(folder)) == by_columns
