"""kept.csv read: the students whose earlier total stands."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from kinegrade.files.csv_writing import restore
from kinegrade.marks_folder.cells import Record, read_amount, read_records_if_any
from kinegrade.marks_folder.layout import KEPT
from kinegrade.marks_folder.rows import KeptTotal


def read_kept_totals(folder: Path) -> Mapping[str, KeptTotal]:
    """The earlier totals by student; none where there is no such file. Raises TableError."""
    path = folder / KEPT.name
    records = read_records_if_any(folder, KEPT)
    return {cells[0]: _read_kept_total(cells, path, line) for line, cells in records}


def _read_kept_total(cells: Record, path: Path, line: int) -> KeptTotal:
    student, name, *amounts, reason = cells
    columns = KEPT.columns[2:-1]
    points = [
        read_amount(cell, path, line, column) for cell, column in zip(amounts, columns, strict=True)
    ]
    return KeptTotal(student, restore(name), restore(reason), *points)
