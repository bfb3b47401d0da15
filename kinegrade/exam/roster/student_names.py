"""Names as files of answers hold them beside ids: whether the name is that of somebody else.

A table that was sorted by one column alone has each name beside another id; only the names tell it.
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from unicodedata import combining, normalize

from kinegrade.exam.roster.known_columns import Column, list_column_names
from kinegrade.files.cell_text import make_header_key, trim
from kinegrade.files.rows.row import Row

_PARTS: tuple[Column, ...] = ("name", "first", "last")
_BETWEEN_WORDS = re.compile(r"[\s,.;]+")


@dataclass(frozen=True)
class StudentNames:
    """The names of a class, by id; "" where the roster gave none.

    >>> names = StudentNames({"1": "Ada Byron", "2": "Émilie du Châtelet"})
    >>> names.find_other("1", "du Chatelet, Emilie"), names.find_other("1", "BYRON, Ada")
    ('2', None)
    """

    by_student: Mapping[str, str]

    def find_other(self, student: str, written: str) -> str | None:
        """The one other student who has this name; None where the student has it, or nobody, or
        several.
        """
        own = self.by_student.get(student, "")
        if not own or written == own:
            return None
        folded = _fold(written)
        if folded == _fold(own):
            return None
        owners = self._owners.get(folded, ())
        return owners[0] if len(owners) == 1 else None

    @cached_property
    def _owners(self) -> Mapping[tuple[str, ...], Sequence[str]]:
        """The students by their names as they are compared; in most files every name is exact."""
        owners: dict[tuple[str, ...], list[str]] = defaultdict(list)
        for student, name in self.by_student.items():
            if words := _fold(name):
                owners[words].append(student)
        return owners


def are_unlike(first: str, second: str) -> bool:
    """Whether two names are those of two people, as far as both are known.

    >>> are_unlike("Ada Byron", "BYRON, Ada"), are_unlike("Ada Byron", "Ute Byron")
    (False, True)
    """
    one, other = _fold(first), _fold(second)
    return bool(one and other and one != other)


@dataclass(frozen=True, slots=True)
class NameColumns:
    """The places of the columns that together hold a name; none where a file has no names."""

    places: tuple[int, ...]

    def written(self, row: Row) -> str:
        """The name in a row, "" where there is none."""
        return " ".join(filter(None, (trim(row.cell(place)) for place in self.places)))


def find_name_columns(header: Sequence[str]) -> NameColumns:
    """The columns of names of a table.

    >>> find_name_columns(["Student", "First name", "Last name", "q1.v"]).places
    (1, 2)
    """
    keys = [make_header_key(cell) for cell in header]
    found = (_find(keys, part) for part in _PARTS)
    return NameColumns(tuple(place for place in found if place is not None))


def _find(keys: Sequence[str], part: Column) -> int | None:
    return next((keys.index(name) for name in list_column_names(part) if name in keys), None)


def _fold(name: str) -> tuple[str, ...]:
    """A name as it is compared: its words in any order, without case and accents."""
    plain = "".join(each for each in normalize("NFKD", name.casefold()) if not combining(each))
    return tuple(sorted(filter(None, _BETWEEN_WORDS.split(plain))))
