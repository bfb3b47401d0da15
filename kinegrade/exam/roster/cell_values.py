"""What cells of a roster mean: the language of a paper, extra time, the format."""

from __future__ import annotations

import re
from dataclasses import dataclass
from decimal import Decimal
from functools import cache
from typing import Literal, TypeAlias, assert_never

from kinegrade.errors import FieldError
from kinegrade.exam.roster.students import PrintFormat
from kinegrade.files.cell_text import is_answered, make_header_key
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.known import known_languages
from kinegrade.language.message import Message, Quoted, list_plainly
from kinegrade.language.spellings import list_spellings

_EXTRA_TIME = re.compile(r"\+?\s*([0-9]{1,3}(?:[.,][0-9]{1,2})?)\s*(\D*?)\.?")
_MINUTES = Message("roster.minutes")
_NONE = Message("roster.no-extra-time")
_LARGE_PRINT, _USUAL_PRINT = Message("roster.large-print"), Message("roster.usual-print")
_TACTILE = Message("roster.tactile")
_PERCENT = "%"
_Unit: TypeAlias = Literal["percent", "minutes"]


@dataclass(frozen=True, slots=True)
class ExtraTime:
    """How much longer a student may write: a part of the exam's duration, or minutes."""

    amount: Decimal
    unit: _Unit

    @property
    def text(self) -> str:
        """The same as the exam folder keeps it, and as `read_extra_time` reads it."""
        match self.unit:
            case "percent":
                return f"{self.amount} %"
            case "minutes":
                return f"{self.amount} min"
            case _:
                assert_never(self.unit)


@cache
def _name_languages() -> dict[str, Language]:
    """The languages of papers by their names, in small letters."""
    return {
        name: language
        for language in known_languages()
        for name in (language, *open_catalogue(language).text("roster.own-names").split("|"))
    }


def read_paper_language(cell: str) -> Language | None:
    """The language in a cell, by its name or code ("de", "de-AT"); None for a blank one. Raises
    FieldError.

    >>> [read_paper_language(cell) for cell in ("Deutsch", "Englisch", "英语", "zh_CN", " ")]
    ['de', 'en', 'en', 'zh', None]
    """
    key = make_header_key(cell)
    if not is_answered(cell):
        return None
    names = _name_languages()
    found = names.get(key) or names.get(re.split("[-_]", key)[0])
    if found is None:
        expected = Message("exam.languages", languages=list_plainly(known_languages()))
        raise FieldError(Message("roster.unknown-language", cell=Quoted(cell)), expected)
    return found


def read_extra_time(cell: str, title: str) -> ExtraTime | None:
    """The extra time in a cell, whose unit may stand in the title of its column; None for none.
    Raises FieldError.

    >>> read_extra_time("25%", "Extra time").text, read_extra_time("30", "Extra time (min)").text
    ('25 %', '30 min')
    """
    key = make_header_key(cell)
    if not is_answered(cell) or key in list_spellings(_NONE):
        return None
    found = _EXTRA_TIME.fullmatch(key)
    unit = _find_unit(found[2] or _read_bracket(title)) if found else None
    if found is None or unit is None:
        what = Message("roster.unknown-extra-time", cell=Quoted(cell))
        raise FieldError(what, Message("roster.extra-time-expected"))
    amount = Decimal(found[1].replace(",", "."))
    return ExtraTime(amount, unit) if amount else None


def read_print_format(cell: str) -> PrintFormat:
    """The format of a paper in a cell; "" for the usual one. Raises FieldError.

    >>> read_print_format("Großdruck"), read_print_format("tactile"), read_print_format("no")
    ('large-print', 'tactile', '')
    """
    key = make_header_key(cell)
    if not is_answered(cell) or key in list_spellings(_USUAL_PRINT):
        return ""
    if key in list_spellings(_LARGE_PRINT):
        return "large-print"
    if key in list_spellings(_TACTILE):
        return "tactile"
    what = Message("roster.unknown-format", cell=Quoted(cell))
    raise FieldError(what, Message("roster.format-expected"))


def _read_bracket(title: str) -> str:
    """The unit at the end of a title, without its brackets."""
    return make_header_key(title).rpartition(" ")[2].strip("()[]") if title[-1:] in ")]" else ""


def _find_unit(text: str) -> _Unit | None:
    """The unit of a time that is written so."""
    if text == _PERCENT:
        return "percent"
    return "minutes" if text in list_spellings(_MINUTES) else None


def say_extra_time(text: str) -> Message:
    """An extra time that an exam folder keeps, as it is printed. Raises FieldError."""
    extra = read_extra_time(text, "")
    if extra is None:
        raise FieldError(Message("roster.unknown-extra-time", cell=Quoted(text)))
    match extra.unit:
        case "percent":
            return Message("grammar.percent", number=extra.amount)
        case "minutes":
            return Message("roster.extra-minutes", number=extra.amount)
        case _:
            assert_never(extra.unit)
