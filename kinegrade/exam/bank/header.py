"""What a bank states for the head of its papers: the table [header].

[header]
institution = "Department of Mechanics"
logo = "crest.svg"
duration = { en = "120 minutes", zh = "120 分钟" }
aids = "one sheet of notes, pocket calculator"
instructions = "Show your working."
room = true
seat = true
signature = true
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import partial
from pathlib import Path

from msgspec import Struct

from kinegrade.errors import FieldError
from kinegrade.exam.bank.files_beside import read_file_beside
from kinegrade.exam.bank.keys import HEADER
from kinegrade.exam.folder.contents import LOGO
from kinegrade.files.fields.place import Place
from kinegrade.files.fields.table import Table
from kinegrade.files.fields.values import flag, found, text
from kinegrade.language import Language
from kinegrade.language.message import Message
from kinegrade.press.paper_head import PaperHead
from kinegrade.problem.template.translated import Translated
from kinegrade.problem.template.translations import translated

_MOST_BYTES = 500_000
_MOST_KEPT = 10 * _MOST_BYTES  # an SVG takes more room than other pictures
_MEGAPIXELS = 25
_LOGO_FILE = re.compile(r"[\w. -]{1,100}\.(png|svg|pdf)")
_SENTENCES = ("institution", "duration", "aids", "instructions")
_PLACES = ("room", "seat")
HEADER_TEXTS = (*_SENTENCES, *_PLACES)  # what a translation beside a bank may hold
_BESIDE = Message("bank.logo-beside")
_NOTHING = Translated(plain="")


class Header(Struct, frozen=True):
    """The head of all papers of an exam; `logo` is an SVG that refers to nothing, "" for none."""

    texts: Mapping[str, Translated]
    logo: str = ""
    signature: bool = False

    def in_language(self, language: Language) -> PaperHead:
        """The head in one language. Raises TemplateError where a text lacks it."""
        texts = {name: text.in_language(language) for name, text in self.texts.items()}
        return PaperHead(**texts, logo=self.logo, signature=self.signature)


NO_HEADER = Header({})


def find_header_places(header: object) -> dict[Place, Place]:
    """Where a translation may have texts of the table [header], and where they go."""
    there = header if isinstance(header, dict) else {}
    return {("header", key): ("header", key) for key in HEADER_TEXTS if key in there}


def read_header(table: Table, folder: Path, *, kept: bool) -> Header:
    """The table [header] of a bank's file in that folder; for a bank that is `kept` with an exam,
    the folder holds the logo as it was converted.
    """
    header = table.table("header").only(*HEADER)
    texts = {
        name: header.optional(name, read)
        for name, read in (
            *((name, translated) for name in _SENTENCES),
            *((name, _read_place) for name in _PLACES),
        )
    }
    reading = partial(_read_kept_logo if kept else _read_logo, folder)
    return Header(
        {name: stated for name, stated in texts.items() if stated is not None},
        header.with_default("logo", reading, ""),
        header.with_default("signature", flag, False),
    )


def _read_place(value: object) -> Translated | None:
    """A room or a seat: a text, a line to write it on, or nothing."""
    if isinstance(value, bool):
        return _NOTHING if value else None
    try:
        return translated(value)
    except FieldError as error:
        raise FieldError(error.what, Message("bank.true-or-text")) from error


def _read_logo(folder: Path, value: object) -> str:
    """The logo in a file beside the bank."""
    name = text(value)
    kind = _LOGO_FILE.fullmatch(name)
    if kind is None:
        raise FieldError(found(value), _BESIDE)
    # Loads the typesetter, which most banks do not need
    from kinegrade.press.typst.logo import convert_logo  # noqa: PLC0415

    svg = convert_logo(read_file_beside(folder / name, _MOST_BYTES, _BESIDE), kind[1], _MEGAPIXELS)
    if not svg:
        sound = Message("bank.logo-of-kind", kind=kind[1].upper(), most=_MEGAPIXELS)
        raise FieldError(found(value), sound)
    return svg


def _read_kept_logo(folder: Path, value: object) -> str:
    """The logo that an exam folder keeps."""
    return read_file_beside(folder / LOGO, _MOST_KEPT, _BESIDE).decode(errors="replace")
