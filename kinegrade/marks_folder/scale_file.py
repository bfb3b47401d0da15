"""scale.csv: the scale by which a class was graded, as written and as read again."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from pathlib import Path
from typing import Final

from kinegrade.errors import TableError
from kinegrade.files.csv_writing import neutralise, restore
from kinegrade.grade_scale.scale import Scale, Step
from kinegrade.language.message import Message
from kinegrade.marks_folder.cells import explain_cell, explain_edited, read_records_if_any
from kinegrade.marks_folder.layout import SCALE

_PASSED: Final = "passed"
_FAILED: Final = "failed"
_ABSENT: Final = "absent"
_RESULTS: Final = (_PASSED, _FAILED, _ABSENT)
_FULL = 100
_LONGEST = 60  # characters of a bound


def write_scale_rows(scale: Scale) -> Iterator[tuple[str, str, str]]:
    """The lines of a scale; bounds are exact percentages, such as 50 or 200/3."""
    for step in scale.steps:
        result = _PASSED if step.passes else _FAILED
        yield neutralise(step.grade), str(_FULL * step.least), result
    yield neutralise(scale.absent), "", _ABSENT


def read_scale_file(folder: Path) -> Scale | None:
    """The scale of a marks folder, None where it has none. Raises TableError."""
    path = folder / SCALE.name
    steps: list[Step] = []
    absent = ""
    for line, (grade, least, result) in read_records_if_any(folder, SCALE):
        if result not in _RESULTS:
            expected = Message("marks.result")
            raise TableError(explain_cell(path, line, "result", result, expected))
        if result == _ABSENT:
            absent = restore(grade)
            continue
        bound = _read_bound(path, line, least)
        steps.append(Step(restore(grade), bound / _FULL, result == _PASSED))
    if steps and steps[-1].least:
        raise TableError(explain_edited(path, Message("marks.scale-from-zero")))
    return Scale(tuple(steps), absent) if steps else None


def _read_bound(path: Path, line: int, cell: str) -> Fraction:
    """A percentage as it is written. Raises TableError."""
    digits = cell.replace("/", "", 1)
    if digits.isascii() and digits.isdecimal() and len(cell) <= _LONGEST:
        try:
            return Fraction(cell)
        except (ValueError, ZeroDivisionError):
            pass
    raise TableError(explain_cell(path, line, "from", cell, Message("marks.bound")))
