"""Whether grades.csv still agrees with the sums of marks.csv: totals that were changed by hand are
refused.

A total kept by kept.csv is compared with kept.csv. Every amount is written to four decimal places,
so a sum of amounts may be off by half of the last place for each of them.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction
from pathlib import Path

from kinegrade.amounts import PLACES, write_amount
from kinegrade.errors import TableError
from kinegrade.language.lines import show_in_one_line
from kinegrade.marks_folder.cells import EXPECTED
from kinegrade.marks_folder.layout import ANSWERS, GRADES, KEPT, STATUSES
from kinegrade.marks_folder.rows import ClassTotals, StudentSums, StudentTotal

_HALF_A_PLACE = Fraction(1, 2 * 10**PLACES)
_MOST_NAMED = 20


def refuse_changed_totals(folder: Path, totals: ClassTotals, sums: Iterable[StudentSums]) -> None:
    """Raises TableError naming each row of grades.csv that contradicts marks.csv or kept.csv."""
    faults = list(_find_faults(totals, sums))
    if not faults:
        return
    path = folder / GRADES.name
    shown = [f"{path}{fault}" for fault in faults[:_MOST_NAMED]]
    more = len(faults) - len(shown)
    if more:
        shown.append(f"{path}: {more} more rows do not agree with {ANSWERS.name}")
    raise TableError(
        *(f"{fault} - {EXPECTED}; to change marks, grade by a --policy" for fault in shown)
    )


def _find_faults(totals: ClassTotals, sums: Iterable[StudentSums]) -> Iterator[str]:
    """The faults of grades.csv, each as the text that follows its path."""
    yield from _find_doubled(totals)
    rows = dict(totals.by_student)
    full = 0  # lines of the first student: no student has more
    for each in sums:
        row = rows.pop(each.student, None)
        if row is None:
            yield f': student "{show_in_one_line(each.student)}" has marks and no row here'
            continue
        lines = sum(each.lines.values())
        if not full:
            full = lines
            yield from (f": no column {name}" for name in each.points if name not in row.points)
        problems = "; ".join(_find_problems(row, each, is_whole=lines == full))
        if problems:
            yield _name_row(row, problems)
    for row in rows.values():
        yield _name_row(row, f"has no lines in {ANSWERS.name}")


def _find_doubled(totals: ClassTotals) -> Iterator[str]:
    seen: set[str] = set()
    for row in totals.students:
        if row.student in seen:
            yield _name_row(row, "stands there twice")
        seen.add(row.student)


def _name_row(row: StudentTotal, problem: str) -> str:
    return f':{row.line}: student "{show_in_one_line(row.student)}": {problem}'


def _find_problems(row: StudentTotal, sums: StudentSums, *, is_whole: bool) -> list[str]:
    """Where a student's row contradicts the sums.

    Missing lines of marks.csv are left to the commands that report or compare them.
    """
    lines = sum(sums.lines.values())
    problems = [*_find_wrong_points(row, sums), *_find_wrong_total(row, sums, lines)]
    if is_whole:
        problems += _describe_difference("out_of", row.out_of, sums.total_out_of, lines)
    problems += _find_wrong_status(row, sums)
    return problems or list(_find_wrong_percent(row))


def _find_wrong_points(row: StudentTotal, sums: StudentSums) -> Iterator[str]:
    for name, points in row.points.items():
        expected, lines = sums.points.get(name, Fraction(0)), sums.lines.get(name, 0)
        yield from _describe_difference(name, points, expected, lines)


def _find_wrong_total(row: StudentTotal, sums: StudentSums, lines: int) -> Iterator[str]:
    if row.kept is None:
        yield from _describe_difference("total", row.total, sums.total, lines)
    elif row.total != row.kept.stands:
        stands = write_amount(row.kept.stands)
        yield f"total is {write_amount(row.total)}, {stands} by {KEPT.name}"


def _find_wrong_percent(row: StudentTotal) -> Iterator[str]:
    """The percentage is compared with the total and the maximum beside it, all three rounded."""
    if row.percent is None:
        return
    expected = 100 * row.share
    rounding = Fraction(1, 100) * (1 + (1 / row.out_of if row.out_of else 0))
    if abs(row.percent - expected) > rounding:
        shown = write_amount(expected, places=2)
        yield f"percent is {write_amount(row.percent)}, {shown} by the total"


def _find_wrong_status(row: StudentTotal, sums: StudentSums) -> Iterator[str]:
    """Folders of earlier versions have no status."""
    if row.status is None:
        return
    if row.status not in STATUSES:
        yield f'status is "{show_in_one_line(row.status[:40])}", neither {" nor ".join(STATUSES)}'
    elif row.status == "absent" and sums.answered:
        yield f"status is absent, and {ANSWERS.name} has answers"


def _describe_difference(
    name: str, amount: Fraction, expected: Fraction, lines: int
) -> Iterator[str]:
    """The message where an amount is not the sum of so many lines, each of them rounded."""
    if amount == expected:
        return
    if abs(amount - expected) > (lines + 1) * _HALF_A_PLACE:
        yield f"{name} is {write_amount(amount)}, {write_amount(expected)} by {ANSWERS.name}"
