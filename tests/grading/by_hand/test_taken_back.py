"""A mark by hand taken back by deleting its row, in a folder whose changes are logged."""

from __future__ import annotations

import os
from pathlib import Path

from tests.grading.by_hand.hand_marking import ADA, SOFYA, faults, give, grade, totals
from tests.small_class import table

_LATER = 10**10  # in nanoseconds: when a file is saved by hand


def logged(folder: Path, reason: str) -> tuple[str | Path, ...]:
    """The options by which the changes of a folder are logged."""
    return "--since", folder / "MARKS", "--reason", reason


def save(file: Path, text: str) -> None:
    """Save a file as a person does, some seconds after it was written."""
    file.write_text(text, encoding="utf-8")
    time = file.parent.joinpath("complaints.csv").stat().st_mtime_ns + _LATER
    os.utime(file, ns=(time, time))


def take_back(folder: Path) -> None:
    """Delete Ada's row."""
    file = folder / "MARKS" / "manual.csv"
    rows = file.read_text(encoding="utf-8").splitlines(keepends=True)
    save(file, "".join(row for row in rows if not row.startswith(ADA)))


def test_a_mark_by_hand_is_taken_back_in_a_folder_with_a_log(folder: Path) -> None:
    given = f"{ADA},bonus,2,\n{ADA},q2,2,\n{SOFYA},q2,2,\n"
    give(folder, given, *logged(folder, "hearing"))
    assert totals(folder)[ADA] == ("11", "9.5")
    take_back(folder)
    done = grade(folder, *logged(folder, "for another"))
    assert done.exit_code == 1, done.stderr  # her q2 is open again
    assert totals(folder)[ADA] == ("7", "9.5")
    rows = [row for row in table(folder / "MARKS" / "changes.csv") if row["student"] == ADA]
    last = [row for row in rows if row["reason"] == "for another" and row["what"] == "total"]
    assert [(row["before"], row["after"]) for row in last] == [("11", "7")]


def test_nothing_is_lowered_by_a_mark_that_is_taken_back(folder: Path) -> None:
    give(folder, f"{ADA},q1,1,\n{SOFYA},q1,1,\n")
    take_back(folder)
    done = grade(folder, "--never-lower", folder / "MARKS", marks="NEW")
    assert done.exit_code == 0, done.stderr
    assert totals(folder, "NEW")[ADA] == ("7", "7")


def test_totals_that_were_changed_by_hand_are_refused_still(folder: Path) -> None:
    give(folder, f"{ADA},q1,1,\n")
    take_back(folder)
    totals_file = folder / "MARKS" / "grades.csv"
    text = totals_file.read_text(encoding="utf-8")
    save(totals_file, text.replace(f"{SOFYA},", f"{SOFYA},", 1))
    (fault,) = faults(grade(folder, *logged(folder, "why")), folder)
    assert "grades.csv" in fault
    assert "expected the file as kinegrade grade wrote it" in fault
