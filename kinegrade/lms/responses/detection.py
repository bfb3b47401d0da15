"""Which system a download comes from, by its header."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from kinegrade.errors import TableError
from kinegrade.exam.folder.records import ExamHead
from kinegrade.files.header_line import HeaderSign
from kinegrade.files.tables import Table
from kinegrade.language.lines import show_in_one_line
from kinegrade.language.message import Fault, Message, list_plainly
from kinegrade.lms.responses import canvas, moodle, sheet
from kinegrade.lms.responses.below import long
from kinegrade.lms.responses.forms import google_forms, ms_forms, wjx
from kinegrade.lms.responses.typed_rows import Attempts, TypedRows


@dataclass(frozen=True, slots=True)
class Dialect:
    """How a system writes responses: their title, how they are recognised, how they are read."""

    title: Message
    recognises: Callable[[Sequence[str]], bool]
    read: Callable[[Table, ExamHead, Attempts], TypedRows]


DIALECTS: Mapping[str, Dialect] = {
    "moodle": Dialect(moodle.TITLE, moodle.recognises, moodle.read),
    "canvas": Dialect(canvas.TITLE, canvas.recognises, canvas.read),
    "wjx": Dialect(wjx.TITLE, wjx.recognises, wjx.read),
    "ms-forms": Dialect(ms_forms.TITLE, ms_forms.recognises, ms_forms.read),
    "google-forms": Dialect(google_forms.TITLE, google_forms.recognises, google_forms.read),
    "long": Dialect(long.TITLE, long.recognises, long.read),
    "sheet": Dialect(sheet.TITLE, sheet.recognises, sheet.read),
}


def is_header(source: str | None) -> HeaderSign:
    """What takes a line for the header of a system's files, or of any system's where it is
    None.
    """
    if source is not None and source in DIALECTS:
        return DIALECTS[source].recognises
    return lambda cells: any(each.recognises(cells) for each in DIALECTS.values())


def detected(table: Table) -> str:
    """The first dialect that recognises the header, by name. Raises TableError where none does."""
    name = next(
        (name for name, dialect in DIALECTS.items() if dialect.recognises(table.header)), None
    )
    if name is None:
        shown = list_plainly(show_in_one_line(cell[:60]) for cell in table.header[:6])
        raise TableError(
            Fault(
                table.file,
                Message("responses.no-system", columns=shown),
                Message("responses.systems", systems=list_plainly(DIALECTS)),
                Message("responses.say-which"),
            ),
            *(each.fault for each in table.complaints if each.line is None),
        )
    return name
