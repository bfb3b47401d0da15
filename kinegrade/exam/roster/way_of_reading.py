"""How a roster was read, in words: which column is what, what is not used, what was repaired."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from kinegrade.exam.roster.columns import COLUMNS, Columns
from kinegrade.files.cell_text import make_header_key, shorten, trim
from kinegrade.files.rows.row import Row
from kinegrade.files.tables import Table
from kinegrade.language.message import Message, Part, Quoted, list_all, list_plainly

_MOST_NAMED = 12  # columns that are not used


@dataclass(frozen=True, slots=True)
class WayOfReading:
    """How a table was read as a class: the columns, the titles that are not `unused`, the lines of
    `others` than students, and remarks on ids.
    """

    table: Table
    columns: Columns
    unused: Sequence[str]
    others: Sequence[Row]
    remarks: Sequence[Message]

    @property
    def plain(self) -> bool:
        """Whether everything was called by its own name and used, so that nothing need be said."""
        titles = self.table.header
        named = all(
            make_header_key(titles[place]) == column
            for column, place in self.columns.places.items()
        )
        return named and not (self.unused or self.others or self.remarks or self.table.above)

    def notes(self) -> Iterator[Message]:
        """A line for each thing to be said."""
        found = self._list_columns()
        yield self._say(Message("roster.read-from", columns=list_plainly(found)))
        if self.unused:
            shown = [*map(Quoted, self.unused[:_MOST_NAMED])]
            more = ["…"] if len(self.unused) > _MOST_NAMED else []
            titles = list_plainly([*shown, *more])
            yield self._say(Message("roster.unused", count=len(self.unused), titles=titles))
        if self.table.above:
            lines = list_all(self.table.above)
            count = len(self.table.above)
            yield self._say(Message("roster.above", count=count, lines=lines))
        if self.others:
            lines = list_all(self._show_line(row) for row in self.others)
            yield self._say(Message("roster.not-students", count=len(self.others), lines=lines))
        yield from map(self._say, self.remarks)

    def _list_columns(self) -> Iterator[Message]:
        """What was read from which column."""
        titles, places = self.table.header, self.columns.places
        parts = [Quoted(trim(titles[places[each]])) for each in ("first", "last") if each in places]
        named = {column: Quoted(trim(titles[place])) for column, place in places.items()}
        for column in COLUMNS:
            if column == "name" and "name" not in named and parts:
                yield Message("roster.column-from", column="name", titles=list_all(parts))
            elif column in named and column not in ("first", "last"):
                yield Message("roster.column-from", column=column, titles=named[column])

    def _show_line(self, row: Row) -> Part:
        text = next((trim(cell) for cell in row.cells if trim(cell)), "")
        return Message("roster.line-with", line=row.line, text=Quoted(shorten(text)))

    def _say(self, what: Message) -> Message:
        return Message("terminal.of", where=self.table.file, what=what)
