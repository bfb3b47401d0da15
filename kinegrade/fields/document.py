"""Opening a TOML or JSON file as a table."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property
from os import fstat
from pathlib import Path

from kinegrade.errors import KinegradeError, SyntaxFault, write_message
from kinegrade.fields.faults import Faults
from kinegrade.fields.json_text import read_json
from kinegrade.fields.lines import lines_of_json, lines_of_toml
from kinegrade.fields.place import Place, Where
from kinegrade.fields.table import Table
from kinegrade.fields.toml_text import read_toml
from kinegrade.fields.values import found

_Lines = Callable[[str], Mapping[Place, int]]


@dataclass(frozen=True)
class FileKind:
    """How messages name a kind of file ("a bank file"), the error raised for its faults, the most
    bytes read, and the remedy for a fault that names none.
    """

    noun: str
    error: type[KinegradeError]
    most_bytes: int
    do: str = ""


@dataclass(frozen=True)
class Document:
    """The text of a file, with the line of each place in it; lines are worked out only once a fault
    needs one.
    """

    name: str
    text: str
    find_lines: _Lines

    def where(self, place: Place) -> Where:
        """The line of a place; for something missing, that of the nearest enclosing table."""
        around = (place[:length] for length in range(len(place), -1, -1))
        lines = (self._lines[outer] for outer in around if outer in self._lines)
        return Where(self.name, place, next(lines, None))

    @cached_property
    def _lines(self) -> Mapping[Place, int]:
        return self.find_lines(self.text)


def read_text(path: Path, kind: FileKind) -> str:
    """The text of a file, without a byte order mark. Raises the kind's error where it cannot be
    read, is too large or is not UTF-8.
    """
    try:
        with path.open("rb") as file:
            # As much room as the file takes, where it is a file that says so
            size = fstat(file.fileno()).st_size or kind.most_bytes
            data = file.read(min(size, kind.most_bytes) + 1)
        if len(data) <= kind.most_bytes:
            return data.decode("utf-8-sig")
    except OSError as error:
        reason = f"cannot be read ({error.strerror})"
        problem = write_message(str(path), reason, kind.noun, "check the name")
        raise kind.error(problem) from error
    except UnicodeDecodeError as error:
        problem = write_message(
            str(path),
            f"not UTF-8 at byte {error.start}",
            f"{kind.noun} in UTF-8",
            kind.do or "fix it",
        )
        raise kind.error(problem) from error
    expected = f"{kind.noun} of at most {kind.most_bytes} bytes"
    raise kind.error(write_message(str(path), "too large", expected, "check the name"))


def toml_table(name: str, text: str, kind: FileKind) -> Table:
    """A whole TOML text as a table; messages call it `name`. Raises the kind's error where it is
    not TOML.
    """
    try:
        content = read_toml(text)
    except SyntaxFault as fault:
        raise _explain_not_readable(name, "TOML", fault, kind) from fault
    return Table(Faults(Document(name, text, lines_of_toml), kind.error, kind.do), (), content)


def json_table(name: str, text: str, kind: FileKind) -> Table:
    """A JSON text as a table. Raises the kind's error where it is not a JSON object."""
    try:
        content = read_json(text)
    except SyntaxFault as fault:
        raise _explain_not_readable(name, "JSON", fault, kind) from fault
    if not isinstance(content, dict):
        raise kind.error(
            write_message(name, found(content), "one JSON object", kind.do or "fix it")
        )
    return Table(Faults(Document(name, text, lines_of_json), kind.error, kind.do), (), content)


def parsed_table(name: str, content: Mapping[str, object], kind: FileKind) -> Table:
    """A table from content that is already parsed; the lines of its places are unknown."""
    return Table(Faults(Document(name, "", _no_lines), kind.error, kind.do), (), content)


def _no_lines(text: str) -> Mapping[Place, int]:
    return {}


def _explain_not_readable(
    name: str, language: str, fault: SyntaxFault, kind: FileKind
) -> KinegradeError:
    where = str(Where(name, (), fault.line))
    return kind.error(
        write_message(where, str(fault), f"{kind.noun} in {language}", kind.do or "fix it")
    )
