"""Whether grades.csv still agrees with the sums of marks.csv: totals that were changed by hand are
refused.

A total kept by kept.csv is compared with kept.csv. Every amount is written to four decimal places,
so a sum of amounts may be off by half of the last place for each of them.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

from kinegrade.errors import TableError
from kinegrade.grade_scale.scale import Scale
from kinegrade.language.message import (
    Fault,
    Message,
    Part,
    Quoted,
    list_choices,
    list_statements,
)
from kinegrade.marks_folder.cells import AS_WRITTEN
from kinegrade.marks_folder.hand_marks import are_edited
from kinegrade.marks_folder.layout import ANSWERS, GRADES, KEPT, MANUAL, STATUSES
from kinegrade.marks_folder.rows import ClassTotals, StudentSums, StudentTotal
from kinegrade.numbers.amounts import bound_rounding, write_amount

_MOST_NAMED = 20


def refuse_changed_totals(
    folder: Path, totals: ClassTotals, sums: Sequence[StudentSums], scale: Scale | None
) -> None:
    """Raises TableError naming each row of grades.csv that contradicts marks.csv, kept.csv or
    scale.csv.
    """
    path = folder / GRADES.name
    faults = [*_find_faults(path, totals, sums), *_find_changed_grades(path, totals, scale)]
    if not faults:
        return
    shown = faults[:_MOST_NAMED]
    more = len(faults) - len(shown)
    if more:
        shown.append(_explain(path, Message("marks.more-rows", count=more, file=ANSWERS.name)))
    if are_edited(folder):
        do = Message("marks.grade-edited", file=MANUAL.name)
        shown = [replace(fault, do=do) for fault in shown]
    raise TableError(*shown)


def _explain(where: Path | str, problem: Message) -> Fault:
    return Fault(str(where), problem, AS_WRITTEN, Message("marks.grade-again-or-policy"))


def _find_faults(path: Path, totals: ClassTotals, sums: Sequence[StudentSums]) -> Iterator[Fault]:
    """The faults of grades.csv, which is at `path`."""
    agreeing: set[tuple[object, ...]] = set()
    yield from _find_doubled(path, totals)
    rows = dict(totals.by_student)
    full = 0  # lines of the first student: no student has more
    for each in sums:
        row = rows.pop(each.student, None)
        if row is None:
            yield _explain(path, Message("marks.no-row", student=Quoted(each.student)))
            continue
        lines = each.points.lines
        if not full:
            full = lines
            yield from (
                _explain(path, Message("marks.no-column", columns=name))
                for name in each.points.by_question
                if name not in totals.questions
            )
        shared = _list_shared(row, each)
        if (lines, *shared) in agreeing:
            continue
        problems = _find_problems(row, each, is_whole=lines == full)
        if not problems:
            agreeing.add((lines, *shared))
        else:
            yield _name_row(path, row, list_statements(problems))
    for row in rows.values():
        yield _name_row(path, row, Message("marks.no-lines", file=ANSWERS.name))


def _list_shared(row: StudentTotal, sums: StudentSums) -> tuple[object, ...]:
    """All on which it depends whether a row agrees with the sums; most students share it with
    others. By identity, as hashing fractions takes longer than comparing them; rows and sums are
    kept, so that no other amount has the identity of one of theirs.
    """
    amounts = (row.points, row.total, row.out_of, row.percent, row.subtracted, row.kept)
    added = (sums.points, sums.out_of, sums.bonus)
    return (row.status, sums.answered, sums.by_hand, *map(id, (*amounts, *added)))


def _find_doubled(path: Path, totals: ClassTotals) -> Iterator[Fault]:
    seen: set[str] = set()
    for row in totals.students:
        if row.student in seen:
            yield _name_row(path, row, Message("marks.twice"))
        seen.add(row.student)


def _name_row(path: Path, row: StudentTotal, problem: Part) -> Fault:
    student = Quoted(row.student)
    where = f"{path}:{row.line}"
    return _explain(where, Message("marks.row", student=student, problem=problem))


def _find_problems(row: StudentTotal, sums: StudentSums, *, is_whole: bool) -> list[Message]:
    """Where a student's row contradicts the sums.

    Missing lines of marks.csv are left to the commands that report or compare them.
    """
    lines = sums.points.lines
    problems = [*_find_wrong_points(row, sums), *_find_wrong_total(row, sums, lines)]
    if is_whole:
        problems += _describe_difference("out_of", row.out_of, sums.total_out_of, lines, sums)
    problems += _find_wrong_status(row, sums)
    return problems or list(_find_wrong_percent(row))


def _find_wrong_points(row: StudentTotal, sums: StudentSums) -> Iterator[Message]:
    for name, points in row.points.items():
        expected = sums.points.by_question.get(name, Fraction(0))
        lines = sums.points.counts.get(name, 0)
        yield from _describe_difference(name, points, expected, lines, sums)


def _find_wrong_total(row: StudentTotal, sums: StudentSums, lines: int) -> Iterator[Message]:
    if row.kept is None:
        expected = sums.points.total - row.subtracted
        yield from _describe_difference("total", row.total, expected, lines + 1, sums)
    elif row.total != row.kept.stands:
        yield _contradict("total", row.total, row.kept.stands, KEPT.name)


def _find_changed_grades(path: Path, totals: ClassTotals, scale: Scale | None) -> Iterator[Fault]:
    """The rows whose grade is not the one of their total by the scale."""
    for row in totals.students:
        expected = _list_possible_grades(row, scale)
        if row.grade not in expected:
            names = list_choices(map(Quoted, expected))
            problem = Message("marks.grade", grade=Quoted(row.grade[:40]), expected=names)
            yield _name_row(path, row, problem)


def _list_possible_grades(row: StudentTotal, scale: Scale | None) -> Sequence[str]:
    """The grades that a total may have had before it was rounded to be written."""
    if scale is None:
        return ("",)
    if not row.is_present:
        return (scale.absent,)
    rounding = bound_rounding(1) / row.out_of if row.out_of else Fraction(0)
    ends = max(row.share - rounding, Fraction(0)), row.share, row.share + rounding
    return list(dict.fromkeys(scale.find_step(share).grade for share in ends))


def _find_wrong_percent(row: StudentTotal) -> Iterator[Message]:
    """The percentage is compared with the total and the maximum beside it, all three rounded."""
    if row.percent is None:
        return
    expected = 100 * row.share
    rounding = Fraction(1, 100) * (1 + (1 / row.out_of if row.out_of else 0))
    if abs(row.percent - expected) > rounding:
        shown = write_amount(expected, places=2)
        yield Message("marks.percent", percent=write_amount(row.percent), expected=shown)


def _find_wrong_status(row: StudentTotal, sums: StudentSums) -> Iterator[Message]:
    """Folders of earlier versions have no status."""
    if row.status is None:
        return
    if row.status not in STATUSES:
        marked, absent = STATUSES
        status = Quoted(row.status[:40])
        yield Message("marks.status", status=status, marked=marked, absent=absent)
    elif row.status == "absent" and sums.answered:
        yield Message("marks.absent", status=row.status, file=ANSWERS.name)


def _describe_difference(
    name: str, amount: Fraction, expected: Fraction, lines: int, sums: StudentSums
) -> Iterator[Message]:
    """What is said where an amount is not the sum of so many lines, each of them rounded."""
    if amount == expected:
        return
    if abs(amount - expected) > bound_rounding(lines):
        file = MANUAL.name if sums.by_hand else ANSWERS.name
        yield _contradict(name, amount, expected, file)


def _contradict(name: str, amount: Fraction, expected: Fraction, file: str) -> Message:
    """What is said of an amount where a file gives another one."""
    return Message(
        "marks.contradicted",
        column=name,
        amount=write_amount(amount),
        expected=write_amount(expected),
        file=file,
    )
