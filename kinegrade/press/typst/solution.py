"""Worked solutions as Typst source: one call of the layout `solution.typ` with one string of data.

Prose and math become Typst code by their writers, pictures by the figures' back end. What stands
beside what has been decided before, so that the layout measures nothing but tables of terms.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass, field
from typing import assert_never

from kinegrade.figure.back_ends.typst import write_typst_picture
from kinegrade.language import Language
from kinegrade.language.catalogue import Catalogue, open_catalogue
from kinegrade.language.gathering import convert_each, gather
from kinegrade.language.math.tree import Row, Sign
from kinegrade.language.math.typst.equation import write_display, write_equation
from kinegrade.language.math.typst.formula import write_typst_row
from kinegrade.language.message import Location
from kinegrade.language.prose.typst import write_line, write_prose
from kinegrade.press.figure_text import describe_figure
from kinegrade.press.places import locate_part
from kinegrade.press.sheet import PaperSize, SolutionSheet, WorkedQuestion
from kinegrade.press.solutions.chains import UNKNOWN, name_question
from kinegrade.press.solutions.course import Courses, Part, arrange_courses
from kinegrade.press.solutions.drawing_rows import Drawing, DrawingRow
from kinegrade.press.solutions.equations import Equations
from kinegrade.press.solutions.settings import (
    DENSE,
    LOOSE,
    LOOSER,
    TIGHT,
    USUAL,
    Body,
    EquationGroups,
    Paragraph,
    Setting,
    Spread,
    Terms,
)
from kinegrade.press.solutions.terms import Cell, TermColumn
from kinegrade.press.typst.layout_call import Sheet, write_layout_call
from kinegrade.press.typst.solution_area import find_area
from kinegrade.worked.document import Heading

_DOUBT = 0.05  # pages by which tight solutions may turn out shorter than their parts are high
_SURE = 0.05  # pages by which heights of parts are never wrong
_WELL_BEGUN = 0.15  # of a last page: where it holds more than that, it is needed
_SPILLED = 1 / 3  # of a last page: what it holds is less than that
_HALF_EMPTY = 0.65  # by heights of parts, which are rather too large


@dataclass(frozen=True)
class SolutionLayouts:
    """One student's worked solutions with more or less room between blocks and lines, each laid out
    once.
    """

    sheet: SolutionSheet
    size: PaperSize = "a4"
    _arranged: dict[Spread, Courses] = field(default_factory=dict)

    def write(self, spread: Spread = USUAL) -> str:
        """Typst source; raises TypesetError with all faults of the texts."""
        sheet, words = self.sheet, open_catalogue(self.sheet.language)
        data: Sheet = {
            "questions": convert_each(
                lambda pair: _write_question(*pair, sheet, words),
                zip(sheet.questions, self._arrange(spread).parts, strict=True),
            )
        }
        data |= {
            name: getattr(sheet, name)
            for name in ("course", "title", "date", "student", "name", "code")
        }
        data |= {"language": words.raw("language", "page.")}
        data |= {"size": self.size, "spread": asdict(spread)}
        data |= {"words": words.raw("solution", "layout.")}
        return write_layout_call("large-solution" if sheet.large else "solution", data)

    def may_take_fewer(self, pages: int, spread: Spread = TIGHT) -> bool:
        """Whether tight solutions may take fewer than so many pages, by the heights of their parts:
        what is far from it need not be typeset. Large print is never tight.
        """
        return not self.sheet.large and self._arrange(spread).pages < pages - 1 + _DOUBT

    def foresee_pages(self) -> int | None:
        """How many pages solutions take as usual; None where heights of parts leave it open."""
        full, over = divmod(self._arrange(USUAL).pages, 1)
        return int(full) + 1 if _WELL_BEGUN < over < 1 - _SURE else None

    def may_spill(self) -> bool:
        """Whether the last page holds so little that lines close together save it, by heights."""
        full, over = divmod(self._arrange(USUAL).pages, 1)
        return bool(full) and over < _SPILLED and self.may_take_fewer(int(full) + 1, DENSE)

    def choose_spread(self) -> Spread:
        """Loose where the last page would not be half full, no tight setting saves it and a loose
        one takes no further page; else the usual spread. All of it by heights of parts.
        """
        full, over = divmod(self._arrange(USUAL).pages, 1)
        if self.sheet.large or not full or not _SURE < over < _HALF_EMPTY:
            return USUAL
        if self.may_take_fewer(int(full) + 1):
            return USUAL
        fit = (one for one in (USUAL, LOOSE, LOOSER) if self._arrange(one).pages < full + 1 - _SURE)
        filled = [(one, self._arrange(one).pages - full) for one in fit]
        half = (one for one, last in filled if one != USUAL and last >= _HALF_EMPTY)
        return next(half, filled[-1][0] if filled else USUAL)

    def _arrange(self, spread: Spread) -> Courses:
        if spread not in self._arranged:
            self._arranged[spread] = _arrange(self.sheet, self.size, spread)
        return self._arranged[spread]


def _arrange(sheet: SolutionSheet, size: PaperSize, spread: Spread) -> Courses:
    return arrange_courses(sheet.questions, find_area(sheet, size, spread))


def _write_question(
    question: WorkedQuestion, course: Sequence[Part], sheet: SolutionSheet, words: Catalogue
) -> Sheet:
    name = question.identifier
    where = locate_part(name, "solution")
    written = gather(
        title=lambda: write_line(question.title, locate_part(name, "title"), words.language),
        parts=lambda: convert_each(lambda part: _write_part(part, where, words.language), course),
    )
    repeated = (question.title,) == tuple(each.title for each in sheet.questions) == (sheet.title,)
    heading = None if repeated else words.write(name_question(question))
    levels = [block.level for block in question.blocks if isinstance(block, Heading)]
    return written | {"heading": heading, "outermost": next(iter(levels), 1)}


def _write_part(part: Part, where: Location, language: Language) -> Sheet:
    """A block over the whole width, or drawings with the blocks that stand beside them."""
    match part:
        case Setting():
            return _write_setting(part, where, language)
        case DrawingRow():
            written = gather(
                drawings=lambda: convert_each(
                    lambda drawing: _write_drawing(drawing, where, language), part.drawings
                ),
                beside=lambda: convert_each(
                    lambda setting: _write_setting(setting, where, language), part.beside
                ),
            )
            return written | {"kind": "drawings", "width": part.width, "whole": part.whole}
        case _:
            assert_never(part)


def _write_setting(setting: Setting, where: Location, language: Language) -> Sheet:
    return _write_body(setting.body, where, language) | {"stays": setting.stays}


def _write_body(body: Body, where: Location, language: Language) -> Sheet:
    match body:
        case Paragraph():
            return _write_paragraph(body, where, language)
        case EquationGroups(groups):
            return {
                "kind": "display",
                "groups": [_write_equations(group, language) for group in groups],
            }
        case Terms(bands):
            return {
                "kind": "terms",
                "bands": convert_each(
                    lambda band: convert_each(
                        lambda column: _write_column(column, where, language), band
                    ),
                    bands,
                ),
            }
        case _:
            assert_never(body)


def _write_paragraph(paragraph: Paragraph, where: Location, language: Language) -> Sheet:
    heading, equation = paragraph.heading, paragraph.equation
    written = gather(
        heading=lambda: write_line(heading.text, where, language) if heading else None,
        text=lambda: write_prose(paragraph.text, where, language) if paragraph.text else None,
    )
    return written | {
        "kind": "paragraph",
        "level": heading.level if heading else 0,
        "tall": paragraph.is_tall,
        "equation": _write_displayed(equation, language) if equation else None,
    }


def _write_displayed(equation: Row, language: Language) -> str:
    """An equation on the line of a sentence, as large as on a line of its own."""
    return write_equation(equation, language, f"display({write_typst_row(equation)})")


def _write_equations(equations: Equations, language: Language) -> Sheet:
    """Equations aligned; where some are too wide also each by itself, as large print makes no
    other smaller.
    """
    written: Sheet = {
        "code": write_display(tuple(equations.rows), language),
        "fits": equations.fits,
    }
    if not equations.fits:
        written["rows"] = [write_display((row,), language) for row in equations.rows]
    return written


def _write_column(column: TermColumn, where: Location, language: Language) -> Sheet:
    cells = gather(
        magnitude=lambda: _write_cell(column.magnitude, where, language),
        direction=lambda: _write_cell(column.direction, where, language),
    )
    term = column.term
    return cells | {
        "symbol": write_equation(term.symbol, language),
        "sign": write_equation((Sign(term.sign),), language) if term.sign else None,
        "width": column.width,
    }


def _write_cell(cell: Cell, where: Location, language: Language) -> str:
    """Formulas one below another, or words; what is unknown is bold."""
    if cell.formulas:
        return "+linebreak()+".join(write_equation(row, language) for row in cell.formulas)
    written = write_line(cell.text, where, language)
    return f"strong({written})" if cell.text == UNKNOWN else written


def _write_drawing(drawing: Drawing, where: Location, language: Language) -> Sheet:
    caption = drawing.caption
    written = gather(
        figure=lambda: f"[{write_typst_picture(drawing.scene)}]",
        caption=lambda: None if caption is None else write_line(caption, where, language),
    )
    return written | {"width": drawing.width, "said": describe_figure(drawing.title, language)}
