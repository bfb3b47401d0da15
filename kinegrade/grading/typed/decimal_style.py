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
from functools import lru_cache
from itertools import islice
from typing import Literal, assert_never

import numpy as np

from kinegrade.grading.typed.cell_block import CellBlock, ListedCells
from kinegrade.grading.typed.keyboard import fold
from kinegrade.grading.typed.number_text import DecimalStyle, MarkUse, read_mantissa
from kinegrade.grading.typed.parted_cells import PartedCells
from kinegrade.language.message import Message, Text

Mark = Literal["comma", "point"]
_LONGEST_EVIDENCE = 200
_BLOCK = 1000  # rows counted together
_NUMBER = re.compile(r"[.,]?[0-9]")
_USUAL = re.compile(
    r"[+-]?(?:(?P<decimal>0\.[0-9]+|[0-9]+\.(?:[0-9]{1,2}|[0-9]{4,}))|[0-9]{1,3}(?:\.[0-9]{3})?|)"
)
_PAPERS = DecimalStyle()
_ALIKE = str.maketrans(dict.fromkeys("3456789", "2"))
_CERTAIN = ""  # a reading that needs no remark


@dataclass(frozen=True, slots=True)
class Evidence:
    """The marks that certainly stand before decimals in some answers, and those that certainly
    group digits.
    """

    decimal: frozenset[str] = frozenset()
    groups: frozenset[str] = frozenset()


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
        return self.style if self.declared else self.of_evidence(gather_evidence(cells))

    def of_evidence(self, row: Evidence) -> DecimalStyle:
        """The same by what the answers of one student show."""
        if self.declared:
            return self.style
        if not row.decimal and not row.groups:
            return self.style
        comma, comma_reason = self._comma(row)
        if "." in row.groups and "." not in row.decimal:
            return DecimalStyle(comma, "groups", comma_reason, Message("marking.own-point-groups"))
        doubt = "" if "." in row.decimal else self.style.point_reason
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


def show_evidence(cell: str) -> Evidence:
    """What one cell shows; whether a digit is 2 or 9 makes no difference."""
    return _show_evidence(cell.translate(_ALIKE))


def join_evidence(cells: Iterable[Evidence], *, point: bool) -> Evidence:
    """What cells show together, and whether plain numbers beside them show a decimal point."""
    decimal, groups = set[str]("." if point else ()), set[str]()
    for each in cells:
        decimal |= each.decimal
        groups |= each.groups
    return Evidence(frozenset(decimal), frozenset(groups))


@lru_cache(maxsize=4096)
def _show_evidence(cell: str) -> Evidence:
    return _share(gather_evidence([cell]))


@lru_cache(maxsize=64)
def _share(shown: Evidence) -> Evidence:
    """The same object for all cells that show the same."""
    return shown


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
    counted = np.zeros(5, dtype=np.intp)
    for block in blocks:
        parted = block.parted
        if parted is None:
            counted += _count_any(block.rows)
        else:
            counted += _count_parted(parted, block.width)
    commas, points, grouping, pointed, count = counted.tolist()
    comma, reason = _judge_comma(commas, points, count)
    if grouping and not commas and not points:
        reason = Message("marking.comma-against-groups", count=grouping)
    doubt: Text = Message("marking.point-by-rule") if commas and not points else ""
    if pointed > points:
        doubt = Message("marking.point-against-groups", count=pointed)
    return FileStyle(DecimalStyle(comma, "decimal", reason, doubt), commas=commas > 0)


def _count_any(rows: Sequence[Sequence[str]]) -> tuple[int, int, int, int, int]:
    """How many rows show a decimal comma, how many a decimal point, how many a comma that groups,
    how many such a point, and how many are not blank.
    """
    found = [gather_evidence(row) for row in rows if any(row)]
    commas, points = (sum(mark in each.decimal for each in found) for mark in ",.")
    grouping, pointed = (sum(mark in each.groups for each in found) for mark in ",.")
    return commas, points, grouping, pointed, len(found)


def _count_parted(cells: PartedCells, width: int) -> tuple[int, int, int, int, int]:
    """The same of the cells of rows so wide, several times faster."""
    plain = cells.plain
    filled, points = (
        np.logical_or.reduce(found.reshape(-1, width), axis=1).tolist()
        for found in (~np.isnan(plain.values), plain.find_decimals())
    )
    commas, grouping, pointed = ([False] * len(points) for _ in range(3))
    for place, text in cells.others.items():
        row, shown = place // width, show_evidence(text)
        filled[row] = True
        points[row] |= "." in shown.decimal
        commas[row] |= "," in shown.decimal
        grouping[row] |= "," in shown.groups
        pointed[row] |= "." in shown.groups
    return sum(commas), sum(points), sum(grouping), sum(pointed), sum(filled)


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
