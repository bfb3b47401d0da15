"""Single cells of a file changed and nothing else, whatever its encoding, separator, quotation
marks and line ends.
"""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Literal

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.errors import TableError
from kinegrade.lms.grades.cells import Cell, CellTable, read_cells

TEXT = st.text(st.sampled_from('ab7,;\t" \n王é=+-'), max_size=6)


def read(folder: Path, content: bytes | str) -> CellTable:
    path = folder / "a.csv"
    path.write_bytes(content.encode() if isinstance(content, str) else content)
    return read_cells(path)


@dataclass(frozen=True)
class Style:
    """How a file is written."""

    encoding: str
    separator: str
    end: str
    quoting: Literal[0, 1]

    def written(self, lines: list[list[str]]) -> bytes:
        stream = io.StringIO()
        # Or the csv module leaves a line feed bare
        quoting = csv.QUOTE_ALL if self.end == "\r" else self.quoting
        csv.writer(
            stream, delimiter=self.separator, lineterminator=self.end, quoting=quoting
        ).writerows(lines)
        return stream.getvalue().encode(self.encoding)


STYLES = st.builds(
    Style,
    st.sampled_from(["utf-8", "utf-8-sig", "utf-16", "gb18030"]),
    st.sampled_from(",;\t"),
    st.sampled_from(["\n", "\r\n", "\r"]),
    st.sampled_from([csv.QUOTE_ALL, csv.QUOTE_MINIMAL]),
)
ROWS = st.lists(st.lists(TEXT, min_size=2, max_size=2), min_size=1, max_size=4)


@given(
    rows=ROWS,
    new=st.lists(TEXT, min_size=8, max_size=8),
    style=STYLES,
    picked=st.sets(st.integers(0, 7)),
)
def test_only_the_cells_that_change_are_written(
    rows: list[list[str]], new: list[str], style: Style, picked: set[int]
) -> None:
    lines = [["student", "学生姓名一览", "grade"], *(["7", *row] for row in rows)]
    content = style.written(lines)
    with TemporaryDirectory() as folder:
        table = read(Path(folder), content)
        assert texts(table) == lines
        assert table.with_cells({}) == content
        cells = [cell for row in table.rows for cell in row.cells[1:]]
        changes = {cell: new[place] for place, cell in enumerate(cells) if place in picked}
        after = read(Path(folder), table.with_cells(changes))
    assert texts(after)[1:] == [
        [changes.get(cell, cell.text) for cell in row.cells] for row in table.rows
    ]
    assert between(table, changes) == between(
        after,
        {
            now
            for row, other in zip(table.rows, after.rows, strict=True)
            for old, now in zip(row.cells, other.cells, strict=True)
            if old in changes
        },
    )


def texts(table: CellTable) -> list[list[str]]:
    return [[cell.text for cell in row.cells] for row in (table.header, *table.rows)]


def between(table: CellTable, cells: Iterable[Cell]) -> list[str]:
    """All of the file that stands outside these cells."""
    ordered = sorted(cells, key=lambda cell: cell.start)
    places = [0, *(place for cell in ordered for place in (cell.start, cell.end)), len(table.text)]
    return [table.text[start:end] for start, end in zip(places[::2], places[1::2], strict=True)]


def test_what_stands_between_changed_cells_stays(tmp_path: Path) -> None:
    content = '\ufeff"a";b ;"c"\r\n\r\n1; =";x ;"old""er"\n2;y;\r"3";;'
    table = read(tmp_path, content.replace('=";x', "=x"))
    last = [row.cells[2] for row in table.rows]
    written = table.with_cells(dict(zip(last, ["7.5", "8", "9;0"], strict=True)))
    assert written.decode() == '\ufeff"a";b ;"c"\r\n\r\n1; =x ;"7.5"\n2;y;8\r"3";;"9;0"'


def test_lines_are_counted_as_they_stand(tmp_path: Path) -> None:
    table = read(tmp_path, 'a,b\n\n"1\n2",3\r\n4,5')
    assert [row.line for row in table.rows] == [3, 5]


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ('a,b\n1,"2\n3,4\n', "a.csv:2: a quotation mark is not closed where its cell ends"),
        ('a,b\n1,"2"3\n', "a.csv:2: a quotation mark is not closed where its cell ends"),
        (
            "a,b\n1,2,3\n4\n",
            "a.csv:2: has 3 cells, the header 2 - expected the same number on every line",
        ),
        (
            b"\xef\xbb\xbfa,b\n1,\xff2\n",
            "a.csv:2: is UTF-8 by its byte-order mark, and not valid from this line on",
        ),
        (
            b"a,b\n\xff\xfe\x81,2\n\x81\x8d,3\n",
            "a.csv: its encoding cannot be recognised - expected UTF-8, UTF-16 or GB18030",
        ),
    ],
)
def test_what_could_not_be_written_back_is_refused(
    tmp_path: Path, content: bytes | str, message: str
) -> None:
    with pytest.raises(TableError, match=message):
        read(tmp_path, content)


def test_all_ragged_lines_are_told_at_once(tmp_path: Path) -> None:
    with pytest.raises(TableError) as caught:
        read(tmp_path, "a,b\n1,2,3\n4,5\n4\n")
    assert len(caught.value.problems) == 2
