"""What was done by hand in an exam folder since it was generated, and would be lost by replacing
it: files edited or added, answers typed into the sheet.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from hashlib import sha256
from pathlib import Path

from kinegrade.errors import OutputError, TableError
from kinegrade.exam.folder.contents import ANSWERS
from kinegrade.exam.folder.records import ExamHead
from kinegrade.exam.printing.room_booklets import list_booklets
from kinegrade.files.cell_text import make_header_key, trim
from kinegrade.files.placing.droppings import DESKTOP_DROPPINGS
from kinegrade.files.tables import read_table
from kinegrade.language.message import Fault, Message, list_plainly

OWN_COLUMNS = ("student", "name")  # of the answer sheet; all others are for answers
_EDITED_BY_HAND = (".tex", ".sty", ".docx", ".html", ".toml", ".xlsx")
_UNRECORDED = (".tex", ".docx", ".html")  # kinds of editable files that earlier versions wrote
_NAMED = 5  # files that a message names


def digest_editable(folder: Path) -> dict[str, str]:
    """A digest of each file that people edit in place, by its path in the folder."""
    return {
        file.relative_to(folder).as_posix(): sha256(file.read_bytes()).hexdigest()
        for file in sorted(folder.rglob("*"))
        if file.suffix in _EDITED_BY_HAND and file.is_file()
    }


def require_nothing_edited(old: Path, head: ExamHead | None, new: Path) -> None:
    """Raises OutputError if the folder `old` holds work done by hand that the folder `new` does not
    hold; `head` is None if that of the folder cannot be read.
    """
    typed = [ANSWERS] if is_answered(old / ANSWERS) else []
    lost = [*find_edited(old, head, new), *_find_added(old, head, new), *typed]
    if lost:
        raise refuse_edited(old, lost)


def refuse_edited(folder: Path, names: Sequence[str]) -> OutputError:
    """The refusal to replace a folder that holds these files."""
    what = Message("exam.holds-edited", files=list_plainly(names[:_NAMED]))
    expected, do = Message("exam.only-rewritten"), Message("exam.move-or-choose")
    return OutputError(Fault(str(folder), what, expected, do))


def find_edited(old: Path, head: ExamHead | None, new: Path) -> Iterator[str]:
    """The files of a folder that differ from what was generated, and from those of the folder
    `new`.

    In a folder that does not record what was generated, the files that are meant to be edited and
    differ from the new ones.
    """
    stated = None if head is None else head.editable
    fresh = digest_editable(new)
    for name, found in digest_editable(old).items():
        unknown = stated is None and not name.endswith(_UNRECORDED)
        if unknown or found == fresh.get(name):
            continue
        if stated is None or found != stated.get(name):
            yield name


def _find_added(old: Path, head: ExamHead | None, new: Path) -> Iterator[str]:
    """The files below the folders of an exam that `generate` did not write there, such as notes
    beside the papers; files that people edit are left to `find_edited`.
    """
    everybody = head.everybody if head else ()
    stems = {Path(each.file).stem for each in everybody}
    stems |= list_booklets(head) if head else set()
    for file in sorted(old.glob("*/**/*")) if stems else ():
        printed = file.stem in stems and file.suffix == ".pdf"
        known = printed or file.suffix in _EDITED_BY_HAND or file.name in DESKTOP_DROPPINGS
        name = file.relative_to(old)
        if file.is_file() and not known and not (new / name).exists():
            yield name.as_posix()


def is_answered(sheet: Path) -> bool:
    """Whether answers were typed into an answer sheet, or it can no longer be read."""
    if not sheet.exists():
        return False
    try:
        table = read_table(sheet)
    except TableError:
        return True
    identifying = {
        place for place, name in enumerate(table.header) if make_header_key(name) in OWN_COLUMNS
    }
    return any(
        trim(cell)
        for row in table.rows
        for place, cell in enumerate(row.cells)
        if place not in identifying
    )
