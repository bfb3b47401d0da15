"""Every shipped template has a figure that was graded A, as it is printed now, and none graded
worse.
"""

from __future__ import annotations

from pathlib import Path

from tests.figures.sheet import GRADES, find_lost, read_grades
from tests.prove.draws import seeded_template


def hold(seed: int, _: Path) -> None:
    """Look for the grades of the template of a seed."""
    name = seeded_template(seed).name
    rows = [row for row in read_grades(GRADES) if row.template == name]
    assert rows, f"{name}: no figure has been graded; see python -m tests.figures"
    worse = [
        f"{row.template} {row.seed}: {row.grade}, {row.reason}" for row in rows if row.grade != "A"
    ]
    assert worse + find_lost(rows) == []
