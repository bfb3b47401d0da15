"""Cells that are plain numbers are told from others at once as they are one by one, and show the
same about decimal points.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from math import nan

from hypothesis import example, given
from hypothesis import strategies as st

from kinegrade.grading.typed.decimal_style import (
    find_file_style,
    gather_evidence,
    show_evidence,
)
from kinegrade.grading.typed.parted_cells import PartedCells

PLAIN = re.compile(r"(?:-?[0-9]+(?:\.[0-9]+)?)?")
NUMBERS = st.from_regex(PLAIN, fullmatch=True).filter(str.isascii)
NEARLY = st.text("0123.-+,\n e", max_size=8) | st.sampled_from(
    ["1" * 20, "1" * 21, "-", "٣", "\ud800"]
)
DECIMALS = st.from_regex(r"-?[0-9]{1,5}\.[0-9]{1,5}", fullmatch=True).filter(str.isascii)


@given(st.lists(NUMBERS, max_size=6) | st.lists(NUMBERS | NEARLY, max_size=6))
@example([".5"])
@example(["1", ".5"])
@example(["5."])
@example(["1-2"])
@example(["1.2.3"])
@example(["", "0.5", "1" * 21, "7"])
@example([""])
def test_cells_are_parted_as_they_are_one_by_one(cells: list[str]) -> None:
    each = [PLAIN.fullmatch(cell) is not None and len(cell) <= 20 for cell in cells]
    parted = PartedCells.of(cells)
    assert (parted is None) == any("\n" in cell for cell in cells)
    if parted is None:
        return
    assert [*parted] == [parted[place] for place in range(len(cells))] == parted[:] == cells
    assert [*parted.others] == [place for place, plain in enumerate(each) if not plain]
    expected = [
        float(cell) if cell and plain else nan for cell, plain in zip(cells, each, strict=True)
    ]
    assert [*map(repr, parted.plain.values.tolist())] == [*map(repr, expected)]


@given(st.lists(DECIMALS | st.sampled_from(["", "1", "0.125", "12.345", "1234.567"]), max_size=6))
def test_a_cell_shows_a_decimal_point_as_it_does_alone(cells: list[str]) -> None:
    parted = PartedCells.of(cells)
    assert parted is not None
    expected = ["." in gather_evidence([cell]).decimal for cell in cells]
    assert parted.plain.find_decimals().tolist() == expected


@given(st.text("0123456789.,' ex*^-=", max_size=12) | NEARLY)
@example("3*20^3")
@example("1,234*10^3")
def test_a_cell_shows_the_same_whatever_its_larger_digits(cell: str) -> None:
    assert show_evidence(cell) == gather_evidence([cell])


ODD = st.sampled_from(["", "7", "1,5", "x", " ", "1,234.5", "1 m/s", "0,5" + " " * 30])


@given(st.lists(st.lists(DECIMALS | ODD, min_size=2, max_size=2)))
def test_a_file_has_the_style_of_its_rows(rows: Sequence[Sequence[str]]) -> None:
    shown = [gather_evidence(row) for row in rows if any(row)]
    commas, points = (sum(mark in each.decimal for each in shown) for mark in ",.")
    style = find_file_style(rows)
    assert style.commas == (commas > 0)
    assert (style.style.comma == "groups") == (not commas and 2 * points > len(shown))
