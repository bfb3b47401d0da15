"""What a comma or a point before three digits means in a sheet."""

from __future__ import annotations

from kinegrade.grading.sheets.grid_entries import GridEntries
from kinegrade.grading.sheets.sheet import Sheet
from kinegrade.grading.typed.decimal_style import (
    FileStyle,
    Mark,
    find_common_style,
    find_file_style,
)


def find_sheet_style(sheet: Sheet, declared: Mark | None) -> FileStyle:
    """The style of a sheet from the last row of each student, or as declared."""
    entries = sheet.entries
    if isinstance(entries, GridEntries) and declared is None:
        return find_common_style(entries.blocks())
    return find_file_style((each[-1].responses for each in entries.values()), declared)
