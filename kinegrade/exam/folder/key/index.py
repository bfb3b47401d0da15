"""Where the line of each student stands: found once, so that single lines can be read when they are
needed.

However large the class, it takes one number per student and the memory of one paper.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

import msgspec

from kinegrade.exam.folder.faults import (
    describe_damage,
    explain_broken,
    explain_unreadable,
    name_line,
)
from kinegrade.exam.folder.ownership import find_repetitions
from kinegrade.language.message import Fault

_BEGINNING = re.compile(rb'\{"student": ?("(?:[^"\\]|\\.)*")')


class _Owner(msgspec.Struct, gc=False):
    student: str


_decoded = msgspec.json.Decoder(_Owner).decode
_decoded_text = msgspec.json.Decoder(str).decode


@dataclass(frozen=True, slots=True)
class KeyIndex:
    """The lines of a file with a key on each line; `beginnings` are the offsets of their first
    bytes, by student.
    """

    path: Path
    beginnings: Mapping[str, int]

    def text(self, student: str) -> bytes:
        """The line of a student. Raises KeyError, ExamError."""
        begin = self.beginnings[student]
        try:
            with self.path.open("rb") as stream:
                stream.seek(begin)
                return stream.readline()
        except OSError as fault:
            raise explain_unreadable(self.path, fault) from fault


def make_index(path: Path) -> KeyIndex:
    """The index of a file. Raises ExamError, also where a student has several lines."""
    try:
        lines = [*_find_owners(path)]
    except OSError as fault:
        raise explain_unreadable(path, fault) from fault
    faults = [*find_repetitions([student for student, _ in lines])]
    if faults:
        raise explain_broken(path, faults)
    return KeyIndex(path, dict(lines))


def _find_owners(path: Path) -> Iterator[tuple[str, int]]:
    """The student of each line that is not empty, and where the line begins; of a
    line as `generate` writes it only the beginning is decoded.
    """
    begin = 0
    with path.open("rb") as stream:
        for number, line in enumerate(stream, 1):
            if not line.isspace():
                try:
                    yield _read_owner(line), begin
                except (ValueError, RecursionError) as fault:
                    damage = Fault(name_line(number), describe_damage(fault))
                    raise explain_broken(path, [damage]) from fault
            begin += len(line)


def _read_owner(line: bytes) -> str:
    """The student of a line. Raises ValueError, RecursionError."""
    beginning = _BEGINNING.match(line)
    return _decoded_text(beginning[1]) if beginning else _decoded(line).student
