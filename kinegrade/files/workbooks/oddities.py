"""What a sheet holds that is not read as it is shown: formulas, errors, other sheets."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

from kinegrade.files.cell_text import shorten, trim
from kinegrade.files.tables import Complaint
from kinegrade.files.workbooks.cells import BLANK, Cell, Line, Room, open_workbook, read_rows
from kinegrade.language.message import Message, Quoted, list_plainly

_TEXT_FORMULA = re.compile(r'=\s*"([^"]*)"')  # keeps the zeros of an id


def note_formulas(path: Path, name: str, lines: list[Line]) -> list[Line]:
    """The lines, with a remark for each cell that a formula computes."""
    with open_workbook(path, values=False) as workbook:
        computed = {
            (line, place): str(getattr(cell.value, "text", cell.value))
            for line, row in read_rows(path, workbook[name], Room())
            for place, cell in enumerate(row)
            if cell.data_type == "f"
        }
    widths = dict[int, int]()
    for line, place in computed:  # behind the last filled cell, too
        widths[line] = max(widths.get(line, 0), place + 1)
    return [
        (
            line,
            [
                _note_formula(cell, computed.get((line, place)))
                for place, cell in enumerate(_widen(cells, widths.get(line, 0)))
            ],
        )
        for line, cells in lines
    ]


def _widen(cells: list[Cell], width: int) -> list[Cell]:
    return cells + [BLANK] * (width - len(cells))


def _note_formula(cell: Cell, formula: str | None) -> Cell:
    if formula is None:
        return cell
    text = _TEXT_FORMULA.fullmatch(formula)
    if text and cell.text in ("", text[1]):
        return Cell(text[1])
    shown = shorten(formula)
    if cell.text:
        return Cell(cell.text, Message("files.cell-formula", formula=shown))
    return Cell(cell.text, Message("files.cell-never-computed", formula=shown))


def find_oddities(file: str, titles: Sequence[str], lines: Sequence[Line]) -> Iterator[Complaint]:
    """What is odd about single cells, as dates and digits that a spreadsheet changed."""
    for line, cells in lines:
        for place, cell in enumerate(cells):
            if cell.remark:
                column = titles[place] if place < len(titles) else ""
                stands = Message("files.taken-as-it-stands")
                done = stands if cell.text else Message("files.read-as-blank")
                yield Complaint(file, line, column, shorten(cell.text), cell.remark, done)


def find_surplus(file: str, rows: Sequence[Line], width: int) -> Iterator[Complaint]:
    """The filled cells beyond the last column that has a title."""
    for line, cells in rows:
        surplus = "; ".join(cell.text for cell in cells[width:] if trim(cell.text))
        if surplus:
            problem, done = Message("files.beside-table"), Message("files.surplus-kept")
            yield Complaint(file, line, "", shorten(surplus), problem, done)


def note_sheets(file: str, name: str, filled: Iterable[str]) -> Iterator[Complaint]:
    """The other filled sheets, which are not read."""
    first, *rest = filled
    others = [each for each in (first, *rest) if each != name]
    if not others:
        return
    read, left = Quoted(name), list_plainly(map(Quoted, others))
    if name == first:
        done = Message("files.first-sheet", sheet=read, others=left)
    else:
        done = Message("files.known-sheet", sheet=read, others=left)
    yield Complaint(file, None, "", ", ".join(others), Message("files.several-sheets"), done)
