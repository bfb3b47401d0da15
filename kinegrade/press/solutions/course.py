"""The course of a worked solution on the page: what stands beside which drawing, by how
high text and drawings are.
"""

from __future__ import annotations

from collections.abc import Generator, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import assert_never

from kinegrade.press.sheet import WorkedQuestion
from kinegrade.press.solutions.chains import Chain
from kinegrade.press.solutions.content import Drawings, find_content
from kinegrade.press.solutions.drawing_rows import Drawing, DrawingRow
from kinegrade.press.solutions.row_choice import choose_row, measure_passage
from kinegrade.press.solutions.settings import (
    Column,
    Setting,
    add_heights,
    find_beginning,
)
from kinegrade.worked.document import Heading, TermTable

_MASTHEAD, _QUESTION_HEAD = 4.0, 8.0  # millimetres at the top of the first page, of a question


Part = Setting | DrawingRow


@dataclass(frozen=True)
class TextArea:
    """The printed area of a page: its column, its height in millimetres, and whether pages may end
    within what stays together, between rows of equations and lines of long paragraphs.
    """

    column: Column
    height: float
    parts_chains: bool = True


@dataclass(frozen=True)
class Courses:
    """The parts of each question's solution, and about how many pages they fill."""

    parts: tuple[tuple[Part, ...], ...]
    pages: float


def arrange_courses(questions: Iterable[WorkedQuestion], area: TextArea) -> Courses:
    """The courses of the questions, one below another."""
    filling, parts = _Filling(area, _MASTHEAD), []
    for question in questions:
        filling.used += _QUESTION_HEAD
        parts.append(tuple(_arrange(question, filling)))
    return Courses(tuple(parts), filling.pages)


@dataclass
class _Filling:
    """How many millimetres of the page are used as parts are placed, after so many full pages."""

    area: TextArea
    used: float
    full: int = 0

    @property
    def pages(self) -> float:
        """How many pages are filled."""
        return self.full + self.used / self.area.height

    def place(self, parts: Iterable[Part]) -> Iterator[Part]:
        """The parts, each on a new page where it has no room on this one."""
        for part in parts:
            if not self.has_room(part.height):
                self._turn_page()
            self.used += part.height
            yield part

    def _part(self, settings: Sequence[Setting]) -> Iterator[Part]:
        """Settings of which the last goes on, on the next page."""
        self.used += add_heights(settings) - self.area.height
        self.full += 1
        yield from settings

    def place_chain(self, chain: Chain, below: float = 0.0) -> Iterator[Part]:
        """Blocks that stay together over the whole width, with so much of what is `below` them: on
        a new page where not all have room.
        """
        settings = self.area.column.set_chain(chain)
        height = add_heights(settings) + below
        if self.has_room(height):
            return self.place(settings)
        if not below and self.has_room(self._find_beginning(settings)):
            return self._part(settings)
        if height <= self.area.height:
            self._turn_page()
        return self.place(settings)

    def _turn_page(self) -> None:
        self.used = 0.0
        self.full += 1

    def has_room(self, height: float) -> bool:
        """Whether what is that high has room on this page."""
        return self.used + height <= self.area.height

    def begins(self, chain: Chain) -> bool:
        """Whether a chain may begin on this page, and go on, on the next one."""
        return self.has_room(self._find_beginning(self.area.column.set_chain(chain)))

    def _find_beginning(self, settings: Sequence[Setting]) -> float:
        """How high settings that stay together are before a page may end."""
        return (find_beginning if self.area.parts_chains else add_heights)(settings)

    def measure(self, chain: Chain) -> float:
        """How high a chain is over the whole width."""
        return add_heights(self.area.column.set_chain(chain))


def _arrange(question: WorkedQuestion, filling: _Filling) -> Iterator[Part]:
    """The statement beside its figure, both on one page, then all else."""
    content = find_content(question)
    items, figure, place = content.items, content.figure, 0
    if figure is not None:
        chains = list(_take_text(items))
        row, place = choose_row((figure,), chains, filling.area.column)
        yield from filling.place([replace(row, whole=True)])
    heading: Chain = ()  # what stays beside the drawings that follow
    above: Chain = ()  # what stays above them
    while place < len(items):
        item = items[place]
        place += 1
        match item:
            case tuple():
                stays = item[-1].stays
                above = item if stays and isinstance(item[-1].block, TermTable) else ()
                heading = item if stays and not above else ()
                yield from filling.place_chain(item if not stays else ())
            case Drawings(drawings):
                chains = list(_take_section(items[place:]))
                if not chains:
                    yield from filling.place_chain(heading)
                passage = _prepend(heading, chains)
                if above and _saves_room(drawings, above, chains, filling):
                    passage = (above, *chains)
                    place += (yield from _set_passage(drawings, passage, filling, ())) - 1
                else:
                    place += yield from _set_passage(drawings, passage, filling, above)
                heading = above = ()
            case _:
                assert_never(item)
    yield from filling.place_chain(heading)


def _take_text(items: Iterable[Chain | Drawings]) -> Iterator[Chain]:
    """The chains before the next drawings."""
    for item in items:
        match item:
            case tuple():
                yield item
            case Drawings():
                return
            case _:
                assert_never(item)


def _prepend(heading: Chain, chains: Sequence[Chain]) -> tuple[Chain, ...]:
    """The chains, the heading at the beginning of the first."""
    return ((*heading, *chains[0]), *chains[1:]) if chains else ()


def _take_section(items: Iterable[Chain | Drawings]) -> Iterator[Chain]:
    """The chains that may stand beside drawings before them: up to the next chapter, or
    to what stays with the next drawings.
    """
    for chain in _take_text(items):
        if _begins_chapter(chain) or chain[-1].stays:
            return
        yield chain


def _begins_chapter(chain: Chain) -> bool:
    first = chain[0].block
    return isinstance(first, Heading) and first.level == 1


def _set_passage(
    drawings: tuple[Drawing, ...], chains: Sequence[Chain], filling: _Filling, above: Chain
) -> Generator[Part, None, int]:
    """Rows of drawings with text beside them, and how many of the chains are used up; where a row
    has no room on the page, the text goes on above it, except for what ends it. What stands above
    the drawings is on the page on which they or the text begin.
    """
    first, _ = choose_row(drawings, chains, filling.area.column)
    text = map(filling.measure, chains[:1] if len(chains) > 1 else ())
    yield from filling.place_chain(above, min((first.height, *text)) if above else 0.0)
    taken = 0
    while drawings:
        row, beside = choose_row(drawings, chains[taken:], filling.area.column)
        late, more = not filling.has_room(row.height), len(chains) - taken > 1
        if late and more and filling.begins(chains[taken]):
            yield from filling.place_chain(chains[taken])
            taken += 1
            continue
        yield from filling.place([row])
        drawings = drawings[len(row.drawings) :]
        taken += beside
    return taken


def _saves_room(
    drawings: tuple[Drawing, ...], above: Chain, chains: Sequence[Chain], filling: _Filling
) -> bool:
    """Whether a table takes less of the page beside its drawings than above them; beside drawings
    that have no room on the page it would be parted from what is done with it.
    """
    column = filling.area.column
    row, taken = choose_row(drawings, (above, *chains), column)
    if not taken or not filling.has_room(row.height):
        return False
    high = filling.measure(above) + measure_passage(drawings, chains, column)
    return measure_passage(drawings, (above, *chains), column) < high
