"""Opening a TOML or JSON file as a table."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cached_property
from os import fstat
from pathlib import Path

from msgspec import Struct

from kinegrade.errors import KinegradeError, SyntaxFault
from kinegrade.files.fields.faults import Faults
from kinegrade.files.fields.json_text import read_json
from kinegrade.files.fields.lines import lines_of_json, lines_of_toml
from kinegrade.files.fields.place import Place, Where
from kinegrade.files.fields.table import Table
from kinegrade.files.fields.toml_text import read_toml
from kinegrade.files.fields.values import found
from kinegrade.files.opening.regular import explain_unopened, open_regular
from kinegrade.language.message import Fault, Message, Text

_Lines = Callable[[str], Mapping[Place, int]]
_FIX_IT = Message("fields.fix-it")


class FileKind(Struct, frozen=True):
    """How messages name a kind of file ("a bank file"), the error raised for its faults, the most
    bytes read, and the remedy for a fault that names none.
    """

    noun: Text
    error: type[KinegradeError]
    most_bytes: int
    do: Text = ""


class Document(Struct, frozen=True, dict=True):
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
        with open_regular(path) as file:
            # As much room as the file takes, where it is a file that says so
            size = fstat(file.fileno()).st_size or kind.most_bytes
            data = file.read(min(size, kind.most_bytes) + 1)
        if len(data) <= kind.most_bytes:
            return data.decode("utf-8-sig")
    except OSError as error:
        raise kind.error(explain_unopened(path, error, kind.noun)) from error
    except UnicodeDecodeError as error:
        reason = Message("fields.not-utf-8", byte=error.start)
        expected = Message("fields.file-in-utf-8", file=kind.noun)
        raise kind.error(Fault(str(path), reason, expected, kind.do or _FIX_IT)) from error
    expected = Message("fields.file-of-at-most", file=kind.noun, most=kind.most_bytes)
    too_large, do = Message("fields.too-large"), Message("files.check-the-name")
    raise kind.error(Fault(str(path), too_large, expected, do))


def toml_table(name: str, text: str, kind: FileKind) -> Table:
    """A whole TOML text as a table; messages call it `name`. Raises the kind's error where it is
    not TOML.
    """
    try:
        content = read_toml(text)
    except SyntaxFault as fault:
        raise _explain_not_readable(
            name, Message("fields.file-in-toml", file=kind.noun), fault, kind
        ) from fault
    return Table(Faults(Document(name, text, lines_of_toml), kind.error, kind.do), (), content)


def json_table(name: str, text: str, kind: FileKind) -> Table:
    """A JSON text as a table. Raises the kind's error where it is not a JSON object."""
    try:
        content = read_json(text)
    except SyntaxFault as fault:
        raise _explain_not_readable(
            name, Message("fields.file-in-json", file=kind.noun), fault, kind
        ) from fault
    if not isinstance(content, dict):
        raise kind.error(
            Fault(name, found(content), Message("fields.one-object"), kind.do or _FIX_IT)
        )
    return Table(Faults(Document(name, text, lines_of_json), kind.error, kind.do), (), content)


def parsed_table(name: str, content: Mapping[str, object], kind: FileKind) -> Table:
    """A table from content that is already parsed; the lines of its places are unknown."""
    return Table(Faults(Document(name, "", _no_lines), kind.error, kind.do), (), content)


def _no_lines(text: str) -> Mapping[Place, int]:
    return {}


def _explain_not_readable(
    name: str, expected: Message, fault: SyntaxFault, kind: FileKind
) -> KinegradeError:
    where = str(Where(name, (), fault.line))
    return kind.error(*(Fault(where, what, expected, kind.do or _FIX_IT) for what in fault.faults))
