"""The columns of a downloaded file that may hold grades, with the maximum that it states."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from kinegrade.files.cell_text import trim
from kinegrade.lms.grades.cells import CellTable, Record
from kinegrade.lms.grades.dialect import Download
from kinegrade.lms.grades.implied_maximum import implied_maximum
from kinegrade.lms.grades.item_groups import ItemGroup


@dataclass(frozen=True, slots=True)
class ItemColumn:
    """A column to be filled in: its place, header and title, and its maximum where stated."""

    place: int
    header: str
    title: str
    maximum: Fraction | None


def list_candidates(table: CellTable, download: Download) -> Sequence[ItemColumn]:
    """The columns that may hold grades, judged by their headers."""
    row = _find_maximum_row(table, download)
    found = []
    for place, header in enumerate(table.titles):
        shape = download.item.fullmatch(header)
        stated = trim(row.cells[place].text) if row else ""
        if (
            place < download.first_item
            or shape is None
            or (download.not_item and download.not_item.search(header))
            or (download.read_only and download.read_only.search(stated))
        ):
            continue
        maximum = shape.groupdict().get("maximum") or stated or _same_everywhere(table, download)
        found.append(ItemColumn(place, header, shape["title"], number(maximum)))
    return found


def select_points(table: CellTable, groups: Sequence[ItemGroup]) -> Sequence[ItemColumn]:
    """The columns that hold points, judged by their cells."""
    return [
        ItemColumn(
            column.place, table.titles[column.place], group.title, _find_implied(table, group)
        )
        for group in groups
        for column in group.of_kind("points")
    ]


def _find_implied(table: CellTable, group: ItemGroup) -> Fraction | None:
    """The maximum that follows from grades in points and, in another column, in per cent."""
    points, shares = group.of_kind("points"), group.of_kind("percentage")
    if len(points) != 1 or len(shares) != 1:
        return None
    pairs = (
        (
            number(trim(row.cells[points[0].place].text)),
            number(trim(row.cells[shares[0].place].text.replace("%", ""))),
        )
        for row in table.rows
    )
    return implied_maximum(
        (amount, share) for amount, share in pairs if amount is not None and share is not None
    )


def _find_maximum_row(table: CellTable, download: Download) -> Record | None:
    shape = download.maximum_row
    return next((row for row in table.rows if shape and shape.match(row.cells[0].text)), None)


def _same_everywhere(table: CellTable, download: Download) -> str:
    """The maximum where every row states the same."""
    if download.maximum_column not in table.titles:
        return ""
    place = table.titles.index(download.maximum_column)
    stated = {trim(row.cells[place].text) for row in table.rows} - {"", "-"}
    return stated.pop() if len(stated) == 1 else ""


def number(text: str) -> Fraction | None:
    """A maximum as systems write it, with a point or a comma; None for anything else.

    >>> number("10,5"), number("(read only)")
    (Fraction(21, 2), None)
    """
    digits = text.replace(",", ".", 1)
    return (
        Fraction(digits)
        if digits.replace(".", "", 1).isascii() and digits.replace(".", "", 1).isdigit()
        else None
    )
