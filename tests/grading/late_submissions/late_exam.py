"""An exam with a due date, marked with a policy on lateness, and the totals of its students."""

from __future__ import annotations

import csv
from collections.abc import Sequence
from datetime import timedelta
from pathlib import Path

from click.testing import Result

from tests.grading.marked_folder import COLUMNS, RIGHT
from tests.small_class import kinegrade, table

DUE = "2026-12-01 18:00"
LATE = '[late]\npenalty = "10 %"\n'
WRONG = ("9", "9", "9")
DAY = timedelta(days=1)


Rows = Sequence[tuple[str, str, Sequence[str]]]  # student, time, answers


IN_TIME: Rows = [
    ("7", "2026-12-01 18:00", RIGHT),
    ("8", "2026-12-01 18:10", RIGHT),
    ("9", "2026-12-02 18:10:01", RIGHT),
]


def grade(exam: Path, policy: str, rows: Rows = IN_TIME, name: str = "LATE", *more: str) -> Result:
    """The class marked by a policy, from a sheet that says when each row was handed in."""
    sheet, file = exam.parent / "typed.csv", exam.parent / "policy.toml"
    with sheet.open("w", encoding="utf-8", newline="") as stream:
        writer = csv.writer(stream)
        writer.writerow(["student", "submitted", *COLUMNS])
        writer.writerows([student, time, *cells] for student, time, cells in rows)
    file.write_text(policy, encoding="utf-8")
    wishes = "-o", exam.parent / name, "--policy", file, *more
    return kinegrade("grade", exam, sheet, *wishes)


def totals(exam: Path, name: str = "LATE") -> dict[str, tuple[str, str]]:
    """What each student has, and what was subtracted."""
    rows = table(exam.parent / name / "grades.csv")
    return {row["student"]: (row["total"], row["subtracted"]) for row in rows}
