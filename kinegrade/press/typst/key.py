"""The instructor's key as Typst source."""

from __future__ import annotations

from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.gathering import convert_each, gather
from kinegrade.language.math.reading import read_math
from kinegrade.language.math.typst.equation import write_formula
from kinegrade.language.math.units import write_unit
from kinegrade.language.math.width import measure_row
from kinegrade.language.message import Location
from kinegrade.language.prose.typst import write_line
from kinegrade.language.typst_text import write_literal
from kinegrade.press.places import locate_paper, locate_question
from kinegrade.press.sheet import KeyAnswer, KeyBook, KeyEntry, KeyPaper, KeyParameter, PaperSize
from kinegrade.press.typst.layout_call import Sheet, write_layout_call, write_signed, write_value
from kinegrade.press.typst.room import is_wide_symbol
from kinegrade.question_numbers import find_bank_number

_PLAIN_EXACT = 26  # letters' widths of an exact value that surely fits its column


def write_key_source(book: KeyBook, first_page: int = 1, size: PaperSize = "a4") -> str:
    """Typst source of a key, its pages numbered from `first_page`; raises TypesetError with all
    faults.
    """
    words = open_catalogue(book.language)
    sheet: Sheet = {
        "papers": convert_each(lambda paper: _write_paper(paper, book.language), book.papers),
        "words": words.raw("paper", "layout."),
        "language": words.raw("language", "page."),
    }
    sheet |= {name: getattr(book, name) for name in ("course", "title", "warning")}
    return write_layout_call("key", sheet | {"size": size, "first-page": first_page})


def _write_paper(paper: KeyPaper, language: Language) -> Sheet:
    where = locate_paper(paper.code)
    entries = convert_each(
        lambda entry: _write_entry(entry, locate_question(where, entry.identifier), language),
        paper.entries,
    )
    return {"student": paper.student, "name": paper.name, "code": paper.code, "entries": entries}


def _write_entry(entry: KeyEntry, where: Location, language: Language) -> Sheet:
    sheet = gather(
        title=lambda: write_line(entry.title, where, language),
        parameters=lambda: convert_each(
            lambda parameter: _write_parameter(parameter, where, language), entry.parameters
        ),
        answers=lambda: convert_each(
            lambda answer: _write_answer(answer, where, language), entry.answers
        ),
    )
    return sheet | {"number": find_bank_number(entry.identifier), "note": entry.note}


def _write_parameter(parameter: KeyParameter, where: Location, language: Language) -> str:
    """`r = 1/5 = 0.2 m`; the decimal is not repeated where the exact value is written the same
    way.
    """
    equation = f"{write_formula(parameter.symbol, where, language)};"
    if parameter.exact:
        equation += f'" = ";{write_formula(parameter.exact, where, language)};'
    value = write_literal(f" = {write_value(parameter.decimal, parameter.unit)}")
    return f"{{{equation}{value}}}"


def _is_long(exact: str, where: Location) -> bool:
    """Whether an exact value may be too wide for its column."""
    return measure_row(read_math(exact, where)) > _PLAIN_EXACT


def _write_answer(answer: KeyAnswer, where: Location, language: Language) -> Sheet:
    return {
        "symbol": write_formula(answer.symbol, where, language),
        "exact": None if answer.exact is None else write_formula(answer.exact, where, language),
        "wide": is_wide_symbol(answer.symbol, where) or _is_long(answer.exact or "", where),
        "decimal": write_signed(answer.decimal),
        "unit": write_unit(answer.unit),
        "interval": write_signed(answer.interval),
        "points": answer.points,
    }
