"""Papers as Typst source: one call of a layout with one string of data.

Plain text goes into the data as it is, prose, math and figures as Typst code made by their writers.
The layouts (`layouts/*.typ`) evaluate such code. As all data is one string, what two papers share
is the same to Typst, which then need not lay it out again.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

from kinegrade.figure.back_ends.typst import write_typst_picture
from kinegrade.language import Language
from kinegrade.language.catalogue import Catalogue, open_catalogue
from kinegrade.language.gathering import convert_each, gather
from kinegrade.language.math.typst.equation import write_formula
from kinegrade.language.math.units import write_unit
from kinegrade.language.message import Location
from kinegrade.language.prose.typst import write_line, write_prose
from kinegrade.press.code_mark import make_code_mark
from kinegrade.press.figure_text import describe_figure
from kinegrade.press.paper_head import PaperHead
from kinegrade.press.paper_parts import (
    arrange_marks,
    fits_beside,
    write_other_number,
    write_points_text,
    write_worth,
)
from kinegrade.press.places import RULES, locate_part
from kinegrade.press.sheet import AnswerRow, Paper, PaperSize, QuestionSheet
from kinegrade.press.typst.layout_call import Sheet, write_layout_call
from kinegrade.press.typst.room import fit_space, fits_page, is_wide_symbol


def write_paper_source(paper: Paper, size: PaperSize = "a4") -> str:
    """Typst source of one student's paper; raises TypesetError with all faults of its texts."""
    words = open_catalogue(paper.language)
    sheet = gather(
        rules=lambda: _halve(
            convert_each(lambda rule: write_prose(rule, RULES, paper.language), paper.rules),
            paper.rules,
        ),
        questions=lambda: convert_each(
            lambda question: _write_question(question, words), paper.questions
        ),
        head=lambda: _write_head(paper.head, words),
    )
    sheet |= {
        name: getattr(paper, name)
        for name in ("course", "title", "date", "student", "name", "code")
    }
    return write_layout_call(
        "large-paper" if paper.large else "paper",
        sheet
        | {
            "language": words.raw("language", "page."),
            "size": size,
            "pages": paper.pages,
            "mark": _write_code_image(paper.code),
            "marks": arrange_marks(paper, words.text("paper.layout.total")),
            "words": words.raw("paper", "layout."),
        },
    )


def _write_head(head: PaperHead, words: Catalogue) -> Sheet:
    sheet = gather(
        aids=lambda: write_line(head.aids, "header.aids", words.language) if head.aids else None,
        instructions=lambda: (
            write_prose(head.instructions, "header.instructions", words.language)
            if head.instructions
            else None
        ),
    )
    return sheet | {
        "institution": head.institution,
        "logo": head.logo or None,
        "times": head.list_times(words),
        "blanks": head.list_blanks(words),
    }


def _write_code_image(code: str) -> str:
    """The QR code as an SVG image of one path, its size without the white margin."""
    mark = make_code_mark(code)
    path = "".join(f"M{x} {y}h{length}v1h-{length}z" for x, y, length in mark.runs)
    box = f'viewBox="0 0 {mark.size} {mark.size}"'
    return f'<svg xmlns="http://www.w3.org/2000/svg" {box}><path d="{path}"/></svg>'


def _halve(pieces: Sequence[str], texts: Sequence[str]) -> tuple[Sequence[str], Sequence[str]]:
    """The pieces in two columns, of nearly equal length where each is as long as its text."""
    lengths = [len(text) for text in texts]
    middle = min(
        range(len(texts) + 1), key=lambda index: abs(sum(lengths[:index]) - sum(lengths[index:]))
    )
    return pieces[:middle], pieces[middle:]


def _write_question(question: QuestionSheet, words: Catalogue) -> Sheet:
    where = question.identifier
    figure = question.figure
    sheet = gather(
        title=lambda: write_line(question.title, locate_part(where, "title"), words.language),
        statement=lambda: write_prose(
            question.statement, locate_part(where, "statement"), words.language
        ),
        rows=lambda: convert_each(lambda row: _write_answer_row(row, where, words), question.rows),
    )
    return sheet | {
        "number": str(question.number),
        "known": write_other_number(question, words) or None,
        "points": write_worth(question, words),
        "source": words.text("paper.source", source=question.source) if question.source else None,
        "short": fits_page(question),
        "space": fit_space(question),
        "figure": f"[{write_typst_picture(figure)}]" if figure else None,
        "figure_text": _describe(question, words.language) if figure else None,
        "figure_width": round(figure.width, 3) if figure else None,
        "beside": figure is not None and fits_beside(figure),
    }


def _describe(question: QuestionSheet, language: Language) -> str:
    """The figure in a short text; its title where there is nothing that could move."""
    described = question.described
    return described.short if described else describe_figure(question.title, language)


@lru_cache(maxsize=1024)
def _write_answer_row(row: AnswerRow, where: Location, words: Catalogue) -> Sheet:
    """The same for a whole class."""
    sheet = gather(
        symbol=lambda: write_formula(row.symbol, locate_part(where, "symbol"), words.language),
        meaning=lambda: write_line(row.meaning, locate_part(where, "meaning"), words.language),
        sign=lambda: (
            write_line(row.sign, locate_part(where, "sign"), words.language) if row.sign else None
        ),
        tolerance=lambda: convert_each(
            lambda line: write_line(line, locate_part(where, "tolerance"), words.language),
            row.tolerance,
        ),
    )
    return sheet | {
        "wide": is_wide_symbol(row.symbol, locate_part(where, "symbol")),
        "unit": words.text("paper.unitless") if row.unit == "1" else write_unit(row.unit),
        "points": write_points_text(row.points, words.language),
    }
