"""The log of changes to marks that were known already: changes.csv of a marks folder.

A marking with a reason adds what it changes; every later one keeps what was there.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from kinegrade.files.csv_writing import neutralise, write_csv_text
from kinegrade.marks_folder.cells import Record
from kinegrade.marks_folder.folder import MarksFolder
from kinegrade.marks_folder.layout import CHANGES
from kinegrade.reports.comparison import compare
from kinegrade.reports.comparison_writing import list_amounts

_MARK = "\ufeff"  # by which spreadsheets recognise UTF-8


@dataclass(frozen=True)
class LoggedChange:
    """What is added to the log: why the marks differ from the `earlier` ones, and on which day,
    `2027-05-04`. `now` gives the ids that students have by now.
    """

    earlier: MarksFolder
    reason: str
    day: str
    now: Mapping[str, str]

    def write(self, marks: MarksFolder) -> str:
        """The log of a marking: that of the earlier one, and what has changed since."""
        return write_log((*self.earlier.log, *self._list_rows(marks)))

    def _list_rows(self, marks: MarksFolder) -> Iterator[Record]:
        """For each student the total, then the answers that are judged differently."""
        for amounts in list_amounts(compare(self.earlier, marks, self.now)):
            student, name, what, before, after, _, *out_of = amounts
            row = self.day, student, name, what, before, after, *out_of, neutralise(self.reason)
            yield row


def write_log(rows: tuple[Record, ...]) -> str:
    """The text of changes.csv."""
    return f"{_MARK}{write_csv_text(CHANGES.columns, rows)}"
