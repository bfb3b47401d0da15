"""The formula sheet of a bank: a file beside it, or the copy that an exam folder keeps.

formula-sheet = "formulas.pdf"
formula-sheet = "formulas.md"
"""

from __future__ import annotations

import re
from functools import partial
from pathlib import Path

from kinegrade.errors import FieldError
from kinegrade.exam.bank.files_beside import read_file_beside
from kinegrade.exam.folder.contents import FORMULA_PAGES, FORMULA_TEXT
from kinegrade.files.fields.table import Table
from kinegrade.files.fields.values import found, text
from kinegrade.language.message import Message
from kinegrade.press.sheet import MOST_FORMULA_PAGES, FormulaSheet

_MOST_BYTES = 5_000_000
_FILE = re.compile(r"[\w. -]{1,100}\.(pdf|md|txt)")
_BESIDE = Message("bank.formula-file")


def read_formula_sheet(table: Table, folder: Path, *, kept: bool) -> FormulaSheet | None:
    """What `formula-sheet` of a bank in that folder names; None where it names nothing, and after a
    fault. For a bank that is `kept` with an exam the folder holds the sheet as it was bound.
    """
    return table.optional("formula-sheet", partial(_read_kept if kept else _read, folder))


def list_formula_files(sheet: FormulaSheet | None) -> dict[str, bytes]:
    """What an exam folder keeps of a sheet, by the name of the file."""
    if sheet is None:
        return {}
    return {FORMULA_PAGES: sheet.pdf} if sheet.pdf else {FORMULA_TEXT: sheet.text.encode()}


def _read(folder: Path, value: object) -> FormulaSheet:
    name = text(value)
    kind = _FILE.fullmatch(name)
    if kind is None:
        raise FieldError(found(value), _BESIDE)
    content = read_file_beside(folder / name, _MOST_BYTES, _BESIDE)
    if kind[1] != "pdf":
        return FormulaSheet(text=_decode(content, name))
    # Loads what joins pages, which most banks do not need
    from kinegrade.press.formula_sheet import reduce_to_print  # noqa: PLC0415

    pages = reduce_to_print(content)
    if pages is None:
        raise FieldError(found(value), Message("bank.formula-pdf", most=MOST_FORMULA_PAGES))
    return FormulaSheet(pdf=pages)


def _read_kept(folder: Path, value: object) -> FormulaSheet:
    """The sheet that an exam folder keeps."""
    if not text(value).endswith(".pdf"):
        content = read_file_beside(folder / FORMULA_TEXT, _MOST_BYTES, _BESIDE)
        return FormulaSheet(text=_decode(content, FORMULA_TEXT))
    from kinegrade.press.formula_sheet import has_pages  # noqa: PLC0415

    pages = read_file_beside(folder / FORMULA_PAGES, 2 * _MOST_BYTES, _BESIDE)
    if not has_pages(pages):
        raise FieldError(found(FORMULA_PAGES), Message("bank.formula-pdf", most=MOST_FORMULA_PAGES))
    return FormulaSheet(pdf=pages)


def _decode(content: bytes, name: str) -> str:
    try:
        written = content.decode("utf-8-sig")
    except UnicodeDecodeError as fault:
        raise FieldError(found(name), Message("bank.formula-text")) from fault
    if not written.strip():
        raise FieldError(found(name), Message("bank.formula-text"))
    return written
