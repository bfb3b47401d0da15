"""Cells that are plain numbers are told from others at once as they are one by one, and show the
same about decimal points.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from math import nan

from hypothesis import example, given
from hypothesis import strategies as st

from kinegrade.grading.typed.decimal_style import find_file_style, gather_evidence
from kinegrade.grading.typed.plain_cells import PlainCells

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
@example(["1\n2"])
@example([""])
def test_all_are_plain_if_each_is(cells: list[str]) -> None:
    each = [PLAIN.fullmatch(cell) is not None and len(cell) <= 20 for cell in cells]
    plain = PlainCells.of(cells)
    assert (plain is not None) == all(each)
    if plain is not None:
        assert [*plain] == cells
        expected = [float(cell) if cell else nan for cell in cells]
        assert [*map(repr, plain.values.tolist())] == [*map(repr, expected)]


@given(st.lists(DECIMALS | st.sampled_from(["", "1", "0.125", "12.345", "1234.567"]), max_size=6))
def test_a_cell_shows_a_decimal_point_as_it_does_alone(cells: list[str]) -> None:
    plain = PlainCells.of(cells)
    assert plain is not None
    shown = plain.find_decimals()
    expected = ["." in gather_evidence([cell]).decimal for cell in cells]
    if shown is None:
        assert any(re.fullmatch(r"-?[0-9]{4,}\.[0-9]{3}", cell) for cell in cells)
    else:
        assert shown.tolist() == expected


@given(st.lists(st.lists(DECIMALS | st.sampled_from(["", "7", "1,5"]), min_size=2, max_size=2)))
def test_a_file_has_the_style_of_its_rows(rows: Sequence[Sequence[str]]) -> None:
    shown = [gather_evidence(row) for row in rows if any(row)]
    commas, points = (sum(mark in each.decimal for each in shown) for mark in ",.")
    style = find_file_style(rows)
    assert style.commas == (commas > 0)
    assert (style.style.comma == "groups") == (not commas and 2 * points > len(shown))
