"""A formula sheet as pages, from a text: the same for papers by every typesetter."""

from __future__ import annotations

import typst

from kinegrade.errors import TypesetError
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.message import Fault, Message
from kinegrade.language.prose.typst import write_prose
from kinegrade.press.sheet import PaperSize
from kinegrade.press.typst.compiler import make_compiler
from kinegrade.press.typst.layout_call import write_layout_call

_WHERE = Message("typesetting.place-formula-sheet")


def print_formula_sheet(text: str, language: Language, size: PaperSize) -> bytes:
    """The pages of a text, Markdown with LaTeX math, as PDF. Raises TypesetError with its
    faults.
    """
    words = open_catalogue(language)
    sheet = {
        "title": words.text("paper.formula-sheet"),
        "text": write_prose(text, _WHERE, language),
        "language": words.raw("language", "page."),
        "size": size,
    }
    source = write_layout_call("formula-sheet", sheet)
    try:
        pdf = make_compiler().compile(source.encode(), format="pdf", timestamp=0)
    except typst.TypstError as error:
        raise TypesetError(Fault(_WHERE, " ".join(error.message.split()))) from error
    return pdf if isinstance(pdf, bytes) else b""
