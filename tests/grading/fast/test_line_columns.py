"""Lines put together column by column are those put together text by text."""

from __future__ import annotations

from unittest.mock import patch

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.grading.fast import line_columns
from kinegrade.grading.fast.line_columns import LineColumns

SIZE = 5
TEXTS = st.binary(max_size=3) | st.sampled_from(
    [b"", b"\0", b"\1", b"a\1b\0", b"x" * 32, b"x" * 33, b"y" * 500]
)
COLUMNS = st.lists(st.lists(TEXTS, min_size=SIZE, max_size=SIZE), min_size=1, max_size=4)
FEW = st.tuples(
    st.lists(TEXTS, min_size=1, max_size=3),
    st.lists(st.integers(0, 10**6), min_size=SIZE, max_size=SIZE),
)


@given(COLUMNS, FEW, st.lists(st.booleans(), min_size=SIZE, max_size=SIZE), st.integers(1, SIZE))
def test_lines_are_their_cells_one_behind_the_other(
    columns: list[list[bytes]],
    few: tuple[list[bytes], list[int]],
    kept: list[bool],
    together: int,
) -> None:
    texts, chosen = few
    which = np.array(chosen) % len(texts)
    lines = LineColumns(SIZE)
    for column in columns:
        lines.add(column)
    lines.add(texts, which)
    lines.add_again(0)
    expected = [
        b"".join([*(column[line] for column in columns), texts[which[line]], columns[0][line]])
        for line in range(SIZE)
    ]
    some = np.flatnonzero(kept)
    with patch.object(line_columns, "_TOGETHER", together):
        assert lines.write(np.arange(SIZE)) == b"".join(expected)
        assert lines.write(some) == b"".join(expected[line] for line in some)


@pytest.mark.parametrize("width", [0, 1, 32, 33])
def test_plain_texts_are_of_any_length(width: int) -> None:
    lines = LineColumns(2)
    lines.add_plain(np.array([b"x" * width, b""]))
    lines.add([b",", b";"])
    assert lines.write(np.arange(2)) == b"x" * width + b",;"


@pytest.mark.parametrize("width", [3, 33])
def test_others_stand_in_place_of_plain_texts(width: int) -> None:
    lines = LineColumns(3)
    lines.add_plain(np.array([b"x" * width, b"", b"7"]), {1: b'"\0, "', 2: b"y" * 40})
    lines.add_again(0)
    whole = b"x" * (2 * width) + b'"\0, "' * 2 + b"y" * 80
    assert lines.write(np.arange(3)) == whole
