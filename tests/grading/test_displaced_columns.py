"""A column of an answer sheet that was sorted or slipped alone is told; honest mistakes, a sheet
sorted with its rows intact and a hard exam are not.
"""

from __future__ import annotations

from collections.abc import Sequence
from random import Random

import pytest

from kinegrade.files.tables import parse_table
from kinegrade.grading.fast.another_paper import PapersAnswered
from kinegrade.grading.marking import MarkingTerms, mark_blocks
from kinegrade.grading.misplaced.class_answers import AnswersSeen
from kinegrade.grading.misplaced.displaced_columns import DisplacedColumns
from kinegrade.grading.sheets.class_sheet import read_sheet
from tests.grading.sitting_class import FACTORS, SittingClass, sitting_class
from tests.said import said

Rows = list[list[str]]  # the id, then the answers
SITTING = sitting_class(40, 5)
COLUMNS = [ask.column for ask in SITTING.exam.asks]


def honest_rows(sitting: SittingClass, seed: int, mistaken: float) -> Rows:
    """Answers of a class, of which this share is off by a usual mistake and a tenth is blank."""
    chance, factors = Random(seed), [float(factor) for factor in FACTORS.values()]
    rows = []
    for place, examinee in enumerate(sitting.exam.examinees):
        cells = []
        for column in COLUMNS:
            wrong = chance.choice(factors) if chance.random() < mistaken else 1.0
            value = wrong * float(sitting.key(place, column))
            cells.append("" if chance.random() < 0.1 else f"{value:.5g}")
        rows.append([examinee.student, *cells])
    return rows


def find(sitting: SittingClass, rows: Rows) -> list[tuple[str, str]]:
    """The columns that are told, and why."""
    lines = [",".join(row) for row in [["student", *COLUMNS], *rows]]
    sheet = read_sheet(parse_table("\n".join(lines).encode(), "answers.csv"), sitting.exam)
    seen, papers = AnswersSeen(len(sitting.exam.asks)), PapersAnswered(sitting.exam)
    list(seen.watched(mark_blocks(papers, sheet, MarkingTerms())))
    answers = seen.put_together()
    complaints = DisplacedColumns(papers.intervals, sheet.columns, answers).list_complaints()
    return [(each.column, said(each.problem)) for each in complaints]


def replaced(rows: Rows, places: Sequence[int], source: Rows) -> Rows:
    """The rows with the cells at these places from other rows."""
    return [
        [other[place] if place in places else cell for place, cell in enumerate(row)]
        for row, other in zip(rows, source, strict=True)
    ]


def sorted_by(rows: Rows, place: int) -> Rows:
    """The rows in ascending order of the numbers at a place, blanks last."""
    return sorted(rows, key=lambda row: float(row[place] or "inf"))


def test_a_column_that_was_sorted_alone_is_told() -> None:
    rows = honest_rows(SITTING, 1, 0.2)
    [(column, why)] = find(SITTING, replaced(rows, [3], sorted_by(rows, 3)))
    assert column == COLUMNS[2]
    assert "numbers stand in order, and " in why
    assert why.endswith("are wrong - perhaps the column was sorted alone")


def test_columns_that_were_sorted_together_are_told_by_the_one_in_order() -> None:
    rows = honest_rows(SITTING, 1, 0.2)
    told = find(SITTING, replaced(rows, [3, 4, 5, 6], sorted_by(rows, 3)))
    assert COLUMNS[2] in [column for column, _ in told]


@pytest.mark.parametrize(("first", "kind"), [(0, "above"), (1, "below")])
def test_a_column_that_slipped_by_a_line_is_told_with_its_lines(first: int, kind: str) -> None:
    rows = honest_rows(SITTING, 2, 0.0)
    moved = rows[:20] + (rows[19:39] if first == 0 else [*rows[21:], rows[20]])
    [(column, why)] = find(SITTING, replaced(rows, [5], moved))
    assert column == COLUMNS[4]
    assert f"are right on the paper of the line {kind}, and not on the own one" in why
    numbers = [int(word) for word in why.split() if word.isdigit()]
    assert numbers[0] >= 8
    assert 21 <= numbers[1] < numbers[2] <= 41


def test_a_slip_in_the_last_six_lines_is_told() -> None:
    told = 0
    for seed in range(8):
        rows = honest_rows(SITTING, 1000 + seed, 0.2)
        slipped = [*rows[:-6], *rows[-5:], [rows[-1][0], *[""] * len(COLUMNS)]]
        told += COLUMNS[2] in [column for column, _ in find(SITTING, replaced(rows, [3], slipped))]
    assert told >= 5


def test_the_order_is_that_of_the_lines_and_not_of_the_roster() -> None:
    rows = honest_rows(SITTING, 2, 0.0)
    Random(1).shuffle(rows)
    assert [column for column, _ in find(SITTING, replaced(rows, [5], [*rows[1:], rows[0]]))] == [
        COLUMNS[4]
    ]


def test_a_sheet_that_was_sorted_with_its_rows_is_not_told() -> None:
    assert find(SITTING, sorted_by(honest_rows(SITTING, 3, 0.2), 3)) == []


@pytest.mark.parametrize("mistaken", [0.0, 0.3, 0.8])
@pytest.mark.parametrize("seed", range(6))
def test_honest_mistakes_are_not_told(seed: int, mistaken: float) -> None:
    sitting = sitting_class(60, 100 + seed)
    assert find(sitting, honest_rows(sitting, seed, mistaken)) == []


def test_few_students_are_not_told() -> None:
    sitting = sitting_class(3, 1)
    assert find(sitting, honest_rows(sitting, 1, 0.5)) == []
