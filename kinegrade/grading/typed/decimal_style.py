"""What a single comma or point before three digits means in a file: declared, detected, or by the
rule on the papers.

Papers say that 0.5 and 0,5 are read alike and that thousands are not separated, so `1,234` is
1.234, and so is `1.234`. There are three exceptions: the decimal mark is declared; the student's
other answers group digits (`1,234.5`); or every unambiguous answer, of this student or of most
others, has a decimal point, so that a comma groups. A majority of other students never overrules a
student who writes decimal commas. Every such reading is remarked, but for a comma that was declared
to be the decimal mark, or is in the same student's other answers; `marks` says once what was
declared, or decided for the whole file.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import islice
from typing import Literal, assert_never

import numpy as np

from kinegrade.grading.typed.cell_block import CellBlock, ListedCells
from kinegrade.grading.typed.keyboard import fold
from kinegrade.grading.typed.number_text import DecimalStyle, MarkUse, read_mantissa
from kinegrade.language.message import Message, Text

Mark = Literal["comma", "point"]
_LONGEST_EVIDENCE = 200
_BLOCK = 1000  # rows counted together
_NUMBER = re.compile(r"[.,]?[0-9]")
_USUAL = re.compile(
    r"[+-]?(?:(?P<decimal>0\.[0-9]+|[0-9]+\.(?:[0-9]{1,2}|[0-9]{4,}))|[0-9]{1,3}(?:\.[0-9]{3})?|)"
)
_USUAL_LINES = re.compile(
    r"(?:[+-]?(?:0\.[0-9]{1,99}|[0-9]{1,99}\.(?:[0-9]{1,2}|[0-9]{4,99})"
    r"|[0-9]{1,3}(?:\.[0-9]{3})?|)\n)*+"
)
_DECIMAL_LINE = re.compile(r"^[+-]?(?:0\.|[0-9]+\.(?:[0-9]{1,2}|[0-9]{4,})$)", re.MULTILINE)
_PAPERS = DecimalStyle()
_CERTAIN = ""  # a reading that needs no remark


@dataclass(frozen=True, slots=True)
class Evidence:
    """The marks that certainly stand before decimals in some answers, and those that certainly
    group digits.
    """

    decimal: frozenset[str] = frozenset()
    groups: frozenset[str] = frozenset()


_NOTHING, _POINT = Evidence(), Evidence(decimal=frozenset("."))


@dataclass(frozen=True, slots=True)
class FileStyle:
    """The style of a whole file, for rows that are ambiguous themselves; `declared` overrules every
    row.

    `commas` is whether any student writes a decimal comma.
    """

    style: DecimalStyle
    declared: bool = False
    commas: bool = False

    @property
    def reasons(self) -> tuple[Text, ...]:
        """What was declared or decided for the whole file, or holds for many students alike."""
        return tuple(filter(None, (self.style.comma_reason, self.style.point_reason)))

    def of_row(self, cells: Sequence[str]) -> DecimalStyle:
        """The style of one student's answers: as declared, else as they show, else the file's."""
        if self.declared:
            return self.style
        row = gather_evidence(cells)
        if not row.decimal and not row.groups:
            return self.style
        comma, comma_reason = self._comma(row)
        if "." in row.groups and "." not in row.decimal:
            return DecimalStyle(comma, "groups", comma_reason, Message("marking.own-point-groups"))
        doubt = self.style.point_reason
        if not doubt and "," in row.decimal and "." not in row.decimal:
            doubt = Message("marking.against-own-commas")
        return DecimalStyle(comma, self.style.point, comma_reason, doubt)

    def _comma(self, row: Evidence) -> tuple[MarkUse, Text]:
        if "," in row.decimal and "," in row.groups:
            return "unknown", Message("marking.both-ways")
        if "," in row.decimal:
            return "decimal", _CERTAIN
        if "," in row.groups:
            return "groups", Message("marking.own-comma-groups")
        if "." in row.decimal:
            if self.commas:
                return self.style.comma, Message("marking.against-own-points")
            return "groups", Message("marking.own-points")
        return self.style.comma, self.style.comma_reason


def gather_evidence(cells: Sequence[str]) -> Evidence:
    """What the unambiguous numbers show; `1,234` and `1.234` show nothing.

    >>> gather_evidence(["1,234", "0.5"]).decimal
    frozenset({'.'})
    """
    lines = "\n".join([*cells, ""])
    if _USUAL_LINES.fullmatch(lines):  # most rows of most files
        return _POINT if _DECIMAL_LINE.search(lines) else _NOTHING
    decimal, groups = set[str | None](), set[str | None]()
    for cell in cells:
        if len(cell) > _LONGEST_EVIDENCE:
            continue
        usual = _USUAL.fullmatch(cell)  # most cells of most files
        if usual is None:
            before_decimals, between_groups = _find_marks(cell)
            decimal.add(before_decimals)
            groups.add(between_groups)
        elif usual["decimal"]:
            decimal.add(".")
    return Evidence(frozenset(filter(None, decimal)), frozenset(filter(None, groups)))


def _find_marks(cell: str) -> tuple[str | None, str | None]:
    """The decimal and the grouping mark of the first number in a cell, where they are certain."""
    text = fold(cell)
    if "," not in text and "." not in text:
        return None, None
    found = _NUMBER.search(text, text.rfind("=") + 1)
    number = read_mantissa(text, found.start()) if found else None
    return number.marks if number and number.well_formed else (None, None)


def find_file_style(rows: Iterable[Sequence[str]], declared: Mark | None = None) -> FileStyle:
    """The style of a file from all its rows of answers, or as declared by the name of its decimal
    mark.
    """
    if declared is not None:
        return FileStyle(_read_declared_style(declared), declared=True)
    each = iter(rows)
    blocks = iter(lambda: ListedCells([*islice(each, _BLOCK)]), ListedCells([]))
    return find_common_style(blocks)


def find_common_style(blocks: Iterable[CellBlock]) -> FileStyle:
    """The style of a file from its rows of answers in blocks."""
    counted = np.zeros(3, dtype=np.intp)
    for block in blocks:
        counted += _count_plain(block) or _count_any(block.rows)
    commas, points, count = counted.tolist()
    comma, reason = _judge_comma(commas, points, count)
    doubt = Message("marking.point-by-rule") if commas and not points else ""
    return FileStyle(DecimalStyle(comma, "decimal", reason, doubt), commas=commas > 0)


def _count_any(rows: Sequence[Sequence[str]]) -> tuple[int, int, int]:
    """How many rows show a decimal comma, how many a decimal point, and how many are not blank."""
    found = [gather_evidence(row) for row in rows if any(row)]
    commas, points = (sum(mark in each.decimal for each in found) for mark in ",.")
    return commas, points, len(found)


def _count_plain(block: CellBlock) -> tuple[int, int, int] | None:
    """The same of rows of plain numbers, which most are, several times faster; None for others."""
    plain, width = block.plain, block.width
    decimals = None if plain is None or not width else plain.find_decimals()
    if plain is None or decimals is None:
        return None
    show, filled = (
        int(cells.reshape(-1, width).any(axis=1).sum())
        for cells in (decimals, ~np.isnan(plain.values))
    )
    return 0, show, filled


def _read_declared_style(mark: Mark) -> DecimalStyle:
    match mark:
        case "comma":
            declared = Message("marking.declared-comma")
            return DecimalStyle("decimal", "groups", _CERTAIN, declared)
        case "point":
            return DecimalStyle("groups", "decimal", Message("marking.declared-point"))
        case _:
            assert_never(mark)


def _judge_comma(commas: int, points: int, rows: int) -> tuple[MarkUse, Text]:
    """What a comma means where a row does not show it: it groups if most rows show a decimal point
    and none shows a decimal comma.
    """
    if not commas and 2 * points > rows:
        return "groups", Message("marking.points-only", count=points)
    if not commas and not points:
        return "decimal", _PAPERS.comma_reason
    with_commas = Message("marking.students", count=commas)
    with_points = Message("marking.students", count=points)
    return "decimal", Message("marking.commas-too", commas=with_commas, points=with_points)
