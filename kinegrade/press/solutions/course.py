"""The course of a worked solution on the page: what stands beside which drawing, by how
high text and drawings are.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise, takewhile

from typing_extensions import TypeIs

from kinegrade.figure.scene import Scene
from kinegrade.language.catalogue import Catalogue
from kinegrade.press.sheet import PaperSize, WorkedQuestion
from kinegrade.press.solutions.chains import Chain, Placed, chain_blocks, join_sentences
from kinegrade.press.solutions.settings import Column, Setting, add_heights, fits
from kinegrade.worked.document import Heading, Pictures, Prose

GAP = 6.0  # millimetres between a drawing and what stands beside it
CAPTION_WIDTH = 42.0  # millimetres that a caption has at least
_PAPER_WIDTH: dict[PaperSize, float] = {"a4": 210.0, "letter": 215.9}
_CAPTION = 9.5  # millimetres that a caption takes with its distance
_AROUND = 4.0  # millimetres above and below a row with drawings
_NARROWEST = 72.0  # millimetres that text beside drawings has at least
_WORTH_IT = 0.75  # of the height below, which blocks beside a drawing may add at most


@dataclass(frozen=True)
class Drawing:
    """A picture with its caption, or the question's figure, which has none."""

    scene: Scene
    caption: str | None

    @property
    def width(self) -> float:
        """Millimetres that the drawing takes with its caption."""
        return self.scene.width if self.caption is None else max(self.scene.width, CAPTION_WIDTH)

    @property
    def height(self) -> float:
        """Millimetres that the drawing takes with its caption."""
        return self.scene.height + (0.0 if self.caption is None else _CAPTION)


@dataclass(frozen=True)
class DrawingRow:
    """Drawings side by side at the right edge with text to their left, or alone in the middle."""

    drawings: tuple[Drawing, ...]
    beside: tuple[Setting, ...]

    @property
    def width(self) -> float:
        """Millimetres that the drawings take."""
        return sum(one.width for one in self.drawings) + GAP * (len(self.drawings) - 1)

    @property
    def height(self) -> float:
        """Millimetres that the row takes of the page."""
        drawn = max(one.height for one in self.drawings)
        return max(drawn, add_heights(self.beside)) + _AROUND


Part = Setting | DrawingRow


@dataclass(frozen=True)
class _Passage:
    """Rows of drawings, and how many of the chains that follow stand beside them."""

    rows: tuple[DrawingRow, ...]
    taken: int


def make_column(size: PaperSize, margin: float, words: Catalogue) -> Column:
    """The text of a page in a language, with margins of so many millimetres on both sides."""
    return Column(_PAPER_WIDTH[size] - 2 * margin, words.raw("language", "page.")["script"])


def arrange_course(question: WorkedQuestion, page: Column) -> tuple[Part, ...]:
    """The parts of a question's solution: its statement beside its figure, then all else."""
    statement = (Placed(Prose(question.statement), stays=False),)
    items = (statement, *chain_blocks(tuple(join_sentences(question.blocks))))
    if question.figure is None:
        return tuple(_arrange(items, page))
    chains = [item for item in takewhile(_is_text, items) if _is_text(item)]
    leading = _arrange_passage((Drawing(question.figure, None),), chains, page)
    return (*leading.rows, *_arrange(items[leading.taken :], page))


def _is_text(item: Chain | Pictures) -> TypeIs[Chain]:
    return not isinstance(item, Pictures)


def _arrange(items: Sequence[Chain | Pictures], page: Column) -> Iterator[Part]:
    place = 0
    heading: Chain = ()  # what stays with the drawings that follow
    while place < len(items):
        item = items[place]
        place += 1
        if _is_text(item):
            heading = item if item[-1].stays else ()
            yield from page.set_chain(item if not heading else ())
            continue
        drawings = tuple(Drawing(each.scene, each.caption) for each in item.pictures)
        chains = tuple(_take_section(items[place:]))
        passage = _arrange_passage(drawings, _prepend(heading, chains), page)
        if not passage.taken:
            yield from page.set_chain(heading)
        yield from passage.rows
        place += passage.taken
        heading = ()
    yield from page.set_chain(heading)


def _prepend(heading: Chain, chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """The chains, the heading at the beginning of the first."""
    return ((*heading, *chains[0]), *chains[1:]) if chains else ()


def _take_section(items: Iterable[Chain | Pictures]) -> Iterator[Chain]:
    """The chains that may stand beside drawings before them: up to the next chapter or drawings."""
    for item in items:
        if not _is_text(item) or _begins_chapter(item):
            return
        yield item


def _begins_chapter(chain: Chain) -> bool:
    first = chain[0].block
    return isinstance(first, Heading) and first.level == 1


def _arrange_passage(
    drawings: tuple[Drawing, ...], chains: Sequence[Chain], page: Column
) -> _Passage:
    """Drawings one by one or side by side with text beside them, or without, whichever takes least
    of the page.
    """
    choices = [_fill(rows, chains, page) for rows in _list_rows(drawings, page)]
    most = max(choice.taken for choice in choices)

    def find_height(choice: _Passage) -> float:
        rest = (page.set_chain(chain) for chain in chains[choice.taken : most])
        return sum(row.height for row in choice.rows) + sum(map(add_heights, rest))

    return min(choices, key=find_height)


def _list_rows(
    drawings: tuple[Drawing, ...], page: Column
) -> Iterator[tuple[tuple[Drawing, ...], ...]]:
    """The ways of setting drawings in rows that are not too wide."""
    count = len(drawings)
    for cuts in range(2 ** (count - 1)):
        ends = [0, *(place for place in range(1, count) if cuts >> (place - 1) & 1), count]
        rows = tuple(drawings[begin:end] for begin, end in pairwise(ends))
        if len(rows) == count or all(DrawingRow(row, ()).width <= page.width for row in rows):
            yield rows


def _fill(rows: tuple[tuple[Drawing, ...], ...], chains: Sequence[Chain], page: Column) -> _Passage:
    """Each row with the next chains beside it, as long as that takes less of the page than to set
    them below.
    """
    taken, filled = 0, []
    for drawings in rows:
        row = DrawingRow(drawings, ())
        column = replace(page, width=page.width - row.width - GAP)
        while taken < len(chains) and column.width >= _NARROWEST:
            settings = column.set_chain(chains[taken])
            if not all(map(fits, settings)):
                break
            longer = replace(row, beside=(*row.beside, *settings))
            below = add_heights(page.set_chain(chains[taken]))
            if longer.height - row.height > _WORTH_IT * below:
                break
            row = longer
            taken += 1
        filled.append(row)
    return _Passage(tuple(filled), taken)
