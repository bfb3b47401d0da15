"""Worked solutions as LaTeX source: the same course of the page that Typst prints."""

from __future__ import annotations

from collections.abc import Sequence
from typing import assert_never

from kinegrade.figure.back_ends.tikz import write_tikz
from kinegrade.language.catalogue import Catalogue, open_catalogue
from kinegrade.language.gathering import convert_each, gather
from kinegrade.language.math.latex import TEX, write_latex_row
from kinegrade.language.math.latex_text import write_comment, write_plain
from kinegrade.language.message import Location
from kinegrade.language.prose.latex import write_line, write_prose
from kinegrade.press.latex.document import write_command, write_environment, write_title
from kinegrade.press.places import locate_part, locate_question, locate_solutions
from kinegrade.press.sheet import SolutionSheet, WorkedQuestion
from kinegrade.press.solutions.chains import UNKNOWN, name_question
from kinegrade.press.solutions.course import (
    Part,
    TextArea,
    arrange_courses,
)
from kinegrade.press.solutions.drawing_rows import Drawing, DrawingRow
from kinegrade.press.solutions.equations import Equations
from kinegrade.press.solutions.settings import (
    Body,
    Column,
    EquationGroups,
    Paragraph,
    Setting,
    Terms,
)
from kinegrade.press.solutions.shortening import shorten
from kinegrade.press.solutions.terms import Band, Cell, TermColumn

_WIDTH, _HEIGHT = 170.0, 234.0  # millimetres that every paper has, as in the style


def write_solution_body(sheet: SolutionSheet) -> str:
    """One student's worked solutions; raises TypesetError with all faults of its texts."""
    words, where = open_catalogue(sheet.language), locate_solutions(sheet.code)
    texts = (sheet.title, sheet.course, sheet.date, sheet.student, sheet.name, sheet.code)
    head = write_command("solutionhead", *map(write_plain, texts))
    column = Column(_WIDTH, words.raw("language", "page.")["script"])
    area = TextArea(column, _HEIGHT, parts_chains=False)
    short = [shorten(question, area) for question in sheet.questions]
    questions = convert_each(
        lambda pair: _write_question(*pair, words, where),
        zip(short, arrange_courses(short, area).parts, strict=True),
    )
    lines = (write_comment(words.write(where)), write_title(sheet.title), head, *questions)
    return write_environment("sheet", lines) + "\n"


def _write_question(
    question: WorkedQuestion, course: Sequence[Part], words: Catalogue, sheet: Location
) -> str:
    where = locate_question(sheet, question.identifier, question.template)
    parts = gather(
        title=lambda: write_line(question.title, locate_part(where, "title")),
        course=lambda: convert_each(lambda part: _write_part(part, where), course),
    )
    heading = write_plain(words.write(name_question(question)))
    return "\n".join(
        (
            write_comment(words.write(where)),
            write_command("worked", heading, parts["title"]),
            *parts["course"],
        )
    )


def _write_part(part: Part, where: Location) -> str:
    """A block over the whole width, or drawings with the blocks that stand beside them."""
    match part:
        case Setting():
            return _write_setting(part, where)
        case DrawingRow():
            written = gather(
                drawings=lambda: convert_each(
                    lambda drawing: _write_drawing(drawing, where), part.drawings
                ),
                beside=lambda: convert_each(
                    lambda setting: _write_setting(setting, where), part.beside
                ),
            )
            drawings, beside = "%\n".join(written["drawings"]), "%\n".join(written["beside"])
            if not beside:
                return write_command("pictures", drawings)
            return write_command("passage", f"{part.width:.6g}mm", drawings, beside)
        case _:
            assert_never(part)


def _write_setting(setting: Setting, where: Location) -> str:
    """One block, and whether it stays on the page of the next one."""
    return _write_body(setting.body, where) + (r"\stays" if setting.stays else "")


def _write_body(body: Body, where: Location) -> str:
    match body:
        case Paragraph():
            return _write_paragraph(body, where)
        case EquationGroups(groups):
            return "".join(map(_write_equations, groups))
        case Terms(bands):
            return "\n".join(convert_each(lambda band: _write_band(band, where), bands))
        case _:
            assert_never(body)


def _write_paragraph(paragraph: Paragraph, where: Location) -> str:
    """A heading, the sentences on its line, an equation on theirs."""
    heading, equation = paragraph.heading, paragraph.equation
    written = gather(
        heading=lambda: write_line(heading.text, where) if heading else "",
        text=lambda: write_prose(paragraph.text, where) if paragraph.text else "",
    )
    name = "chapter" if heading and heading.level == 1 else "step"
    head = write_command(name, written["heading"]) if heading else ""
    formula = write_command("announced", write_latex_row(equation, TEX)) if equation else ""
    return head + write_command("reasoning", written["text"] + formula)


def _write_equations(equations: Equations) -> str:
    rows = r"\\".join(write_latex_row(row, TEX) for row in equations.rows)
    return write_command("equations" if equations.fits else "wideequations", rows)


def _write_band(band: Band, where: Location) -> str:
    cells = convert_each(lambda column: _write_column(column, where), band)
    rows = ("".join(parts) for parts in zip(*cells, strict=True))
    return write_command("terms", str(len(band)), *rows)


def _write_column(column: TermColumn, where: Location) -> tuple[str, str, str]:
    """The entries of a term in the rows of the equation, the magnitudes and the directions."""
    parts = gather(
        magnitude=lambda: _write_cell(column.magnitude, where),
        direction=lambda: _write_cell(column.direction, where),
    )
    symbol = write_latex_row(column.term.symbol, TEX)
    return (
        f"&${column.term.sign}$&\\normalsize${symbol}$",
        f"&&{parts['magnitude']}",
        f"&&{parts['direction']}",
    )


def _write_cell(cell: Cell, where: Location) -> str:
    """Formulas one below another, or words that are broken into lines; what is unknown is bold."""
    if cell.formulas:
        lines = (f"${write_latex_row(row, TEX)}$" for row in cell.formulas)
        return write_command("formulas", r"\\".join(lines))
    written = write_line(cell.text, where)
    if cell.text == UNKNOWN:
        return rf"\textbf{{{written}}}"
    return write_command("cell", f"{cell.width:.6g}mm", written)


def _write_drawing(drawing: Drawing, where: Location) -> str:
    caption = drawing.caption
    written = gather(
        figure=lambda: write_tikz(drawing.scene),
        caption=lambda: "" if caption is None else write_line(caption, where),
    )
    return write_command("drawing", f"{drawing.width:.6g}mm", written["figure"], written["caption"])
