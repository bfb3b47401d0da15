"""A table of a TOML or JSON file, read key by key into typed values.

A faulty value is noted with its place and read as None, as empty or as the default. Reading goes
on, and `faults.require_none()` reports all faults of a file together.

    bank = open_toml(path, BANK).only("title", "versions", "questions")
    title = bank.required("title", text)
    versions = bank.with_default("versions", whole(1, 26), 0)
    for question in bank.tables("questions"): ...
    bank.faults.require_none()
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from typing import TypeVar

from msgspec import Struct

from kinegrade.errors import FieldError, KinegradeError, find_misspelt, suggest
from kinegrade.files.fields.faults import Faults
from kinegrade.files.fields.place import Place
from kinegrade.files.fields.values import Read, found
from kinegrade.language.message import Message, Part, Text

_Value = TypeVar("_Value")
_NOTHING: Mapping[str, object] = {}
_UNKNOWN = Message("fields.unknown-key")


class Table(Struct, frozen=True):
    """A table at a place in a file.

    Missing keys that are `excused` are not reported: they are misspelt, and that is reported
    already. A table that is not `whole` stands in for a faulty one; no keys are missing from it.
    """

    faults: Faults
    place: Place
    content: Mapping[str, object]
    excused: frozenset[str] = frozenset()
    whole: bool = True

    def __contains__(self, key: str) -> bool:
        return key in self.content

    def __iter__(self) -> Iterator[str]:
        return iter(self.content)

    def __len__(self) -> int:
        return len(self.content)

    def only(
        self, *known: str, unknown: Text = _UNKNOWN, hint: Callable[[str], Text] | None = None
    ) -> Table:
        """The table with only its known keys; each of the others is noted as a fault, which
        `unknown` says and `hint` helps with: by the nearest known ones where there is none.
        """
        others = [key for key in self.content if key not in known]
        for key in others:
            self.fault(key, unknown, do=hint(key) if hint else suggest(key, known))
        return Table(
            self.faults,
            self.place,
            {key: value for key, value in self.content.items() if key in known},
            find_misspelt(others, [key for key in known if key not in self.content]),
            self.whole,
        )

    def required(self, key: str, read: Read[_Value]) -> _Value | None:
        """The value of a key, as `read` gives it; None after a fault. A missing key is a fault."""
        if key in self.content:
            return self._read(key, self.content[key], read)
        self.missing(key, _expected(read))
        return None

    def optional(self, key: str, read: Read[_Value]) -> _Value | None:
        """The value of a key, as `read` gives it; None where there is none, and after a fault."""
        return self._read(key, self.content[key], read) if key in self.content else None

    def with_default(self, key: str, read: Read[_Value], default: _Value) -> _Value:
        """Like `optional`, with a default in place of None."""
        value = self.optional(key, read)
        return default if value is None else value

    def entries(self, read: Read[_Value]) -> dict[str, _Value]:
        """Every value of the table, as `read` gives it; faulty ones are left out."""
        values = {key: self._read(key, value, read) for key, value in self.content.items()}
        return {key: value for key, value in values.items() if value is not None}

    def listing(self, key: str, read: Read[_Value], like: str = "") -> tuple[_Value, ...]:
        """Every entry of a list, as `read` gives it; faulty ones are left out.

        A missing list is empty. `like` is an example for messages.
        """
        return tuple(self.numbered(key, read, like).values())

    def numbered(self, key: str, read: Read[_Value], like: str = "") -> dict[int, _Value]:
        """Like `listing`, with the position of each entry in the list, counted from 0."""
        expected = Message("fields.a-list-like", like=like) if like else Message("fields.a-list")
        values = {
            number: self._read_at((*self.place, key, number), entry, read)
            for number, entry in enumerate(self._list(key, expected))
        }
        return {number: value for number, value in values.items() if value is not None}

    def table(self, key: str, like: Part = "") -> Table:
        """The table under a key, empty where there is none; `like` is an example for messages."""
        return self._table_at((*self.place, key), self.content.get(key, _NOTHING), like)

    def tables(self, key: str, like: str = "") -> tuple[Table, ...]:
        """The tables of a list, none where there is no list; `like` is an example for messages."""
        if like:
            expected = Message("fields.a-list-of-tables", like=like)
        else:
            expected = Message("fields.tables", key=key)
        return tuple(
            self._table_at((*self.place, key, number), entry, like)
            for number, entry in enumerate(self._list(key, expected))
        )

    def each_table(self, like: str = "") -> dict[str, Table]:
        """The tables under this one's keys, which may have any names."""
        return {key: self.table(key, like) for key in self.content}

    def value(self, key: str) -> object:
        """The value of a key as parsed; None where there is none."""
        return self.content.get(key)

    def is_sound(self, key: str) -> bool:
        """Whether no fault has been noted at a key or anywhere inside its value."""
        return not self.faults.within((*self.place, key))

    def holds_table(self, key: str) -> bool:
        """Whether the value of a key is a table."""
        return isinstance(self.content.get(key), dict)

    def missing(self, key: str, expected: Text = "") -> None:
        """Notes once that a key is missing, unless missing keys are not reported here."""
        noted = self.faults.within((*self.place, key))
        if self.whole and key not in self.excused and not noted:
            self.fault(key, Message("fields.missing"), expected)

    def fault(self, key: str | None, what: Text, expected: Text = "", do: Text = "") -> None:
        """Notes a fault in the value of a key, or in the table itself (None)."""
        place = self.place if key is None else (*self.place, key)
        self.faults.note(place, what, expected, do)

    def require(self, keys: Collection[str]) -> bool:
        """Whether all these keys are present; each missing one is noted."""
        missing = [key for key in keys if key not in self.content]
        for key in missing:
            self.missing(key)
        return not missing

    def _list(self, key: str, expected: Text) -> list[object]:
        value = self.content.get(key, [])
        if isinstance(value, list):
            return value
        self.fault(key, found(value), expected)
        return []

    def _table_at(self, place: Place, value: object, like: Part) -> Table:
        if isinstance(value, Mapping):
            return Table(self.faults, place, value)
        expected = Message("fields.a-table-like", like=like) if like else Message("fields.a-table")
        self.faults.note(place, found(value), expected)
        return Table(self.faults, place, _NOTHING, whole=False)

    def _read(self, key: str, value: object, read: Read[_Value]) -> _Value | None:
        return self._read_at((*self.place, key), value, read)

    def _read_at(self, place: Place, value: object, read: Read[_Value]) -> _Value | None:
        try:
            return read(value)
        except KinegradeError as error:
            self.faults.note_error(place, error)
        return None


def _expected(read: Read[_Value]) -> Text:
    """What a reader expects, found from its refusal of None; "" where it does not say."""
    try:
        read(None)
    except FieldError as error:
        return error.expected
    except KinegradeError:
        return ""
    return ""
