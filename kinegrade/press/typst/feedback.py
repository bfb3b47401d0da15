"""Feedback sheets as PDF, by the embedded Typst, each followed by the worked solution if wanted.

`kinegrade.reports.feedback.feedback` makes the sheets.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.gathering import convert_each, gather
from kinegrade.language.math.typst.equation import write_formula
from kinegrade.language.message import Location, Message
from kinegrade.language.prose.typst import write_line
from kinegrade.press.join import join_pages
from kinegrade.press.legible import make_legible
from kinegrade.press.places import locate_part
from kinegrade.press.sheet import FeedbackQuestion, FeedbackRow, FeedbackSheet, PaperSize
from kinegrade.press.typst.layout_call import Sheet, write_layout_call
from kinegrade.press.typst.press import TypstPress

_ROW_TEXTS = ("typed", "read_as", "right", "allowed", "mark", "verdict", "points", "reason")
_SHEET_TEXTS = (
    "course",
    "title",
    "date",
    "student",
    "name",
    "code",
    "total",
    "grade",
    "subtracted",
)


def print_feedback(sheet: FeedbackSheet, solution: bytes | None = None) -> bytes:
    """The sheet as PDF, as `FeedbackPress` gives it, by the press that this process keeps."""
    return _press().feedback(sheet, solution)


@lru_cache(maxsize=1)
def _press() -> FeedbackPress:
    return FeedbackPress()


class FeedbackPress(TypstPress):
    """A press for feedback sheets; keep one for a class."""

    def feedback(self, sheet: FeedbackSheet, solution: bytes | None = None) -> bytes:
        """The sheet as PDF, followed by the pages of `solution`, itself a PDF.

        In names and in what a student typed, characters that no font has are printed as code
        points. Raises TypesetError with all faults of the exam's texts.
        """
        plain = [text for text in _write_plain_texts(sheet) if not text.isascii()]
        pdf = self._explaining(
            _write_feedback_source(sheet, self.unprintable(plain), self._size),
            Message("typesetting.place-feedback", code=sheet.code),
        )
        return pdf if solution is None else join_pages([pdf, solution])


def _write_feedback_source(
    sheet: FeedbackSheet, missing: frozenset[str] = frozenset(), size: PaperSize = "a4"
) -> str:
    """Typst source of a sheet, the characters `missing` as code points. Raises TypesetError with
    all faults.
    """
    catalogue = open_catalogue(sheet.language)
    parts = gather(
        questions=lambda: convert_each(
            lambda question: _write_question(question, missing, sheet.language), sheet.questions
        )
    )
    said = {
        "guesses": sheet.guesses,
        "kept": sheet.kept,
        "words": catalogue.raw("feedback", "sheet."),
        "language": catalogue.raw("language", "page."),
        "size": size,
    }
    layout = "large-feedback" if sheet.large else "feedback"
    return write_layout_call(layout, {**parts, **_texts(sheet, _SHEET_TEXTS, missing), **said})


def _write_question(
    question: FeedbackQuestion, missing: frozenset[str], language: Language
) -> Sheet:
    parts = gather(
        title=lambda: write_line(question.title, locate_part(question.heading, "title"), language),
        givens=lambda: (
            write_line(question.givens, locate_part(question.heading, "givens"), language)
            if question.givens
            else None
        ),
        rows=lambda: convert_each(
            lambda row: _write_row(row, question.heading, missing, language), question.rows
        ),
    )
    note = make_legible(question.note, missing)
    return parts | {"heading": question.heading, "points": question.points, "note": note}


def _write_row(
    row: FeedbackRow, where: Location, missing: frozenset[str], language: Language
) -> Sheet:
    parts = gather(
        symbol=lambda: write_formula(row.symbol, locate_part(where, "symbol"), language),
        meaning=lambda: write_line(row.meaning, locate_part(where, "meaning"), language),
        sign=lambda: (
            write_line(row.sign, locate_part(where, "sign"), language) if row.sign else None
        ),
        exact=lambda: (
            write_formula(row.exact, locate_part(where, "symbol"), language) if row.exact else None
        ),
        remark=lambda: (
            write_line(row.remark, locate_part(where, "remark"), language) if row.remark else None
        ),
    )
    return parts | _texts(row, _ROW_TEXTS, missing)


def _texts(holder: object, names: Sequence[str], missing: frozenset[str]) -> dict[str, str]:
    return {name: make_legible(getattr(holder, name), missing) for name in names}


def _write_plain_texts(sheet: FeedbackSheet) -> list[str]:
    rows = [row for question in sheet.questions for row in question.rows]
    return [
        *(question.note for question in sheet.questions),
        *_texts(sheet, _SHEET_TEXTS, frozenset()).values(),
        *(text for row in rows for text in _texts(row, _ROW_TEXTS, frozenset()).values()),
    ]
