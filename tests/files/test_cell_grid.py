"""The rows of a grid are the rows that are read record by record."""

from __future__ import annotations

import csv
from io import StringIO

from hypothesis import example, given
from hypothesis import strategies as st

from kinegrade.files.cell_text import trim
from kinegrade.files.csv_reading import read_records
from kinegrade.files.rows.cell_grid import CellGrid, pack_grid, read_grid
from kinegrade.files.rows.letter_table import tabulate_letters
from kinegrade.files.rows.row import Row
from kinegrade.files.tables import parse_table

CELL = st.text("0a é王 .\u3000\ud800", max_size=3) | st.text(max_size=2)
LINES = st.lists(st.lists(CELL, min_size=2, max_size=3), max_size=5)


QUOTED = st.text('",\n\r a\x1f', max_size=12)


@given(QUOTED | QUOTED.map(lambda text: f'"{text}",1\n"2","3"'), st.integers(1, 3))
@example('"0,5",1\r\n"",2', 2)
@example('"a\n",1\n', 2)
@example('"a"",1\n",2\n', 2)
@example('1,"a\n2,b"\n', 2)
@example('1, "a,b"\n', 2)
def test_a_grid_of_quoted_cells_has_the_rows_that_are_read_one_by_one(
    text: str, width: int
) -> None:
    grid = read_grid(text, ",", width, 1)
    if grid is None:
        return
    stray: list[int] = []
    read = [Row(line, cells) for line, cells in read_records(text, ",", width, stray) if cells]
    assert [*grid] == read
    assert not stray
    assert grid.column(0) == [row.cells[0] for row in read]


@given(st.lists(st.tuples(CELL, CELL), min_size=1, max_size=4), st.sampled_from(["\n", "\r\n"]))
def test_what_spreadsheets_write_is_read_as_a_grid(cells: list[tuple[str, str]], end: str) -> None:
    stream = StringIO()
    csv.writer(stream, quoting=csv.QUOTE_ALL, lineterminator=end).writerows(cells)
    grid = read_grid(stream.getvalue(), ",", 2, 1)
    plain = all(letter not in cell for row in cells for cell in row for letter in '"\r\n\0\x1f')
    blank = any(not any(map(trim, row)) for row in cells)
    assert (grid is not None) == (plain and not blank)
    assert grid is None or [row.cells for row in grid] == cells


@given(LINES, st.sampled_from(["\n", ""]))
@example([["7", "1"], ["8", "2"]], "\n")
@example([["", ""]], "")
@example([["", "é"], ["\u3000", " "]], "")
def test_a_grid_has_the_rows_that_are_read_one_by_one(lines: list[list[str]], end: str) -> None:
    text = "\n".join(map(",".join, lines)) + end
    grid = read_grid(text, ",", 2, 7)
    if grid is None:
        return
    stray: list[int] = []
    assert [*grid] == [Row(line + 6, cells) for line, cells in read_records(text, ",", 2, stray)]
    assert not stray
    assert [grid[place] for place in range(-len(grid), 0)] == [*grid]
    assert [*grid.from_row(1)] == [*grid][1:] == [*grid[1:]]
    for part in (grid, grid.from_row(1)):
        for row in part:
            assert part.may_begin_row(row.cells[0])
    for number in (0, 1):
        assert grid.column(number) == [row.cells[number] for row in grid]


def test_a_beginning_that_no_row_has_is_told() -> None:
    grid = read_grid("id,1\n7,id\n", ",", 2, 1)
    assert grid is not None
    assert grid.may_begin_row("id")
    assert not grid.from_row(1).may_begin_row("id")


def test_most_files_are_grids_and_others_are_not() -> None:
    def is_grid(content: bytes) -> bool:
        return isinstance(parse_table(content, "a.csv").rows, CellGrid)

    assert is_grid(b"student;x\n007;0,5\n008;\n")
    assert is_grid("学号,x\n王,1".encode())
    assert is_grid(b'student,x\r\n"Byron, Ada",1\r\n\r\n"O""N",2\r\n')
    assert not is_grid(b'student,x\n"0\n07",1\n')
    assert not is_grid(b"student,x\n007\n")
    assert is_grid(b"student,x\n007,1\n,\n")
    assert is_grid(b"student,x\n\n007,1\n")


@given(st.lists(st.builds(Row, st.integers(1, 99), st.tuples(CELL, CELL)), min_size=1, max_size=5))
@example([Row(2, ("7",)), Row(3, ("7", "8"))])
@example([Row(2, ("", "a\x1f")), Row(4, ("b", "\n"))])
def test_rows_are_packed_into_a_grid_as_they_are(rows: list[Row]) -> None:
    grid = pack_grid(rows)
    odd = any(letter in cell for row in rows for cell in row.cells for letter in "\0\n\x1f")
    assert (grid is None) == (odd or len({len(row.cells) for row in rows}) > 1)
    assert grid is None or [*grid] == rows


@given(st.lists(st.text(max_size=22), max_size=5))
def test_letters_side_by_side_are_the_texts(texts: list[str]) -> None:
    letters = tabulate_letters(texts)
    odd = any("\n" in text or "\0" in text for text in texts)
    assert (letters is None) == odd
    if letters is not None:
        long = [len(text.encode("utf-8", "surrogatepass")) > 20 for text in texts]
        shown = [text.decode("utf-8", "surrogatepass") for text in letters.texts.tolist()]
        assert shown == ["" if left else text for left, text in zip(long, texts, strict=True)]
        assert letters.longer.tolist() == [place for place, left in enumerate(long) if left]
