"""A formula sheet that is bound behind papers: pages of somebody's PDF, or a text to be typeset.

PDF files that people bring are looked at by a process of its own, for a limited time, as logos are:
whatever one of them does to it, there is one line. Of their pages nothing is kept but what is
printed.
"""

from __future__ import annotations

import os
import sys
from functools import lru_cache
from io import BytesIO

import pikepdf

from kinegrade.language import Language
from kinegrade.press.join import join_pages
from kinegrade.press.program_run import run_program
from kinegrade.press.sheet import MOST_FORMULA_PAGES, FormulaSheet, PaperSize

_SECONDS = 30.0
_DONE_BY_READERS = ("/Annots", "/AA", "/B", "/StructParents", "/Thumb", "/PieceInfo", "/Metadata")


def reduce_to_print(content: bytes) -> bytes | None:
    """The pages of a PDF without links, scripts, forms and attached files; None where the file is
    no PDF, is damaged or locked, or has more than `MOST_FORMULA_PAGES`. Same input, same bytes.
    """
    command = [sys.executable, "-m", __name__]
    # The same modules as here, wherever the child is started
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(filter(None, sys.path))}
    try:
        done = run_program(command, _SECONDS, given=content, environment=environment)
    except (OSError, TimeoutError):
        return None
    return None if done.status or not done.output else done.output


def has_pages(pdf: bytes) -> bool:
    """Whether that is a PDF with pages, as `reduce_to_print` gives it."""
    try:
        with pikepdf.open(BytesIO(pdf)) as document:
            return len(document.pages) > 0
    except pikepdf.PdfError:
        return False


def bind(paper: bytes, sheet: FormulaSheet, language: Language, size: PaperSize) -> bytes:
    """A paper with the formula sheet behind it. Raises TypesetError for a text that cannot be
    typeset.
    """
    return join_pages([paper, _print(sheet, language, size)])


@lru_cache(maxsize=4)
def _print(sheet: FormulaSheet, language: Language, size: PaperSize) -> bytes:
    """The pages of a sheet, typeset once for a class."""
    if sheet.pdf:
        return sheet.pdf
    from kinegrade.press.typst.formula_sheet import print_formula_sheet  # noqa: PLC0415

    return print_formula_sheet(sheet.text, language, size)


def _reduce(content: bytes) -> bytes:
    reduced = BytesIO()
    with pikepdf.open(BytesIO(content)) as given, pikepdf.new() as kept:
        if not 0 < len(given.pages) <= MOST_FORMULA_PAGES:
            return b""
        for page in given.pages:
            for key in _DONE_BY_READERS:
                if key in page.obj:
                    del page.obj[key]
        kept.pages.extend(given.pages)
        kept.save(reduced, deterministic_id=True)
    return reduced.getvalue()


if __name__ == "__main__":
    sys.stdout.buffer.write(_reduce(sys.stdin.buffer.read()))
