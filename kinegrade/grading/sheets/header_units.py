"""Units in the headers of a file of answers, where people state others than the exam asks for:
"q1.v_B (cm/s)" above numbers in cm/s.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from kinegrade.exam.folder.asks import Ask
from kinegrade.files.assumed_unit import in_unit
from kinegrade.files.tables import Complaint, Table
from kinegrade.grading.sheets.columns import Columns, find_unit
from kinegrade.grading.typed.answers import read
from kinegrade.language.message import Message, Quoted

Choice = Callable[[tuple[str, ...]], tuple[str, ...]]  # the responses among the cells of a row


@dataclass(frozen=True, slots=True)
class StatedUnits:
    """The unit of each ask's numbers, "" where it is that of the exam, and what is to be said of
    headers whose unit cannot be taken.
    """

    units: tuple[str, ...]
    complaints: tuple[Complaint, ...]

    def convert(self, responses: Choice) -> Choice:
        """The same choice, with their unit behind the numbers that are not in that of the exam."""
        if not any(self.units):
            return responses
        return lambda cells: tuple(map(in_unit, responses(cells), self.units))


def find_stated_units(table: Table, columns: Columns, asks: Sequence[Ask]) -> StatedUnits:
    """What the headers of a table state."""
    units, complaints = [""] * len(asks), []
    for number, (place, ask) in enumerate(zip(columns.asks, asks, strict=True)):
        stated = "" if place is None else find_unit(table.header[place])
        if place is None or stated == ask.unit or not any(map(str.isalpha, stated)):
            continue
        one = read(f"1 {stated}", ask.unit)
        if one.kind != "number":
            title = table.header[place]
            what = Message("marking.no-unit-of", stated=Quoted(stated), unit=ask.unit)
            done = Message("marking.numbers-in", unit=ask.unit)
            complaints.append(Complaint(table.file, None, title, "", what, done))
        elif one.value != 1:
            units[number] = stated
    return StatedUnits(tuple(units), tuple(complaints))
