"""What reading a file of answers took for granted, as it is said before anything is marked."""

from __future__ import annotations

from collections.abc import Iterator

from kinegrade.files.decoding import name_encoding
from kinegrade.files.tables import Table
from kinegrade.language.message import Message, Part, Quoted, list_all, list_statements
from kinegrade.lms.responses.detection import DIALECTS
from kinegrade.lms.responses.people import Columns
from kinegrade.lms.responses.typed_rows import TypedRows

# Of a sheet that is passed on as it is
_NOTHING, _NOBODY = TypedRows((), frozenset(), (), ()), Columns(None, None)


def list_assumptions(
    table: Table,
    name: str,
    source: str | None,
    typed: TypedRows = _NOTHING,
    columns: Columns = _NOBODY,
) -> Iterator[Message]:
    """What was taken for granted: the system, where none was named, the encoding, whose columns
    name students, and what the answers leave open.
    """
    if source is None and name != "sheet":
        yield Message("responses.taken-for", file=table.file, system=DIALECTS[name].title)
    if table.encoding not in ("UTF-8", "XLSX"):
        yield Message("responses.read-as", file=table.file, encoding=name_encoding(table.encoding))
    if name != "sheet":
        yield Message("responses.identified", file=table.file, columns=_titles(table, columns))
    if typed.assumed:
        what = list_statements(typed.assumed)
        yield Message("responses.assumed", file=table.file, what=what)


def _titles(table: Table, columns: Columns) -> Part:
    titles = [Quoted(" ".join(table.header[place].split())) for place in columns.indices]
    return list_all(titles) if titles else Message("responses.nothing")
