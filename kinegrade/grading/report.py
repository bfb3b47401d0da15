"""The files of a marks folder: marks.csv, grades.csv, complaints.csv and the policy by which it was marked.

Called by `grade`, which has marks.csv written while it marks. kept.csv says whose total is not the sum of the
questions, where nobody was to be lowered. Typed text and names are written `neutralised`, so that no cell runs as a
formula in a spreadsheet; ids and numbers are written as they are. A response longer than a thousand characters is cut.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction
from functools import lru_cache
from itertools import chain
from pathlib import Path

from kinegrade.grading.amounts import amount_text
from kinegrade.grading.marks import ClassGrades, Grade, MarkedBlock, percent
from kinegrade.grading.marks_folder import KEPT
from kinegrade.grading.never_lower import Kept
from kinegrade.grading.policy import Policy
from kinegrade.grading.typed_cells import TypedCells
from kinegrade.tables import Complaint, csv_lines, csv_text, encoded, neutralised, shortened, write_csv

_MARKS = (
    "student",
    "question",
    "ask",
    "response",
    "read_as",
    "unit",
    "verdict",
    "points",
    "out_of",
    "reason",
)
POLICY = "policy.toml"
_NO_POLICY = "# No policy: marked as the papers say.\n"
_KEPT = ("student", "name", "before", "before_out_of", "by_this_marking", "out_of", "stands", "reason")
_COMPLAINTS = ("file", "line", "column", "content", "problem", "done")


def write_marks(folder: Path, blocks: Iterable[MarkedBlock]) -> Iterator[MarkedBlock]:
    """Writes marks.csv into an existing folder, block by block, and hands each block on when it is written."""
    with (folder / "marks.csv").open("wb") as stream:
        stream.write(encoded(csv_text(_MARKS, [])))
        for block in blocks:
            stream.write(encoded(csv_lines(_mark_rows(block))))
            yield block


def write_grades(folder: Path, grades: ClassGrades, policy: Policy, kept: Iterable[Kept] | None) -> None:
    """Writes the other files; `kept` is None where totals may fall."""
    header = ("student", "name", *grades.questions, "total", "out_of", "percent")
    write_csv(folder / "grades.csv", header, map(_grade_row, grades.grades))
    write_csv(folder / "complaints.csv", _COMPLAINTS, _complaint_rows(grades.complaints))
    (folder / POLICY).write_bytes((policy.text or _NO_POLICY).encode("utf-8"))
    if kept is not None:
        write_csv(folder / KEPT, _KEPT, map(_kept_row, kept))


def _mark_rows(block: MarkedBlock) -> Iterator[tuple[str, ...]]:
    """A row for each answer, put together column by column."""
    judged, asks = block.judged, block.asks
    count = len(judged.rows)
    points = [[amount_text(share * ask.points) for share in judged.credits] for ask in asks]
    return zip(
        chain.from_iterable([paper.student] * len(asks) for paper, _ in judged.rows),
        [ask.question for ask in asks] * count,
        [ask.ask for ask in asks] * count,
        _responses(judged.cells),
        judged.cells.read_as,
        [ask.unit for ask in asks] * count,
        judged.kinds,
        [texts[share] for texts, share in zip(points * count, judged.shares, strict=True)],
        [amount_text(ask.points) for ask in asks] * count,
        [reason if reason[:4] == "key " else neutralised(reason) for reason in judged.reasons],
        strict=True,
    )


def _responses(cells: TypedCells) -> list[str]:
    """What was typed, fit for a spreadsheet; plain numbers, which are most of it, are so as they stand."""
    responses = list(cells.typed)
    for place, reading in cells.odd.items():
        responses[place] = neutralised(shortened(reading.typed))
    return responses


def _grade_row(grade: Grade) -> tuple[str, ...]:
    total = grade.total
    points = map(amount_text, (*grade.points, total, grade.out_of))
    return (grade.student, neutralised(grade.name), *points, _percent(total, grade.out_of))


@lru_cache(maxsize=4096)
def _percent(total: Fraction, out_of: Fraction) -> str:
    return amount_text(percent(total, out_of), places=2)


def _kept_row(kept: Kept) -> tuple[str, ...]:
    now, before = kept.grade, kept.before
    amounts = (before.points, before.out_of, now.total, now.out_of, kept.stands)
    return (now.student, neutralised(now.name), *map(amount_text, amounts), kept.reason)


def _complaint_rows(complaints: Iterable[Complaint]) -> Iterator[tuple[str, ...]]:
    for each in complaints:
        line = "" if each.line is None else str(each.line)
        texts = map(neutralised, (each.column, each.content, each.problem, each.done))
        yield (neutralised(each.file), line, *texts)
