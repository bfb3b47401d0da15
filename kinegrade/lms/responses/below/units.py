"""Units that stand in a column of their own beside answers one below the other."""

from __future__ import annotations

from kinegrade.files.cell_text import is_answered, trim
from kinegrade.files.rows.row import Row
from kinegrade.lms.responses.below.columns import LongColumns

# Signs of units that are no letters
_SIGNS = frozenset("°%‰'\"′″℃")
# What people put where there is no unit
_NONE = frozenset(("", "-", "–", "—", "−", "/", "1"))


def join_unit(row: Row, columns: LongColumns) -> Row:
    """A row with its unit behind the answer, as if it had been typed so."""
    unit = find_unit(row, columns)
    answer = row.cell(columns.answer)
    if not unit or not _is_unit(unit) or not is_answered(answer) or _ends_with(answer, unit):
        return row
    cells = list(row.cells)
    cells[columns.answer] = f"{trim(answer)} {unit}"
    return Row(row.line, tuple(cells))


def find_unit(row: Row, columns: LongColumns) -> str:
    """What stands there for a unit, "" where nothing does, or a sign that there is none."""
    written = "".join(trim(row.cell(place)) for place in columns.unit)
    return "" if written in _NONE else written


def is_no_unit(row: Row, columns: LongColumns) -> bool:
    """Whether what stands there can be no unit, such as a number, which would join the answer's."""
    unit = find_unit(row, columns)
    return bool(unit) and not _is_unit(unit)


def _is_unit(written: str) -> bool:
    return written[0].isalpha() or written[0] in _SIGNS


def _ends_with(answer: str, unit: str) -> bool:
    """Whether the unit was typed behind the answer, too: "25 mm" does not end with m."""
    before = trim(answer).removesuffix(unit)
    return before != trim(answer) and (before[-1:].isspace() or before[-1:].isdecimal())
