"""Which columns of a roster hold what: as a person says, else by their titles."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import get_args

from kinegrade.errors import TableError
from kinegrade.exam.roster.known_columns import (
    Column,
    System,
    find_system,
    list_column_names,
    list_logins,
    make_column_key,
)
from kinegrade.files.cell_text import drop_invisible, make_header_key, shorten, trim
from kinegrade.files.header_line import HeaderSign
from kinegrade.files.rows.row import Row
from kinegrade.files.tables import Table
from kinegrade.language.message import Fault, Message, Part, Quoted, list_plainly

COLUMNS: tuple[Column, ...] = get_args(Column)
NAMES: tuple[Column, ...] = ("name", "last", "first")
_SHARED: tuple[Column, ...] = ("email",)  # may be the id, too
_REPLACED: tuple[Column, ...] = ("student",)  # by logins and addresses
_MOST_SHOWN = 40  # titles in a message
# By column the title that a person gives it, "" where no column is to be used
Wishes = Mapping[Column, str]


@dataclass(frozen=True, slots=True)
class Columns:
    """Where the columns of a roster stand, and the system that it comes from, where that is
    known.
    """

    places: Mapping[Column, int]
    system: System | None

    def read(self, row: Row, column: Column) -> str:
        """The cell of a row, without blanks around it and several in a place, nor anything that
        cannot be seen, which names may need; "" where there is none.
        """
        if not self.has(column):
            return ""
        cell = row.cell(self.places[column])
        seen = cell if column in NAMES else drop_invisible(cell)
        return " ".join(trim(seen).split())

    def has(self, column: Column) -> bool:
        """Whether the roster has it."""
        return column in self.places


def make_header_sign(wishes: Wishes) -> HeaderSign:
    """What tells the header of a roster from titles above it: it has an id and a name, and what is
    wished for.
    """

    def is_header(cells: Sequence[str]) -> bool:
        try:
            return not _find_missing(_place_by_title(cells, wishes))
        except _NoSuchTitleError:
            return False

    return is_header


def find_columns(table: Table, wishes: Wishes) -> Columns:
    """Where the columns of a roster stand. Raises TableError where one is not there that is needed
    or wished for.

    Of several columns with known titles the best one counts that is not blank throughout.
    """
    try:
        places = _place_by_title(table.header, wishes, table.rows)
    except _NoSuchTitleError as error:
        raise TableError(_explain_wish(table, *error.args)) from error
    if missing := _find_missing(places):
        raise TableError(_explain_missing(table, missing))
    return Columns(_settle_names(places, table, wishes), find_system(table.header))


class _NoSuchTitleError(Exception):
    """There is no column of the title that is wished for."""


def _place_by_title(
    header: Sequence[str], wishes: Wishes, rows: Sequence[Row] = ()
) -> dict[Column, int]:
    """By column where it stands. Raises _NoSuchTitleError with the column and its title."""
    whole, keys = list(map(make_header_key, header)), list(map(make_column_key, header))
    system = find_system(header)
    places: dict[Column, int] = {}
    for column in COLUMNS:
        if column in wishes:
            if title := make_header_key(wishes[column]):
                if title not in whole:
                    raise _NoSuchTitleError(column, wishes[column])
                places[column] = whole.index(title)
            continue
        names = _list_names(column, system)
        found = [place for name in names for place, key in enumerate(keys) if key == name]
        free = [place for place in found if column in _SHARED or place not in places.values()]
        filled = (place for place in free if any(trim(row.cell(place)) for row in rows))
        if free:
            places[column] = next(filled, free[0])
    return places


def _list_names(column: Column, system: System | None) -> Sequence[str]:
    """The titles that a column may have, the best first."""
    if system is not None and column in system.columns:
        return system.columns[column]
    return (*list_column_names(column), *(list_logins() if column in _REPLACED else ()))


def _find_missing(places: Mapping[Column, int]) -> list[Column]:
    """The columns without which no paper can be made."""
    named = any(column in places for column in NAMES)
    return [
        *(["student"] if "student" not in places else list[Column]()),
        *([] if named else list[Column](["name"])),
    ]


def _settle_names(
    places: Mapping[Column, int], table: Table, wishes: Wishes
) -> Mapping[Column, int]:
    """The same, where whole names are taken before their parts; a column "Name" beside one of first
    names holds last names, unless most of its names contain the first ones.
    """
    if "name" not in places or not ({"first", "last"} & set(places)):
        return places
    parts = {"first", "last"} & set(wishes)
    alone = "first" in places and "last" not in places
    rest = {column: place for column, place in places.items() if column not in NAMES}
    if "name" not in wishes and (parts or (alone and not _hold_first(places, table))):
        halves: dict[Column, int] = {each: places[each] for each in NAMES[1:] if each in places}
        return {**rest, "last": places["name"], **halves}
    return {**rest, "name": places["name"]}


def _hold_first(places: Mapping[Column, int], table: Table) -> bool:
    """Whether most names contain the first names beside them."""
    pairs = [(row.cell(places["first"]), row.cell(places["name"])) for row in table.rows]
    return 2 * sum(trim(first) in name for first, name in pairs) > len(pairs)


def _show_titles(table: Table) -> Part:
    """The titles that a file has, as messages name them."""
    titles = [shorten(title) for title in table.header if trim(title)]
    more = ["…"] if len(titles) > _MOST_SHOWN else []
    return list_plainly([*titles[:_MOST_SHOWN], *more])


def _explain_missing(table: Table, missing: Sequence[Column]) -> Fault:
    what = Message("roster.no-column", columns=list_plainly(map(Quoted, missing)))
    options = " ".join(f"--column {column}=HEADER" for column in missing)
    do = Message("roster.name-column", titles=_show_titles(table), options=options)
    return Fault(table.file, what, do=do)


def _explain_wish(table: Table, column: Column, title: str) -> Fault:
    what = Message("roster.no-title", title=Quoted(title), column=column)
    do = Message("roster.titles-here", titles=_show_titles(table))
    return Fault(table.file, what, do=do)


def find_other_ids(table: Table, columns: Columns, wishes: Wishes) -> Iterator[Message]:
    """That other columns are called as ids are called, too, and hold something else: a remark that
    says which was taken.
    """
    if "student" in wishes or columns.system is not None:
        return
    taken, names = columns.places["student"], list_column_names("student")
    others = [
        Quoted(shorten(trim(title)))
        for place, title in enumerate(table.header)
        if make_column_key(title) in names
        and any(trim(row.cell(place)) not in ("", trim(row.cell(taken))) for row in table.rows)
    ]
    if others:
        title = Quoted(shorten(trim(table.header[taken])))
        yield Message("roster.other-ids", taken=title, others=list_plainly(others))


def list_unused(table: Table, columns: Columns) -> Iterator[str]:
    """The titles of the filled columns that are not used."""
    used = set(columns.places.values())
    for place, title in enumerate(table.header):
        if place not in used and (trim(title) or any(trim(row.cell(place)) for row in table.rows)):
            yield shorten(trim(title))
