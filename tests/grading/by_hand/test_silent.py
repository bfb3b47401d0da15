"""A mark by hand of nothing for somebody who typed nothing: present, or absent?"""

from __future__ import annotations

from pathlib import Path

from tests.grading.by_hand.hand_marking import ADA, SOFYA, give
from tests.small_class import table


def empty_row_of(folder: Path, student: str) -> None:
    """The student typed nothing."""
    file = folder / "answers.csv"
    head, *rows = file.read_text(encoding="utf-8").splitlines()
    cells = head.count(",") - 1
    kept = [f"{student},{',' * cells}" if row.startswith(student) else row for row in rows]
    file.write_text("\n".join([head, *kept]) + "\n", encoding="utf-8")


def test_who_is_present_by_a_mark_of_nothing_is_named(folder: Path) -> None:
    empty_row_of(folder, SOFYA)
    done = give(folder, f"{ADA},q2,0,\n{SOFYA},q2,0,\n")
    assert (
        f'1 student who typed nothing has no point by hand, and counts as present: "{SOFYA}"; '
        "whoever was absent has no row in manual.csv\n"
    ) in done.stderr
    status = {row["student"]: row["status"] for row in table(folder / "MARKS" / "grades.csv")}
    assert status[SOFYA] == "marked"


def test_who_has_a_point_by_hand_was_there(folder: Path) -> None:
    empty_row_of(folder, SOFYA)
    done = give(folder, f"{ADA},q2,0,\n{SOFYA},q2,1,\n")
    assert "counts as present" not in done.stderr
