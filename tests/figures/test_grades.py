"""A grade holds for the picture that was graded: the list names every figure that has changed."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from tests.figures.__main__ import main
from tests.figures.sheet import (
    GRADES,
    Graded,
    digest,
    find_lost,
    print_figure,
    read_grades,
    take_grades,
    write_grades,
)

EACH = 16  # so many rows, one is looked at; `make prove` looks at all of them


def test_no_graded_figure_of_a_sample_has_changed() -> None:
    lost = find_lost(read_grades(GRADES)[::EACH])
    assert lost == [], "look at them again: python -m tests.figures grade-sheet OUT --seed SEED"


def test_grades_go_from_the_sheet_into_the_table(tmp_path: Path) -> None:
    table, filled = tmp_path / "table.csv", tmp_path / "sheet" / "grades.csv"
    write_grades(table, [Graded("slider-crank", "7", "0", "B", "earlier")])
    main(["grade-sheet", str(filled.parent), "slider-crank", "--seed", "7", "--seed", "8"])
    assert (filled.parent / "sheet.pdf").read_bytes().startswith(b"%PDF")
    first, second = read_grades(filled)
    write_grades(filled, [replace(first, grade="A"), second])
    main(["take", str(filled)], table)
    assert read_grades(table) == [replace(first, grade="A")]
    assert find_lost(read_grades(table)) == []


def test_a_figure_that_has_changed_loses_its_grade(tmp_path: Path) -> None:
    same = Graded("slider-crank", "8", digest(print_figure("slider-crank", "8")), "A")
    write_grades(tmp_path / "table.csv", [Graded("slider-crank", "7", "0", "A"), same])
    main(["forget"], tmp_path / "table.csv")
    assert read_grades(tmp_path / "table.csv") == [same]


def test_a_figure_that_has_changed_is_named() -> None:
    assert find_lost([Graded("slider-crank", "7", "0", "A")]) == [
        "slider-crank 7: graded A, has changed"
    ]


def test_a_grade_that_is_none_is_refused(tmp_path: Path) -> None:
    filled, table = tmp_path / "filled.csv", tmp_path / "table.csv"
    write_grades(filled, [Graded("slider-crank", "7", "0", "D")])
    write_grades(table, [])
    with pytest.raises(ValueError, match="slider-crank 7: grade 'D', not A, B or C"):
        take_grades(filled, table)
    assert read_grades(table) == []
