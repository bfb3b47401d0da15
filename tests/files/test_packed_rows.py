"""Packed rows are the rows that were packed."""

from __future__ import annotations

import sys

from hypothesis import given
from hypothesis import strategies as st

from kinegrade.files.rows.packed_rows import PackedRows, pack_rows
from kinegrade.files.rows.row import Row

CELLS = st.lists(st.text(max_size=9), max_size=4).map(tuple)
ROWS = st.lists(st.builds(Row, st.integers(1, 10**9), CELLS), max_size=9)


@given(ROWS, st.slices(9))
def test_packed_rows_are_the_same_rows(rows: list[Row], places: slice) -> None:
    packed = pack_rows(iter(rows))
    assert [*packed] == rows
    assert len(packed) == len(rows)
    assert [*packed[places]] == rows[places]
    assert [packed[-place] for place in range(1, len(rows) + 1)] == rows[::-1]


def test_cells_of_any_text_keep_their_characters() -> None:
    rows = [Row(2, ("007", "王伟", '0,5"\n', "\ud800")), Row(9, ("", ""))]
    packed = pack_rows(rows)
    assert isinstance(packed, PackedRows)
    assert [*packed] == rows


def test_a_class_takes_a_fifth_of_the_memory() -> None:
    rows = [Row(line, tuple(f"{line / 7 + cell:.4f}" for cell in range(10))) for line in range(999)]
    packed = pack_rows(rows)
    assert isinstance(packed, PackedRows)
    loose = sum(sys.getsizeof(row) + sum(map(sys.getsizeof, row.cells)) for row in rows)
    parts = (packed.text, packed.ends, packed.lines)
    assert 5 * sum(map(sys.getsizeof, parts)) < loose
