"""The files of a marks folder: marks.csv, grades.csv, complaints.csv and the policy by which it was
marked.

Called by `grade`, which has marks.csv written while it marks. kept.csv says whose total is not the
sum of the questions, where nobody was to be lowered. Typed text and names are written
`neutralised`, so that no cell runs as a formula in a spreadsheet; ids and numbers are written as
they are. A response longer than a thousand characters is cut.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from fractions import Fraction
from itertools import chain
from pathlib import Path
from typing import Literal

from kinegrade.csv_writing import (
    csv_cell,
    csv_text,
    encoded,
    neutralised,
    write_csv,
    write_for_people,
)
from kinegrade.grading.amounts import amount_text
from kinegrade.grading.answers import Reading
from kinegrade.grading.kept_totals import Kept
from kinegrade.grading.marks import ClassGrades, Grade, MarkedBlock, percent
from kinegrade.grading.marks_folder import KEPT
from kinegrade.grading.policy import Policy
from kinegrade.grading.pool import HEADER, VARIANTS, put_rows
from kinegrade.grading.typed_cells import TypedCells
from kinegrade.tables import Complaint, shortened

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
Status = Literal["marked", "absent"]  # who is absent answered nothing at all
POLICY = "policy.toml"
_NO_POLICY = "# No policy: marked as the papers say.\n"
_KEPT = (
    "student",
    "name",
    "before",
    "before_out_of",
    "by_this_marking",
    "out_of",
    "stands",
    "reason",
)
_COMPLAINTS = ("file", "line", "column", "content", "problem", "done")


def write_marks(folder: Path, blocks: Iterable[MarkedBlock]) -> Iterator[MarkedBlock]:
    """Writes marks.csv into an existing folder, block by block, and hands each block on when it is
    written.

    variants.csv is written where answers were marked by other lines of the key than the student's
    own.
    """
    put: list[tuple[str, ...]] = []
    with (folder / "marks.csv").open("wb") as stream:
        stream.write(encoded(csv_text(_MARKS, [])))
        for block in blocks:
            stream.write(encoded(_mark_lines(block)))
            for paper, _ in block.judged.rows:
                if paper.put:
                    put += put_rows(block.asks, paper)
            yield block
    if put:
        write_csv(folder / VARIANTS, HEADER, put)


def write_grades(
    folder: Path, grades: ClassGrades, policy: Policy, kept: Iterable[Kept] | None
) -> None:
    """Writes the other files; `kept` is None where totals may fall."""
    header = ("student", "name", *grades.questions, "total", "out_of", "percent", "status")
    write_for_people(folder / "grades.csv", header, _grade_rows(grades.grades))
    write_for_people(folder / "complaints.csv", _COMPLAINTS, _complaint_rows(grades.complaints))
    (folder / POLICY).write_bytes((policy.text or _NO_POLICY).encode("utf-8"))
    if kept is not None:
        write_for_people(folder / KEPT, _KEPT, map(_kept_row, kept))


def _mark_lines(block: MarkedBlock) -> str:
    """A line for each answer, put together by columns: each with what stands between it and the
    next.
    """
    judged, asks, count = block.judged, block.asks, len(block.judged.rows)
    points = [[amount_text(share * ask.points) for share in judged.credits] for ask in asks]
    columns: tuple[Sequence[str], ...] = (
        [*chain.from_iterable([csv_cell(paper.student)] * len(asks) for paper, _ in judged.rows)],
        [f",{csv_cell(ask.question)},{csv_cell(ask.ask)}," for ask in asks] * count,
        _with_odd(
            judged.cells.typed, judged.cells, lambda reading: neutralised(shortened(reading.typed))
        ),
        [","] * len(judged.kinds),
        _with_odd(judged.cells.read_as, judged.cells, lambda reading: reading.read_as),
        [f",{csv_cell(ask.unit)}," for ask in asks] * count,
        judged.kinds,
        [","] * len(judged.kinds),
        [texts[share] for texts, share in zip(points * count, judged.shares, strict=True)],
        [f",{amount_text(ask.points)}," for ask in asks] * count,
        [
            f'"{reason}"'
            if reason[:4] == "key " and '"' not in reason
            else csv_cell(neutralised(reason))
            for reason in judged.reasons
        ],
        ["\n"] * len(judged.kinds),
    )
    parts = [""] * (len(columns) * len(judged.kinds))
    for place, column in enumerate(columns):
        parts[place :: len(columns)] = column
    return "".join(parts)


def _with_odd(
    texts: Sequence[str], cells: TypedCells, text_of: Callable[[Reading], str]
) -> list[str]:
    """A column of cells fit for a file; those of plain numbers, which are most, are so as they
    stand.
    """
    column = list(texts)
    for place, reading in cells.odd.items():
        column[place] = csv_cell(text_of(reading))
    return column


def _grade_rows(grades: Sequence[Grade]) -> Iterator[tuple[str, ...]]:
    """Most students share their points, as one and the same tuple, with others: such amounts are
    written once.
    """
    known: dict[tuple[int, int, Fraction | None], tuple[str, ...]] = {}
    for grade in grades:
        which = id(grade.points), id(grade.out_of), grade.kept
        status: Status = "absent" if grade.absent else "marked"
        if which not in known:
            known[which] = _amounts(grade)
        yield (grade.student, neutralised(grade.name), *known[which], status)


def _amounts(grade: Grade) -> tuple[str, ...]:
    """Points by question, in all, out of, and in per cent."""
    total, out_of = grade.total, grade.out_of
    return *map(amount_text, (*grade.points, total, out_of)), amount_text(
        percent(total, out_of), places=2
    )


def _kept_row(kept: Kept) -> tuple[str, ...]:
    now, before = kept.grade, kept.before
    amounts = (before.points, before.out_of, now.total, now.out_of, kept.stands)
    return (now.student, neutralised(now.name), *map(amount_text, amounts), kept.reason)


def _complaint_rows(complaints: Iterable[Complaint]) -> Iterator[tuple[str, ...]]:
    for each in complaints:
        line = "" if each.line is None else str(each.line)
        texts = map(neutralised, (each.column, each.content, each.problem, each.done))
        yield (neutralised(each.file), line, *texts)
