"""Tables in which nothing is quoted are read as the csv module reads them."""

from __future__ import annotations

import csv
import io

from hypothesis import example, given
from hypothesis import strategies as st

from kinegrade.files.csv_reading import read_records

TEXTS = st.text("a1 ,;\t\n\r\"'\x00\x0b\u2028", max_size=30)


@given(TEXTS.filter(lambda text: '"' not in text), st.sampled_from(",;\t"))
@example("a,b\n\n\nc", ",")
@example("a,b\n,\n", ",")
@example("a\r\nb\r\rc", ",")
@example("", ",")
def test_records_are_those_of_the_csv_module(text: str, separator: str) -> None:
    stray: list[int] = []
    records = [*read_records(text, separator, 2, stray)]
    reader = csv.reader(io.StringIO(text, newline=""), delimiter=separator)
    assert [cells for _, cells in records] == [tuple(cells) for cells in reader]
    assert [line for line, _ in records] == list(range(1, len(records) + 1))
    assert stray == []
