"""The head of a paper as parts of a pandoc document: who sets it, and what holds in the room."""

from __future__ import annotations

from collections.abc import Sequence

from kinegrade.language.catalogue import Catalogue
from kinegrade.language.gathering import gather
from kinegrade.language.prose.pandoc import write_line, write_prose
from kinegrade.language.prose.pandoc_tree import (
    Node,
    make_paragraph,
    make_plain,
    make_strong,
    make_text,
)
from kinegrade.press.paper_head import PaperHead
from kinegrade.press.word.tree import Alignment, make_image, make_styled, make_table

_LOGO = 14.0  # millimetres high
_NO_BREAK = "\u00a0"
_SIDE: Alignment = "Default"


def write_origin(head: PaperHead, logo: str) -> list[Node]:
    """The logo, a data URI, and the institution, as far as there are any."""
    picture = [make_image(logo, _LOGO, head.institution, "height")] if logo else []
    name = [make_text(head.institution)] if head.institution else []
    lines = [make_paragraph(line) for line in (picture, name) if line]
    return [make_styled("Course", lines)] if lines else []


def write_conditions(head: PaperHead, words: Catalogue) -> list[Node]:
    """Duration, aids and instructions, and lines to write on. Raises TypesetError."""
    parts = gather(
        aids=lambda: write_line(head.aids, "header.aids"),
        instructions=lambda: write_prose(head.instructions, "header.instructions"),
    )
    aids = [(words.text("paper.layout.aids"), parts["aids"])] if head.aids else []
    times = [(label, [make_text(text)]) for label, text in head.list_times(words)]
    labelled = [_write_condition(label, text) for label, text in (*times, *aids)]
    return [*labelled, *parts["instructions"], *_write_blanks(head.list_blanks(words))]


def _write_condition(label: str, text: Sequence[Node]) -> Node:
    return make_paragraph([make_strong([make_text(label)]), make_text(2 * _NO_BREAK), *text])


def _write_blanks(blanks: Sequence[tuple[str, str]]) -> list[Node]:
    """A box for each thing to be written by hand, under its label."""
    boxes = [(label, text or _NO_BREAK) for label, text in blanks]
    return [write_fields(boxes, (1 / len(boxes),) * len(boxes))] if boxes else []


def write_fields(fields: Sequence[tuple[str, str]], widths: Sequence[float]) -> Node:
    """Labels side by side, each over its value, in these parts of the page's width."""
    labels = [make_plain([make_text(label)]) for label, _ in fields]
    values = [make_plain([make_strong([make_text(value)])]) for _, value in fields]
    return make_table("fields", widths, (_SIDE,) * len(fields), labels, (values,))
