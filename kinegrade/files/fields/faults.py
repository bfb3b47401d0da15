"""The faults of a file, collected while it is read and reported together in the file's order."""

from __future__ import annotations

from msgspec import Struct

from kinegrade.errors import FieldError, KinegradeError, Problem
from kinegrade.files.fields.place import Place, Source, Where
from kinegrade.language.message import Fault, Text


class _Fault(Struct, frozen=True):
    where: Where
    what: Problem
    expected: Text
    do: Text

    def said(self) -> Fault:
        """The fault as messages state it."""
        return Fault(str(self.where), self.what, self.expected, self.do)


class Faults:
    """Collects the faults found while reading `source`; `error` is the type they are raised as.

    `do` is the remedy for a fault that names none.
    """

    def __init__(self, source: Source, error: type[KinegradeError], do: Text = "") -> None:
        self._source, self._error, self._do = source, error, do
        self._noted: list[tuple[Place, Problem, Text, Text]] = []

    def note(self, place: Place, what: Problem, expected: Text = "", do: Text = "") -> None:
        """Notes a fault at a place: what stands there, what was expected, what to do."""
        self._noted.append((place, what, expected, do or self._do))

    def note_error(self, place: Place, error: KinegradeError) -> None:
        """Notes every problem of an error raised for what stands at a place."""
        if isinstance(error, FieldError):
            self.note(place, error.what, error.expected, error.do)
            return
        for problem in error.faults:
            self.note(place, problem)

    def within(self, place: Place) -> bool:
        """Whether a fault is noted at a place or inside it."""
        return any(noted[: len(place)] == place for noted, *_ in self._noted)

    def require_none(self) -> None:
        """Raises the error with all faults noted so far, if there are any."""
        if self.within(()):
            raise self.raised()

    def raised(self) -> KinegradeError:
        """The error with all faults noted so far."""
        return self._error(*(fault.said() for fault in self._in_order()))

    def inside(self, place: Place) -> Faults:
        """Collects the faults of what stands at a place as if it were a file of its own."""
        return _FaultsInside(self, place)

    def _in_order(self) -> list[_Fault]:
        """By file, in the order in which the files first occur, then by line; faults without a line
        come first.
        """
        faults = [
            _Fault(self._source.where(place), what, expected, do)
            for place, what, expected, do in self._noted
        ]
        files = list(dict.fromkeys(fault.where.file for fault in faults))
        return sorted(
            faults, key=lambda fault: (files.index(fault.where.file), fault.where.line or 0)
        )


class _FaultsInside(Faults):
    """Faults of a table that is read like a file, noted in those of the file that holds it."""

    def __init__(self, outer: Faults, place: Place) -> None:
        self._outer, self._place = outer, place

    def note(self, place: Place, what: Problem, expected: Text = "", do: Text = "") -> None:
        """Notes a fault at a place of the table."""
        self._outer.note((*self._place, *place), what, expected, do)

    def within(self, place: Place) -> bool:
        """Whether a fault is noted at a place of the table or inside it."""
        return self._outer.within((*self._place, *place))

    def raised(self) -> KinegradeError:
        """The error with all faults noted so far, those of the whole file."""
        return self._outer.raised()
