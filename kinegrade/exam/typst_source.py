"""Papers, keys and galleries as Typst source: one call of a layout with one string of data.

Plain text goes into the data as it is, prose and math as Typst code made by `kinegrade.exam.markup` and
`formula`, figures through their own back end. The layouts (`layouts/*.typ`) evaluate such code. As all data
is one string, what two papers share is the same to Typst, which then need not lay it out again.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable
from dataclasses import asdict
from fractions import Fraction
from itertools import groupby
from typing import Any, TypeVar
from unicodedata import east_asian_width

from kinegrade.errors import TypesetError
from kinegrade.exam.document import (
    AnswerRow,
    Gallery,
    GalleryEntry,
    GalleryFigure,
    KeyAnswer,
    KeyBook,
    KeyEntry,
    KeyPaper,
    KeyParameter,
    Paper,
    PaperSize,
    QuestionSheet,
)
from kinegrade.exam.formula import formula, literal, unit_text
from kinegrade.exam.markup import line, prose
from kinegrade.exam.words import GalleryWords, Words, gallery_words_of, words_of
from kinegrade.figure.scene import Scene
from kinegrade.figure.typst import to_typst

Item = TypeVar("Item")
Value = TypeVar("Value")
Sheet = dict[str, Any]  # what a layout reads: text, numbers, lists and dictionaries of them

BESIDE = 80.0  # millimetres: a wider figure leaves too narrow a column of text beside it
PAGE = 225.0  # millimetres: what any page holds between its margins, with something to spare


def paper_source(paper: Paper, size: PaperSize = "a4") -> str:
    """Typst source of one student's paper; raises TypesetError with all faults of its texts."""
    words = words_of(paper.language)
    sheet = _gathered(
        rules=lambda: _each(lambda rule: prose(rule, "rules"), paper.rules),
        questions=lambda: _each(lambda question: _question(question, words), paper.questions),
    )
    sheet |= {name: getattr(paper, name) for name in ("course", "title", "date", "student", "name", "code")}
    sheet |= {
        "language": paper.language,
        "size": size,
        "total": points_text(paper.points),
        "words": _words(words),
    }
    return _call("paper", sheet)


def key_source(book: KeyBook, first_page: int = 1, size: PaperSize = "a4") -> str:
    """Typst source of a key, its pages numbered from `first_page`; raises TypesetError with all faults."""
    sheet: Sheet = {"papers": _each(_key_paper, book.papers), "words": _words(words_of(book.language))}
    sheet |= {name: getattr(book, name) for name in ("language", "course", "title", "warning")}
    return _call("key", sheet | {"size": size, "first-page": first_page})


def gallery_source(gallery: Gallery, size: PaperSize = "a4") -> str:
    """Typst source of a contact sheet of templates; raises TypesetError with all faults of their texts."""
    words = gallery_words_of(gallery.language)
    entries = _each(lambda entry: _gallery_entry(entry, words), gallery.entries)
    families = [{"name": family or words.unreadable, "entries": list(members)}
                for family, members in groupby(entries, lambda entry: entry["family"])]
    sheet = {"families": families, "words": asdict(words) | {"page": words.page.split("{}")}}
    sheet |= {"language": gallery.language, "size": size, "title": words.title.format(len(gallery.entries))}
    return _call("gallery", sheet)


def points_text(points: Fraction) -> str:
    """Points as they are printed: a decimal where one is exact, else a fraction.

    >>> [points_text(Fraction(value)) for value in ("4", "5/2", "1/3")]
    ['4', '2.5', '1/3']
    """
    decimal = f"{float(points):.6g}"
    return decimal if Fraction(decimal) == points else str(points)


def _question(question: QuestionSheet, words: Words) -> Sheet:
    where = question.identifier
    points = words.point if question.points == 1 else words.points
    sheet = _gathered(
        title=lambda: line(question.title, f"{where}, title"),
        statement=lambda: prose(question.statement, f"{where}, statement"),
        rows=lambda: _each(lambda row: _answer_row(row, where), question.rows),
    )
    return sheet | {
        "heading": _heading(question, words),
        "points": points.format(points_text(question.points)),
        "source": words.source.format(question.source) if question.source else None,
        "short": _height_at_most(question) <= PAGE,
        "figure": f"[{to_typst(question.figure)}]" if question.figure else None,
        "beside": question.figure is not None and _beside(question.figure),
    }


def _heading(question: QuestionSheet, words: Words) -> str:
    """The question's number on this paper, beside it the name of its columns where that has another number."""
    known = words.question if question.identifier == f"q{question.number}" else words.question_known
    return known.format(question.number, question.identifier)


def _beside(figure: Scene) -> bool:
    """Whether text fits beside the figure; a flat one stands better below it."""
    return figure.width <= BESIDE and figure.height >= figure.width / 4


def _height_at_most(question: QuestionSheet) -> float:
    """Millimetres that a question's block does not exceed, with narrow columns and tall lines throughout.

    Only for questions above a page's height need Typst measure, which doubles the time of typesetting.
    """
    figure = question.figure.height if question.figure else 0.0
    lines = _columns(question.statement) / 40 + question.statement.count("\n")
    rows = sum(10 + 5 * max(_columns(row.meaning) / 16, _columns(row.sign) / 16) for row in question.rows)
    return 40 + figure + 6.5 * lines + rows


def _columns(text: str) -> int:
    """The width of `text`, a Chinese character counting as two Latin ones."""
    return sum(2 if east_asian_width(character) in "WF" else 1 for character in text)


def _answer_row(row: AnswerRow, where: str) -> Sheet:
    sheet = _gathered(
        symbol=lambda: f"${formula(row.symbol, f'{where}, symbol')}$",
        meaning=lambda: line(row.meaning, f"{where}, meaning"),
        sign=lambda: line(row.sign, f"{where}, sign"),
    )
    return sheet | {"unit": unit_text(row.unit), "points": points_text(row.points)}


def _key_paper(paper: KeyPaper) -> Sheet:
    entries = _each(lambda entry: _key_entry(entry, f"{paper.code}, {entry.identifier}"), paper.entries)
    return {"student": paper.student, "name": paper.name, "code": paper.code, "entries": entries}


def _key_entry(entry: KeyEntry, where: str) -> Sheet:
    sheet = _gathered(
        title=lambda: line(entry.title, where),
        parameters=lambda: _each(lambda parameter: _key_parameter(parameter, where), entry.parameters),
        answers=lambda: _each(lambda answer: _key_answer(answer, where), entry.answers),
    )
    return sheet | {"identifier": entry.identifier}


def _key_parameter(parameter: KeyParameter, where: str) -> str:
    """`r = 1/5 = 0.2 m`; the decimal is not repeated where the exact value is written the same way."""
    equation = f"${formula(parameter.symbol, where)}$;"
    if parameter.exact is not None and parameter.exact != parameter.decimal:
        equation += f'" = ";${formula(parameter.exact, where)}$;'
    unit = "" if parameter.unit == "1" else unit_text(parameter.unit)
    space = "" if unit in ("", "°") else "\u202f"
    return "{" + equation + literal(f" = {_signed(parameter.decimal)}{space}{unit}") + "}"


def _key_answer(answer: KeyAnswer, where: str) -> Sheet:
    return {
        "symbol": f"${formula(answer.symbol, where)}$",
        "exact": None if answer.exact is None else f"${formula(answer.exact, where)}$",
        "decimal": _signed(answer.decimal),
        "unit": unit_text(answer.unit),
        "interval": _signed(answer.interval),
        "points": points_text(answer.points),
    }


def _gallery_entry(entry: GalleryEntry, words: GalleryWords) -> Sheet:
    sheet = _gathered(
        title=lambda: line(entry.title, f"{entry.name}, title") if entry.title else None,
        asks=lambda: _symbols(entry.asks, entry.name),
        on_request=lambda: _symbols(entry.on_request, entry.name),
        figures=lambda: _each(lambda draw: _gallery_figure(draw, entry.name), entry.figures),
    )
    combinations = words.combinations.format(f"{entry.combinations:,}")
    return sheet | {"family": entry.family, "name": entry.name, "combinations": combinations, "faults": entry.faults}


def _gallery_figure(draw: GalleryFigure, where: str) -> Sheet:
    return {"figure": f"[{to_typst(draw.figure)}]", "givens": line(draw.givens, f"{where}, values drawn")}


def _symbols(symbols: Iterable[str], where: str) -> list[str]:
    return _each(lambda symbol: f"${formula(symbol, f'{where}, symbol')}$", symbols)


def _signed(number: str) -> str:
    """The number with a minus sign instead of a hyphen."""
    return number.replace("-", "\u2212")


def _words(words: Words) -> Sheet:
    """The fixed words; those around page numbers as the pieces between the numbers."""
    return asdict(words) | {"page": words.page.split("{}"), "key_page": words.key_page.split("{}")}


def _call(layout: str, sheet: Sheet) -> str:
    data = literal(json.dumps(sheet, ensure_ascii=False, sort_keys=True))
    return f'#import "/{layout}.typ": {layout}\n#{layout}(json(bytes({data})))\n'


def _gathered(**parts: Callable[[], Any]) -> Sheet:
    """The value of every part, or one error with the faults of all of them."""
    return dict(zip(parts, _each(lambda part: part(), parts.values()), strict=True))


def _each(convert: Callable[[Item], Value], items: Iterable[Item]) -> list[Value]:
    """Every item converted, or one error with the faults of all of them."""
    values: list[Value] = []
    problems: list[str] = []
    for item in items:
        try:
            values.append(convert(item))
        except TypesetError as error:
            problems += error.problems
    if problems:
        raise TypesetError(*problems)
    return values
