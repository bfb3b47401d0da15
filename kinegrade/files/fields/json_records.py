"""The records of one long list in a JSON text, read in a fraction of the time and the memory that
the tables of other content take.

A list is read so where, but for blanks, it stands byte for byte as it would be written from these
records: then no record has a key that is not known, or one twice. Any other list is left to those
who name faults.
"""

from __future__ import annotations

from typing import Any, Generic, NamedTuple, TypeVar

import msgspec

_Record = TypeVar("_Record", bound=msgspec.Struct)
_EMPTY = b"[]"
_NO_BLANKS = -1  # of `msgspec.json.format`


class TextRecords(NamedTuple, Generic[_Record]):
    """The records of a list, and the text with an empty one in its place."""

    rest: str
    records: tuple[_Record, ...]


def read_records(text: str, key: str, kind: type[_Record]) -> TextRecords[_Record] | None:
    r"""The records of the list that stands under a key of the whole; None where there is none, or
    anything in it is written otherwise.

    >>> class Student(msgspec.Struct):
    ...     name: str
    >>> read_records('{\n "students": [\n  {\n   "name": "Ann"\n  }\n ]\n}', "students", Student)
    TextRecords(rest='{\n "students": []\n}', records=(Student(name='Ann'),))
    """
    whole = msgspec.defstruct("Whole", [("listed", msgspec.Raw, msgspec.field(name=key))])
    try:
        content = text.encode("utf-8")
        found: Any = msgspec.json.decode(content, type=whole)
        listed = bytes(found.listed)
        records = msgspec.json.decode(listed, type=tuple[kind, ...])  # type: ignore[valid-type]
    except (msgspec.MsgspecError, UnicodeEncodeError, RecursionError):
        return None
    as_written = msgspec.json.format(listed, indent=_NO_BLANKS) == msgspec.json.encode(records)
    begin = content.find(listed)
    if not records or not as_written or content.find(listed, begin + 1) >= 0:
        return None
    rest = content[:begin] + _EMPTY + content[begin + len(listed) :]
    return TextRecords(rest.decode("utf-8"), records)
