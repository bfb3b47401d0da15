"""A paper as a pandoc document: what `layouts/paper.typ` lays out, in headings, paragraphs and
tables.

The names of styles are those of `layouts/word-styles.xml`, and in small letters the classes of
`layouts/paper.css`.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

from kinegrade.exam.document import AnswerRow, Paper, QuestionSheet
from kinegrade.exam.formula import unit_text
from kinegrade.exam.layout_call import each, gathered
from kinegrade.exam.pandoc_prose import line_inlines, math_inline, prose_blocks
from kinegrade.exam.pandoc_tree import (
    Alignment,
    Node,
    bullets,
    document,
    heading,
    image,
    line_break,
    paragraph,
    plain,
    strong,
    styled,
    table,
    text,
)
from kinegrade.exam.typst_source import points_text
from kinegrade.exam.words import Words, words_of
from kinegrade.question_numbers import other_number

FIELD_WIDTHS = (0.5, 0.25, 0.25)
FIELD_SIDES: tuple[Alignment, ...] = ("Default", "Default", "Default")
ROW_WIDTHS = (0.44, 0.14, 0.31, 0.11)
ROW_SIDES: tuple[Alignment, ...] = ("Default", "Right", "Default", "Right")
MARKS = 12  # questions in one table for the marker
CENTER: Alignment = "Center"
MARK_SIDES: tuple[Alignment, ...] = ("Default", *(CENTER,) * MARKS)
NO_BREAK = "\u00a0"
GAP = 2 * NO_BREAK


def paper_tree(paper: Paper, figures: Mapping[int, str]) -> bytes:
    """The document, to be handed to pandoc as `json`; `figures` holds a data URI for each question
    that has a figure.

    Raises TypesetError with all faults of the paper's texts.
    """
    words = words_of(paper.language)
    parts = gathered(
        rules=lambda: each(lambda rule: [plain(line_inlines(rule, "rules"))], paper.rules),
        questions=lambda: each(
            lambda question: _question(question, figures, words), paper.questions
        ),
    )
    head = [*_title(paper), _fields(paper, words), *_marks(paper, words)]
    rules = (
        [styled("Rules", [_bold_line(words.rules), bullets(parts["rules"])])]
        if parts["rules"]
        else []
    )
    return document(
        [*head, *rules, *(block for question in parts["questions"] for block in question)]
    )


def _title(paper: Paper) -> list[Node]:
    course = f"{paper.course}{GAP}·{GAP}{paper.date}" if paper.date else paper.course
    return [
        styled("Course", [paragraph([text(course)])]),
        styled("Title", [paragraph([text(paper.title)])]),
    ]


def _fields(paper: Paper, words: Words) -> Node:
    """The student's name and id and the paper's code, side by side."""
    fields = ((words.name, paper.name), (words.student, paper.student), (words.paper, paper.code))
    cells = [plain([text(label), line_break(), strong([text(value)])]) for label, value in fields]
    return table("fields", FIELD_WIDTHS, FIELD_SIDES, (), (cells,))


def _marks(paper: Paper, words: Words) -> Iterator[Node]:
    """For the marker: under each question's number its points, and room for the mark."""
    columns = [(str(question.number), points_text(question.points)) for question in paper.questions]
    columns.append((words.total, points_text(paper.points)))
    for start in range(0, len(columns), MARKS):
        part = columns[start : start + MARKS]
        rows = (
            (words.number_column, *(number for number, _ in part)),
            (words.out_of, *(points for _, points in part)),
            (words.mark, *(NO_BREAK for _ in part)),
        )
        widths = (0.16, *(0.07 for _ in part))
        yield table(
            "marks", widths, MARK_SIDES[: len(widths)], (), [_plain_cells(row) for row in rows]
        )


def _plain_cells(texts: Iterable[str]) -> list[Node]:
    return [plain([text(words)]) for words in texts]


def _bold_line(words: str) -> Node:
    return paragraph([strong([text(words)])])


def _question(question: QuestionSheet, figures: Mapping[int, str], words: Words) -> list[Node]:
    where = question.identifier
    parts = gathered(
        title=lambda: line_inlines(question.title, f"{where}, title"),
        statement=lambda: prose_blocks(question.statement, f"{where}, statement"),
        rows=lambda: each(lambda row: _row(row, where, words), question.rows),
    )
    blocks = [heading(1, _head(question, parts["title"], words)), *parts["statement"]]
    if question.figure and question.number in figures:
        picture = image(
            figures[question.number],
            question.figure.width,
            f"{words.number_column} {question.number}",
        )
        blocks.append(styled("Figure", [paragraph([picture])]))
    heads = (words.asked, NO_BREAK, words.answer, words.point_column)
    blocks.append(table("answers", ROW_WIDTHS, ROW_SIDES, _plain_cells(heads), parts["rows"]))
    source = (
        [styled("Source", [paragraph([text(words.source.format(question.source))])])]
        if question.source
        else []
    )
    return [*blocks, *source]


def _head(question: QuestionSheet, title: Sequence[Node], words: Words) -> list[Node]:
    """Number, title, the number in the answer sheet where that is another, and points."""
    other = other_number(question.identifier, question.number)
    known = "" if other is None else GAP + words.known.format(other)
    points = (words.point if question.points == 1 else words.points).format(
        points_text(question.points)
    )
    return [text(f"{question.number}{GAP}"), *title, text(f"{known}{GAP}·{GAP}{points}")]


def _row(row: AnswerRow, where: str, words: Words) -> list[Node]:
    parts = gathered(
        meaning=lambda: line_inlines(row.meaning, f"{where}, meaning"),
        sign=lambda: line_inlines(row.sign, f"{where}, sign"),
        symbol=lambda: [math_inline(row.symbol, f"{where}, symbol"), text(f"{NO_BREAK}=")],
    )
    sign = [line_break(), *parts["sign"]] if parts["sign"] else []
    unit = words.unitless if row.unit == "1" else unit_text(row.unit)
    box = styled("Answer box", [paragraph([text(unit)])])
    points = plain([text(f"/ {points_text(row.points)}")])
    return [plain([*parts["meaning"], *sign]), plain(parts["symbol"]), box, points]
