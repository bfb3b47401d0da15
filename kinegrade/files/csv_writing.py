"""CSV as kinegrade writes it: UTF-8, LF, comma; files for people have a byte-order mark, because
spreadsheets garble names without it.

`neutralise` keeps a typed cell from running as a formula in a spreadsheet, `restore` undoes it.
"""

from __future__ import annotations

import csv
import re
from codecs import BOM_UTF8
from collections.abc import Iterable, Sequence
from itertools import chain
from pathlib import Path

_NEEDS_QUOTES = ',"\r\n'
_QUOTED = re.compile(f"[{_NEEDS_QUOTES}]")
_BEGINS_FORMULA = r"'*[=+\-@\t\r\n\uff1d\uff0b\uff0d\uff20]"
_FORMULA, _FORMULA_LINE = re.compile(_BEGINS_FORMULA), re.compile(f"\n{_BEGINS_FORMULA}")
_HARMLESS = re.compile(r"-|[+-]?(?:[0-9]+(?:[.,][0-9]*)?|[.,][0-9]+)(?:[eE][+-]?[0-9]+)?")


def neutralise(text: str) -> str:
    """A cell that no spreadsheet runs as a formula: = + - @, a tab or a line break at its beginning
    is preceded by an apostrophe.

    Plain numbers and a lone dash are unchanged. `restore` is exact, because apostrophes typed
    before such a sign get one more.

    >>> neutralise("=1+1"), neutralise("-12"), neutralise("O'Neil")
    ("'=1+1", '-12', "O'Neil")
    """
    if not _FORMULA.match(text) or _HARMLESS.fullmatch(text):
        return text
    return f"'{text}"


def restore(text: str) -> str:
    """The cell from which `neutralise` made this one."""
    return text[1:] if text.startswith("'") and _FORMULA.match(text) else text


def write_csv_text(header: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """A CSV text with LF line ends; cells are already texts, so no number changes its digits."""
    # CR LF as the terminator makes the csv module quote a cell with a lone CR; the terminator is
    # then cut off.
    lines = _Lines()
    csv.writer(lines, lineterminator="\r\n").writerows(chain([header], rows))
    text = "".join(lines.written)
    if text.count("\r") == len(lines.written):
        return text.replace("\r\n", "\n")
    return "".join(f"{line[:-2]}\n" for line in lines.written)


def write_quoted_csv_text(header: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """The same with every cell in quotation marks."""
    return "".join(
        ",".join('"' + cell.replace('"', '""') + '"' for cell in line) + "\n"
        for line in chain([header], rows)
    )


def write_csv_cell(text: str) -> str:
    """A cell as `write_csv_text` writes it among others: in quotation marks only where necessary.

    >>> write_csv_cell("0.5"), write_csv_cell("0,5"), write_csv_cell("v = 0,5")
    ('0.5', '"0,5"', '"v = 0,5"')
    """
    if _QUOTED.search(text) is None:
        return text
    doubled = text.replace('"', '""')
    return f'"{doubled}"'


def write_csv_cells(texts: Sequence[str]) -> Sequence[str]:
    """The same of many texts, most of which stand as they are.

    >>> write_csv_cells(["0.5", "0,5"])
    ['0.5', '"0,5"']
    """
    together = "".join(texts)
    if not any(letter in together for letter in _NEEDS_QUOTES):
        return texts
    return [*map(write_csv_cell, texts)]


def neutralise_cells(texts: Sequence[str]) -> Sequence[str]:
    """Many cells that no spreadsheet runs as formulas; most stand as they are.

    >>> neutralise_cells(["Ada", "=1+1"])
    ['Ada', "'=1+1"]
    """
    lines = "\n".join(["", *texts])
    if lines.count("\n") == len(texts) and _FORMULA_LINE.search(lines) is None:
        return texts
    return [*map(neutralise, texts)]


def write_csv(path: Path, header: Sequence[str], rows: Iterable[Sequence[str]]) -> None:
    """Writes a CSV file: UTF-8 without mark, LF, comma."""
    path.write_bytes(encode(write_csv_text(header, rows)))


def write_for_people(path: Path, header: Sequence[str], rows: Iterable[Sequence[str]]) -> None:
    """Writes a CSV file that people open in a spreadsheet."""
    path.write_bytes(encode_for_people(write_csv_text(header, rows)))


def encode_for_people(text: str) -> bytes:
    """A CSV text as a file that people open: by its byte-order mark, a spreadsheet recognises
    UTF-8.

    >>> encode_for_people("id\\n")
    b'\\xef\\xbb\\xbfid\\n'
    """
    return BOM_UTF8 + encode(text)


def encode(text: str) -> bytes:
    """A text as kinegrade writes it into files: UTF-8; a lone surrogate is written as an escape."""
    return text.encode("utf-8", "backslashreplace")


class _Lines:
    """Collects the csv module's output, one record at a time."""

    def __init__(self) -> None:
        self.written: list[str] = []
        self.write = self.written.append
