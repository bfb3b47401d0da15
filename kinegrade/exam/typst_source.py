"""Papers, keys and galleries as Typst source: one call of a layout with one string of data.

Plain text goes into the data as it is, prose, math and figures as Typst code made by their writers.
The layouts (`layouts/*.typ`) evaluate such code. As all data is one string, what two papers share
is the same to Typst, which then need not lay it out again.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import asdict
from fractions import Fraction
from functools import lru_cache
from itertools import groupby
from unicodedata import east_asian_width

from kinegrade.exam.formula import convert_formula, write_literal, write_unit
from kinegrade.exam.layout_call import Sheet, write_layout_call
from kinegrade.exam.words import GalleryWords, Words, choose_gallery_words, choose_words
from kinegrade.figure.scene import Scene
from kinegrade.figure.typst import write_typst, write_typst_picture
from kinegrade.language.gathering import convert_each, gather
from kinegrade.language.prose.typst import write_line, write_prose
from kinegrade.press.code_mark import make_code_mark
from kinegrade.press.sheet import (
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
from kinegrade.question_numbers import find_bank_number, find_other_number
from kinegrade.worked.formula_width import measure_width

BESIDE = 80.0  # millimetres: a wider figure leaves too narrow a column of text beside it
_PAGE = 225.0  # millimetres: a little less than any page holds between its margins
_MEASURE = 123.0  # millimetres: the width of a line of text, without a figure beside it
COLUMNS_OF_MARKS = 13  # the total among them: as many as stand side by side in the marker's table
_LINE_OF_ROW = 36  # Latin characters that surely fit a line of what is asked for
_PARAGRAPH = re.compile(r"\n\s*\n|\n(?=\s*(?:[-*+]|\d+[.)])\s)")  # or item of a list
_PLAIN_SYMBOL = 7  # letters of a symbol that surely fits its column
_PLAIN_EXACT = (
    26  # letters' widths of an exact value: a wider one may be too wide for its column in the key
)


def write_paper_source(paper: Paper, size: PaperSize = "a4") -> str:
    """Typst source of one student's paper; raises TypesetError with all faults of its texts."""
    words = choose_words(paper.language)
    sheet = gather(
        rules=lambda: _halve(
            convert_each(lambda rule: write_prose(rule, "rules"), paper.rules), paper.rules
        ),
        questions=lambda: convert_each(
            lambda question: _write_question(question, words), paper.questions
        ),
    )
    sheet |= {
        name: getattr(paper, name)
        for name in ("course", "title", "date", "student", "name", "code")
    }
    return write_layout_call(
        "paper",
        sheet
        | {
            "language": paper.language,
            "size": size,
            "mark": _write_code_image(paper.code),
            "marks": _arrange_marks(paper, words),
            "words": _write_words(words),
        },
    )


def write_key_source(book: KeyBook, first_page: int = 1, size: PaperSize = "a4") -> str:
    """Typst source of a key, its pages numbered from `first_page`; raises TypesetError with all
    faults.
    """
    sheet: Sheet = {
        "papers": convert_each(_write_key_paper, book.papers),
        "words": _write_words(choose_words(book.language)),
    }
    sheet |= {name: getattr(book, name) for name in ("language", "course", "title", "warning")}
    return write_layout_call("key", sheet | {"size": size, "first-page": first_page})


def write_gallery_source(gallery: Gallery, size: PaperSize = "a4") -> str:
    """Typst source of a contact sheet of templates; raises TypesetError with all faults of their
    texts.
    """
    words = choose_gallery_words(gallery.language)
    entries = convert_each(lambda entry: _write_gallery_entry(entry, words), gallery.entries)
    families = [
        {"name": family or words.unreadable, "entries": list(members)}
        for family, members in groupby(entries, lambda entry: entry["family"])
    ]
    sheet = {"families": families, "words": asdict(words) | {"page": words.page.split("{}")}}
    sheet |= {
        "language": gallery.language,
        "size": size,
        "title": words.title.format(len(gallery.entries)),
    }
    return write_layout_call("gallery", sheet)


@lru_cache(maxsize=1024)
def write_points_text(points: Fraction) -> str:
    """Points as they are printed: a decimal where one is exact, else a fraction.

    >>> [write_points_text(Fraction(value)) for value in ("4", "5/2", "1/3")]
    ['4', '2.5', '1/3']
    """
    decimal = f"{float(points):.6g}"
    return decimal if Fraction(decimal) == points else str(points)


def _write_code_image(code: str) -> str:
    """The QR code as an SVG image of one path, its size without the white margin."""
    mark = make_code_mark(code)
    path = "".join(f"M{x} {y}h{length}v1h-{length}z" for x, y, length in mark.runs)
    box = f'viewBox="0 0 {mark.size} {mark.size}"'
    return f'<svg xmlns="http://www.w3.org/2000/svg" {box}><path d="{path}"/></svg>'


def _arrange_marks(paper: Paper, words: Words) -> list[list[tuple[str, str]]]:
    """The columns of the marker's table, number and points of each question and the total, in rows
    of columns.
    """
    columns = [
        (str(question.number), write_points_text(question.points)) for question in paper.questions
    ]
    columns.append((words.total, write_points_text(paper.points)))
    return [
        columns[start : start + COLUMNS_OF_MARKS]
        for start in range(0, len(columns), COLUMNS_OF_MARKS)
    ]


def _halve(pieces: Sequence[str], texts: Sequence[str]) -> tuple[Sequence[str], Sequence[str]]:
    """The pieces in two columns, of nearly equal length where each is as long as its text."""
    lengths = [len(text) for text in texts]
    middle = min(
        range(len(texts) + 1), key=lambda index: abs(sum(lengths[:index]) - sum(lengths[index:]))
    )
    return pieces[:middle], pieces[middle:]


def _write_question(question: QuestionSheet, words: Words) -> Sheet:
    where = question.identifier
    points = words.point if question.points == 1 else words.points
    figure, other = question.figure, find_other_number(where, question.number)
    sheet = gather(
        title=lambda: write_line(question.title, f"{where}, title"),
        statement=lambda: write_prose(question.statement, f"{where}, statement"),
        rows=lambda: convert_each(
            lambda row: _write_answer_row(row, where, words.unitless), question.rows
        ),
    )
    return sheet | {
        "number": str(question.number),
        "known": None if other is None else words.known.format(other),
        "points": points.format(write_points_text(question.points)),
        "source": words.source.format(question.source) if question.source else None,
        "short": _bound_height(question) <= _PAGE,
        "figure": f"[{write_typst_picture(figure)}]" if figure else None,
        "figure_width": round(figure.width, 3) if figure else None,
        "beside": figure is not None and _fits_beside(figure),
    }


def _fits_beside(figure: Scene) -> bool:
    """Whether text fits beside the figure; a flat one stands better below it."""
    return figure.width <= BESIDE and figure.height >= figure.width / 4


def _bound_height(question: QuestionSheet) -> float:
    """Millimetres that a question's block does not exceed, with wide characters and tall lines
    throughout.

    Only for questions above a page's height need Typst measure, which makes typesetting several
    times as long.
    """
    figure = question.figure
    beside = figure is not None and _fits_beside(figure)
    measure = _MEASURE - figure.width + 40 if figure and beside else _MEASURE
    paragraphs = _PARAGRAPH.split(question.statement)
    text = sum(
        6 + 6 * _count_columns(_reduce_to_seen(paragraph)) / (measure / 2)
        for paragraph in paragraphs
    )
    text += 8 * question.statement.count("frac") + 8 * question.statement.count("$$")
    rows = sum(10 + 5 * _bound_lines(row) for row in question.rows)
    height = figure.height if figure else 0.0
    return 30 + (max(text, height) if beside else text + height) + rows


def _reduce_to_seen(math: str) -> str:
    """The text with each LaTeX command as one letter and without braces and dollar signs: what
    takes up room.
    """
    return re.sub(r"[{}$_^]", "", re.sub(r"\\[A-Za-z]+", "x", math))


def _count_columns(text: str) -> int:
    """The width of `text`, a Chinese character counting as two Latin ones."""
    if text.isascii():
        return len(text)
    return sum(2 if east_asian_width(character) in "WF" else 1 for character in text)


def _bound_lines(row: AnswerRow) -> int:
    """The lines that what is asked for, and its sign convention below it, surely fit."""
    return sum(
        1 + (_count_columns(text) - 1) // _LINE_OF_ROW for text in (row.meaning, row.sign) if text
    )


@lru_cache(maxsize=1024)
def _write_answer_row(row: AnswerRow, where: str, unitless: str) -> Sheet:
    """The same for a whole class."""
    sheet = gather(
        symbol=lambda: f"${convert_formula(row.symbol, f'{where}, symbol')}$",
        meaning=lambda: write_line(row.meaning, f"{where}, meaning"),
        sign=lambda: write_line(row.sign, f"{where}, sign") if row.sign else None,
    )
    return sheet | {
        "wide": len(_reduce_to_seen(row.symbol)) > _PLAIN_SYMBOL,
        "unit": unitless if row.unit == "1" else write_unit(row.unit),
        "points": write_points_text(row.points),
    }


def _write_key_paper(paper: KeyPaper) -> Sheet:
    entries = convert_each(
        lambda entry: _write_key_entry(entry, f"{paper.code}, {entry.identifier}"), paper.entries
    )
    return {"student": paper.student, "name": paper.name, "code": paper.code, "entries": entries}


def _write_key_entry(entry: KeyEntry, where: str) -> Sheet:
    sheet = gather(
        title=lambda: write_line(entry.title, where),
        parameters=lambda: convert_each(
            lambda parameter: _write_key_parameter(parameter, where), entry.parameters
        ),
        answers=lambda: convert_each(
            lambda answer: _write_key_answer(answer, where), entry.answers
        ),
    )
    return sheet | {"number": find_bank_number(entry.identifier)}


def _write_key_parameter(parameter: KeyParameter, where: str) -> str:
    """`r = 1/5 = 0.2 m`; the decimal is not repeated where the exact value is written the same
    way.
    """
    equation = f"${convert_formula(parameter.symbol, where)}$;"
    if parameter.exact is not None and parameter.exact != parameter.decimal:
        equation += f'" = ";${convert_formula(parameter.exact, where)}$;'
    unit = "" if parameter.unit == "1" else write_unit(parameter.unit)
    space = "" if unit in ("", "°") else "\u202f"
    return (
        "{" + equation + write_literal(f" = {_write_signed(parameter.decimal)}{space}{unit}") + "}"
    )


def _write_key_answer(answer: KeyAnswer, where: str) -> Sheet:
    return {
        "symbol": f"${convert_formula(answer.symbol, where)}$",
        "exact": None if answer.exact is None else f"${convert_formula(answer.exact, where)}$",
        "wide": len(_reduce_to_seen(answer.symbol)) > _PLAIN_SYMBOL
        or measure_width(answer.exact or "") > _PLAIN_EXACT,
        "decimal": _write_signed(answer.decimal),
        "unit": write_unit(answer.unit),
        "interval": _write_signed(answer.interval),
        "points": write_points_text(answer.points),
    }


def _write_gallery_entry(entry: GalleryEntry, words: GalleryWords) -> Sheet:
    sheet = gather(
        title=lambda: write_line(entry.title, f"{entry.name}, title") if entry.title else None,
        asks=lambda: _write_symbols(entry.asks, entry.name),
        on_request=lambda: _write_symbols(entry.on_request, entry.name),
        figures=lambda: convert_each(
            lambda draw: _write_gallery_figure(draw, entry.name), entry.figures
        ),
    )
    combinations = words.combinations.format(f"{entry.combinations:,}")
    return sheet | {
        "family": entry.family,
        "name": entry.name,
        "combinations": combinations,
        "faults": entry.faults,
    }


def _write_gallery_figure(draw: GalleryFigure, where: str) -> Sheet:
    return {
        "figure": f"[{write_typst(draw.figure)}]",
        "givens": write_line(draw.givens, f"{where}, values drawn"),
    }


def _write_symbols(symbols: Iterable[str], where: str) -> list[str]:
    return convert_each(lambda symbol: f"${convert_formula(symbol, f'{where}, symbol')}$", symbols)


def _write_signed(number: str) -> str:
    """The number with a minus sign instead of a hyphen."""
    return number.replace("-", "\u2212")


@lru_cache(maxsize=8)
def _write_words(words: Words) -> Sheet:
    """The fixed words; those around page numbers as the pieces between the numbers."""
    return asdict(words) | {"page": words.page.split("{}"), "key_page": words.key_page.split("{}")}
