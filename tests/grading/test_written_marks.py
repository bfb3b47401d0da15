"""marks.csv has, byte for byte, a line for each answer decided exactly, as the csv module writes it."""

from __future__ import annotations

import csv
import io
from pathlib import Path
from random import Random
from tempfile import TemporaryDirectory

import pytest
from hypothesis import given
from hypothesis import strategies as st

import kinegrade
from kinegrade.exam.folder.columns.writing import write_columns
from kinegrade.exam.folder.contents import KEY, KEY_COLUMNS
from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.exam.keyed_exam import read_whole
from kinegrade.files.cell_text import shorten
from kinegrade.files.csv_writing import encode, neutralise
from kinegrade.files.tables import read_table
from kinegrade.grading.by_hand import addresses
from kinegrade.grading.grade import MarkingWishes, grade
from kinegrade.grading.marks import Mark
from kinegrade.grading.policy.policy import AS_PRINTED
from kinegrade.grading.policy.reading import read_policy
from kinegrade.grading.sheets.class_sheet import read_sheet
from kinegrade.marks_folder import folder as marks_folder
from kinegrade.marks_folder.layout import ANSWERS
from kinegrade.marks_folder.rows import ClassTotals
from kinegrade.marks_folder.totals import read_totals
from kinegrade.numbers.amounts import write_amount
from tests.grading.one_by_one import marks_one_by_one
from tests.grading.test_block_judge import COLUMNS, POLICIES, write_class
from tests.said import said

HOSTILE = (
    "=1+1", "@x", '"', 'a "b", c', "1,5 m/s", "-", "\u221a2", "\x01", "a\x00b", "9" * 2000, "\u6574 1", "1\n2", "'+1",
    "+7", "1e400", "007", "0.10", "-0", ".5", "5.", "12345678901234567890", "123456789012345678901",
)  # fmt: skip
OTHER_POLICIES = [policy for policy in POLICIES if "accept" not in policy]


def type_hostile(folder: Path, cells: list[tuple[int, int, str]]) -> None:
    """Puts texts in the places of some answers."""
    with (folder / "answers.csv").open(encoding="utf-8", newline="") as stream:
        header, *rows = csv.reader(stream)
    for row, column, text in cells:
        rows[row % len(rows)][1 + column % len(COLUMNS)] = text
    with (folder / "answers.csv").open("w", encoding="utf-8", newline="") as stream:
        csv.writer(stream).writerows([header, *rows])


def write_lines(marks: list[Mark]) -> bytes:
    """The marks as a CSV file."""
    text = io.StringIO(newline="")
    lines = csv.writer(text, lineterminator="\n")
    lines.writerow(ANSWERS.columns)
    for each in marks:
        reading, verdict, ask = each.reading, each.verdict, each.ask
        response = neutralise(shorten(reading.typed))
        points = write_amount(each.points), write_amount(ask.points)
        why = map(neutralise, (said(verdict.reason), " ".join(verdict.mistakes)))
        rule = "policy" if verdict.by_policy else ""
        read = response, reading.read_as, ask.unit, verdict.kind
        lines.writerow([each.student, ask.question, ask.ask, *read, *points, *why, rule])
    return encode(text.getvalue())


@given(
    st.integers(0, 10**9),
    st.sampled_from(OTHER_POLICIES),
    st.lists(
        st.tuples(st.integers(0, 11), st.integers(0, 3), st.sampled_from(HOSTILE)), max_size=9
    ),
    st.booleans(),
)
def test_lines_are_those_of_answers_decided_one_by_one(
    seed: int, policy: str, hostile: list[tuple[int, int, str]], by_columns: bool
) -> None:
    with TemporaryDirectory() as name:
        folder = Path(name)
        write_class(folder, Random(seed), 12)
        type_hostile(folder, hostile)
        (folder / "policy.toml").write_text(policy, encoding="utf-8")
        if by_columns:
            write_columns(folder / KEY_COLUMNS, folder / KEY, open_exam(folder).head)
        exam, answers = open_exam(folder), folder / "answers.csv"
        rules = read_policy(folder / "policy.toml", exam) if policy else AS_PRINTED
        sheet = read_sheet(read_table(answers), exam)
        expected = write_lines(marks_one_by_one(read_whole(exam), sheet, rules))
        wishes = MarkingWishes(policy=folder / "policy.toml" if policy else None, own_papers=True)
        grade(exam, answers, folder / "MARKS", wishes)
        assert (folder / "MARKS" / ANSWERS.name).read_bytes() == expected


def test_what_was_written_is_read_again_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Each reading of the totals of a large class takes a twentieth of its marking."""
    write_class(tmp_path, Random(1), 12)
    read: list[Path] = []

    def count(folder: Path, *others: object) -> ClassTotals:
        read.append(folder)
        return read_totals(folder, *others)  # type: ignore[arg-type]

    monkeypatch.setattr(marks_folder, "read_totals", count)
    kinegrade.grade(kinegrade.open_exam(tmp_path), tmp_path / "answers.csv", tmp_path / "MARKS")
    assert len(read) == 1


def test_addresses_of_a_class_are_compared_for_marks_by_hand_alone(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write_class(tmp_path, Random(1), 12)
    monkeypatch.setattr(addresses, "make_header_key", None)
    found = kinegrade.grade(kinegrade.open_exam(tmp_path), tmp_path / "answers.csv", tmp_path / "M")
    assert len(found.grades.grades) == 12
