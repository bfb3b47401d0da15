"""A paper as a pandoc document: what the layout of Typst shows, in headings, paragraphs and
tables.

The names of styles are those of `layouts/styles.xml`, and in small letters the classes of
`html/layouts/paper.css`.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

from kinegrade.language.catalogue import Catalogue, open_catalogue
from kinegrade.language.gathering import convert_each, gather
from kinegrade.language.math.units import write_unit
from kinegrade.language.message import Location
from kinegrade.language.prose.pandoc import make_formula, write_line, write_prose
from kinegrade.language.prose.pandoc_tree import (
    Node,
    make_bullets,
    make_line_break,
    make_paragraph,
    make_plain,
    make_strong,
    make_text,
)
from kinegrade.press.paper_parts import (
    arrange_marks,
    write_other_number,
    write_points_text,
    write_worth,
)
from kinegrade.press.places import RULES, locate_part
from kinegrade.press.sheet import AnswerRow, Paper, QuestionSheet
from kinegrade.press.word.head import write_conditions, write_fields, write_origin
from kinegrade.press.word.tree import (
    Alignment,
    make_document,
    make_heading,
    make_image,
    make_styled,
    make_table,
)

_FIELD_WIDTHS = (0.5, 0.25, 0.25)
_ROW_WIDTHS = (0.38, 0.13, 0.22, 0.18, 0.09)
_ROW_SIDES: tuple[Alignment, ...] = ("Default", "Right", "Default", "Default", "Right")
_MARKS = 12  # questions in one table for the marker
_CENTER: Alignment = "Center"
_MARK_SIDES: tuple[Alignment, ...] = ("Default", *(_CENTER,) * _MARKS)
_NO_BREAK = "\u00a0"
_GAP = 2 * _NO_BREAK
_LINE = 24 * "_"  # to write on, on a paper that is nobody's yet


def write_paper_tree(paper: Paper, figures: Mapping[int, str], logo: str = "") -> bytes:
    """The document, to be handed to pandoc as `json`; `figures` holds a data URI for each question
    that has a figure, `logo` is one where the paper has a logo.

    Raises TypesetError with all faults of the paper's texts.
    """
    words = open_catalogue(paper.language)
    parts = gather(
        rules=lambda: convert_each(lambda rule: [make_plain(write_line(rule, RULES))], paper.rules),
        questions=lambda: convert_each(
            lambda question: _write_question(question, figures, words), paper.questions
        ),
        conditions=lambda: write_conditions(paper.head, words),
    )
    head = [
        *write_origin(paper.head, logo),
        *_write_title(paper),
        _write_fields(paper, words),
        *_write_marks(paper, words),
        *parts["conditions"],
    ]
    rules = (
        [
            make_styled(
                "Rules",
                [_write_bold_line(words.text("paper.layout.rules")), make_bullets(parts["rules"])],
            )
        ]
        if parts["rules"]
        else []
    )
    return make_document(
        [*head, *rules, *(block for question in parts["questions"] for block in question)]
    )


def _write_title(paper: Paper) -> list[Node]:
    course = f"{paper.course}{_GAP}·{_GAP}{paper.date}" if paper.date else paper.course
    return [
        make_styled("Course", [make_paragraph([make_text(course)])]),
        make_styled("Title", [make_paragraph([make_text(paper.title)])]),
    ]


def _write_fields(paper: Paper, words: Catalogue) -> Node:
    """The student's name and id and the paper's code, side by side."""
    fields = (
        (words.text("paper.layout.name"), paper.name),
        (words.text("paper.layout.student"), paper.student),
        (words.text("paper.layout.paper"), paper.code),
    )
    return write_fields([(label, value or _LINE) for label, value in fields], _FIELD_WIDTHS)


def _write_marks(paper: Paper, words: Catalogue) -> Iterator[Node]:
    """For the marker: under each question's number its points, and room for the mark."""
    for part in arrange_marks(paper, words.text("paper.layout.total"), _MARKS):
        numbers = (words.text("paper.layout.number-column"), *(number for number, _ in part))
        rows = (
            (words.text("paper.layout.out-of"), *(points for _, points in part)),
            (words.text("paper.layout.mark"), *(_NO_BREAK for _ in part)),
        )
        widths = (0.16, *(0.07 for _ in part))
        yield make_table(
            "marks",
            widths,
            _MARK_SIDES[: len(widths)],
            _write_plain_cells(numbers),
            [_write_plain_cells(row) for row in rows],
            row_heads=1,
        )


def _write_plain_cells(texts: Iterable[str]) -> list[Node]:
    return [make_plain([make_text(words)]) for words in texts]


def _write_bold_line(words: str) -> Node:
    return make_paragraph([make_strong([make_text(words)])])


def _write_question(
    question: QuestionSheet, figures: Mapping[int, str], words: Catalogue
) -> list[Node]:
    where = question.identifier
    parts = gather(
        title=lambda: write_line(question.title, locate_part(where, "title")),
        statement=lambda: write_prose(question.statement, locate_part(where, "statement")),
        rows=lambda: convert_each(lambda row: _write_row(row, where, words), question.rows),
    )
    blocks = [make_heading(1, _write_head(question, parts["title"], words)), *parts["statement"]]
    if question.figure and question.number in figures:
        picture = make_image(
            figures[question.number],
            question.figure.width,
            question.described.short if question.described else "",
        )
        blocks.append(make_styled("Figure", [make_paragraph([picture])]))
    if question.rows:
        blocks.append(_write_answer_table(parts["rows"], words))
    if question.source:
        source = make_text(words.text("paper.source", source=question.source))
        blocks.append(make_styled("Source", [make_paragraph([source])]))
    return blocks


def _write_answer_table(rows: Sequence[Sequence[Node]], words: Catalogue) -> Node:
    heads = (
        words.text("paper.layout.asked"),
        words.text("paper.layout.symbol-column"),
        words.text("paper.layout.answer"),
        words.text("paper.layout.tolerance"),
        words.text("paper.layout.point-column"),
    )
    return make_table("answers", _ROW_WIDTHS, _ROW_SIDES, _write_plain_cells(heads), rows)


def _write_head(question: QuestionSheet, title: Sequence[Node], words: Catalogue) -> list[Node]:
    """Number, title, the number in the answer sheet where that is another, and points."""
    other = write_other_number(question, words)
    known = other and _GAP + other
    points = write_worth(question, words)
    return [
        make_text(f"{question.number}{_GAP}"),
        *title,
        make_text(f"{known}{_GAP}·{_GAP}{points}"),
    ]


def _write_row(row: AnswerRow, where: Location, words: Catalogue) -> list[Node]:
    parts = gather(
        meaning=lambda: write_line(row.meaning, locate_part(where, "meaning")),
        sign=lambda: write_line(row.sign, locate_part(where, "sign")),
        symbol=lambda: [
            make_formula(row.symbol, locate_part(where, "symbol")),
            make_text(f"{_NO_BREAK}="),
        ],
        tolerance=lambda: convert_each(
            lambda line: write_line(line, locate_part(where, "tolerance")), row.tolerance
        ),
    )
    unit = words.text("paper.unitless") if row.unit == "1" else write_unit(row.unit)
    box = make_styled("Answer box", [make_paragraph([make_text(unit)])])
    points = make_plain([make_text(f"/ {write_points_text(row.points, words.language)}")])
    asked = _write_lines([parts["meaning"], parts["sign"]])
    return [asked, make_plain(parts["symbol"]), box, _write_lines(parts["tolerance"]), points]


def _write_lines(lines: Iterable[Sequence[Node]]) -> Node:
    """Those of the lines that are not empty, one below another."""
    nodes = [node for line in lines if line for node in (make_line_break(), *line)]
    return make_plain(nodes[1:])
