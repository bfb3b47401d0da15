"""A table of a marks folder as a notebook shows it: every cell as it stands, escaped."""

from __future__ import annotations

from collections.abc import Iterable

from kinegrade.files.tables import Table
from kinegrade.language.html_text import write_plain_html

_SHOWN = 60  # rows; a longer table ends in dots


def write_table_html(table: Table) -> str:
    """The table as HTML."""
    rows = [_write_row("td", row.cells) for row in table.rows[:_SHOWN]]
    if len(table.rows) > _SHOWN:
        rows.append(_write_row("td", ("…",)))
    head = _write_row("th", table.header)
    return f"<table><thead>{head}</thead><tbody>{''.join(rows)}</tbody></table>"


def _write_row(tag: str, cells: Iterable[str]) -> str:
    written = "".join(f"<{tag}>{write_plain_html(cell)}</{tag}>" for cell in cells)
    return f"<tr>{written}</tr>"
