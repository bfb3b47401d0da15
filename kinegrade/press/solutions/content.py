"""What a worked solution puts on the page: chains of text and the drawings between them, found once
for all ways of laying it out.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache

from kinegrade.press.sheet import WorkedQuestion
from kinegrade.press.solutions.chains import Chain, Placed, chain_blocks, join_sentences
from kinegrade.press.solutions.drawing_rows import Drawing
from kinegrade.worked.document import Pictures, Prose


@dataclass(frozen=True, eq=False)
class Drawings:
    """Drawings that stand side by side where they have room."""

    drawings: tuple[Drawing, ...]


@dataclass(frozen=True, eq=False)
class Content:
    """The question's figure, its statement and its solution."""

    figure: Drawing | None
    items: tuple[Chain | Drawings, ...]


@lru_cache(maxsize=64)  # a question is laid out alone, then among others, as usual and tighter
def find_content(question: WorkedQuestion) -> Content:
    """The content of a question."""
    figure = question.figure
    drawing = None if figure is None else Drawing(figure, None, question.title)
    return Content(drawing, tuple(_list_items(question)))


def _list_items(question: WorkedQuestion) -> Iterator[Chain | Drawings]:
    yield (Placed(Prose(question.statement), stays=False),)
    for part in chain_blocks(tuple(join_sentences(question.blocks))):
        yield _draw(part) if isinstance(part, Pictures) else part


def _draw(pictures: Pictures) -> Drawings:
    return Drawings(
        tuple(Drawing(each.scene, each.caption, each.caption) for each in pictures.pictures)
    )
