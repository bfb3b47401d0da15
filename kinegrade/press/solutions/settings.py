"""How the blocks of a worked solution are set in a column of given width: a heading runs into the
sentence after it, an equation stands on the line of the sentence that announces it where both have
room, and every setting knows about how high it is.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from math import ceil
from typing import assert_never

from kinegrade.language.math.printed_size import measure_printed
from kinegrade.language.math.tree import Mark, Row
from kinegrade.press.solutions.chains import Chain, TextBlock
from kinegrade.press.solutions.equations import Equations, MeasuredDisplay, arrange_equations
from kinegrade.press.solutions.prose_size import measure_formula_height, measure_text
from kinegrade.press.solutions.terms import Band, arrange_terms, find_bands_height
from kinegrade.worked.document import Heading, Prose, TermTable

EM = 3.528  # millimetres: text of 10 points
INDENT = 6.0  # millimetres before an equation
_BOLD = 1.08
_AFTER_HEADING, _AFTER_SENTENCE = 0.8, 1.4  # em
_PITCH = {"latin": 1.27, "chinese": 1.45}  # em from line to line, by script
_LEADING = {"latin": 0.62, "chinese": 0.8}  # em between two lines, of their pitch
_LAST = 0.62  # em of its pitch that the last line does not take
_TALLEST_IN_LINE = 0.7  # of the height of a display is that of the same formula within a text
_GAP = 1.7  # millimetres between two blocks
_REACHING = 1.2  # em: an equation that is higher reaches beyond the line of its sentence
_TALL_ROOM = 1.2  # millimetres more above and below it, as in the layouts
_COMPACT = 2.5  # lines of a compact paragraph, which formulas that are not broken make one more
_LONG_PARAGRAPH, _FIRST_LINES = 17.0, 11.0  # millimetres: of four lines, of two
_KEPT_ROWS = 2  # of equations, that stand on a page before the others go on, on the next
_FOLDS = 1  # of a row beside a drawing: more lines of a fraction are hard to read
_BEFORE_HEADING: dict[int, float] = {1: 2.4, 2: 1.6}


@dataclass(frozen=True)
class Spread:
    """How far apart blocks and lines stand, as shares of the usual room between them."""

    blocks: float
    lines: float


USUAL, TIGHT, LOOSE = Spread(1.0, 1.0), Spread(0.7, 0.85), Spread(1.6, 1.15)
LOOSER = Spread(2.2, 1.25)  # where a loose last page is not half full
DENSE = Spread(0.5, 0.78)  # where nothing else saves a page: lines still apart by a tenth


@dataclass(frozen=True)
class Paragraph:
    """A heading, the sentences that follow on its line, an equation on theirs: any may be missing,
    but not all.
    """

    heading: Heading | None = None
    text: str = ""  # prose
    equation: Row = ()

    @property
    def is_tall(self) -> bool:
        """Whether its equation, set as a display, would reach into the lines above and below."""
        return measure_printed(self.equation).height > _REACHING if self.equation else False


@dataclass(frozen=True)
class EquationGroups:
    """The equations of one display."""

    groups: tuple[Equations, ...]


@dataclass(frozen=True)
class Terms:
    """The table of a vector equation."""

    bands: tuple[Band, ...]


Body = Paragraph | EquationGroups | Terms


@dataclass(frozen=True)
class Setting:
    """What is set, whether it stays on the page of the next, and how many millimetres it takes."""

    body: Body
    stays: bool
    height: float


def add_heights(settings: Iterable[Setting]) -> float:
    """Millimetres that settings take one below another."""
    return sum(setting.height for setting in settings)


def find_beginning(settings: Sequence[Setting]) -> float:
    """Millimetres that settings that stay together take before the page may end: the first lines of
    a long paragraph, or else all of them, but of equations that are the last a few rows.
    """
    first, last = settings[0], settings[-1]
    if isinstance(first.body, Paragraph) and first.height > _LONG_PARAGRAPH:
        return _FIRST_LINES
    match last.body:
        case EquationGroups(groups):
            rows = sum(len(group.rows) for group in groups)
            return add_heights(settings) - last.height * max(0.0, 1 - _KEPT_ROWS / rows)
        case Paragraph() | Terms():
            return add_heights(settings)
        case _:
            assert_never(last.body)


@dataclass(frozen=True)
class Column:
    """A column of text: its width in millimetres, the script of its language, and how far apart
    its blocks and lines stand; and whether equations that are too wide are folded, as they are over
    the full width, so that no letter is made smaller.
    """

    width: float
    script: str
    spread: Spread = USUAL
    folds: bool = True

    def set_chain(self, chain: Chain) -> tuple[Setting, ...]:
        """The settings of blocks that stay together."""
        return _set_chain(self, chain)

    def has_width_for(self, chain: Chain) -> bool:
        """Whether the compact paragraphs of a chain take few lines."""
        prose = (placed.block for placed in chain if isinstance(placed.block, Prose))
        longest = max((measure_text(one.text) for one in prose if one.compact), default=0.0)
        return longest * EM <= _COMPACT * self.width

    def set_each(self, chain: Chain) -> Iterator[Setting]:
        """The settings one by one."""
        usual = Column(self.width, self.script, USUAL, self.folds)
        for body, stays in _join_chain(usual, chain):
            yield Setting(body, stays, self._estimate_height(body))

    def join_each(self, chain: Chain) -> Iterator[tuple[Body, bool]]:
        """What is set, piece by piece, and whether it stays, however far apart it is."""
        place = 0
        while place < len(chain):
            body, taken = self._join([placed.block for placed in chain[place : place + 3]])
            place += taken
            yield body, chain[place - 1].stays

    def _join(self, blocks: Sequence[TextBlock]) -> tuple[Body, int]:
        """What the first of some blocks becomes, and how many of them it holds."""
        first, *others = blocks
        match first:
            case Heading():
                if others and isinstance(others[0], Prose):
                    paragraph = Paragraph(first, others[0].text)
                    return self._announce(paragraph, others[1:], 2)
                return self._announce(Paragraph(first), others, 1)
            case Prose(text):
                return self._announce(Paragraph(None, text), others, 1)
            case MeasuredDisplay():
                return EquationGroups(self._arrange(first)), 1
            case TermTable():
                return Terms(arrange_terms(first, self.width - INDENT)), 1
            case _:
                assert_never(first)

    def _announce(
        self, paragraph: Paragraph, others: Sequence[TextBlock], held: int
    ) -> tuple[Paragraph, int]:
        """The paragraph with the equation that follows, where that has room on the same line."""
        display = next(iter(others), None)
        if not isinstance(display, MeasuredDisplay):
            return paragraph, held
        room = self.width / EM - _measure_paragraph(paragraph) - _AFTER_SENTENCE
        groups = self._arrange(display)
        if [len(group.rows) for group in groups] != [1] or groups[0].width > room:
            return paragraph, held
        row = tuple(node for node in groups[0].rows[0] if node != Mark())
        return replace(paragraph, equation=row), held + 1

    def _arrange(self, display: MeasuredDisplay) -> tuple[Equations, ...]:
        return arrange_equations(display, (self.width - INDENT) / EM, folds=self.folds)

    def _estimate_height(self, body: Body) -> float:
        gap = _GAP * self.spread.blocks
        match body:
            case Paragraph():
                return self._estimate_paragraph(body) + gap
            case EquationGroups(groups):
                return sum(group.height * EM + gap for group in groups)
            case Terms(bands):
                return find_bands_height(bands, min((1 + self.spread.blocks) / 2, 1.0)) + gap
            case _:
                assert_never(body)

    def _estimate_paragraph(self, paragraph: Paragraph) -> float:
        """How high a paragraph is, with the room over its heading."""
        room = _BEFORE_HEADING[paragraph.heading.level] if paragraph.heading else 0.0
        above = room * self.spread.blocks
        tall = max(
            measure_formula_height(paragraph.text),
            measure_printed(paragraph.equation).height if paragraph.equation else 0.0,
        )
        beside = 2 * _TALL_ROOM if paragraph.is_tall else 0.0
        lines = max(1, ceil(_measure_paragraph(paragraph) * EM / self.width))
        higher = max(0.0, _TALLEST_IN_LINE * tall - 1)
        closer = (1 - self.spread.lines) * _LEADING[self.script] * (lines - 1)
        return above + beside + (_PITCH[self.script] * lines - closer - _LAST + higher) * EM


@lru_cache(maxsize=1024)  # each is tried beside one drawing, then another
def _set_chain(column: Column, chain: Chain) -> tuple[Setting, ...]:
    return tuple(column.set_each(chain))


@lru_cache(maxsize=1024)  # as usual, and tighter
def _join_chain(column: Column, chain: Chain) -> tuple[tuple[Body, bool], ...]:
    return tuple(column.join_each(chain))


def fits(setting: Setting) -> bool:
    """Whether a setting has room: each piece of its equations, its table in one band; nothing in it
    is folded into more than two lines.
    """
    body = setting.body
    match body:
        case EquationGroups(groups):
            return all(group.fits and group.folds <= _FOLDS for group in groups)
        case Terms(bands):
            return len(bands) == 1
        case Paragraph():
            return True
        case _:
            assert_never(body)


def _measure_paragraph(paragraph: Paragraph) -> float:
    """About how wide a paragraph is on one line without its equation, in em."""
    head = paragraph.heading
    before = _BOLD * measure_text(head.text) + _AFTER_HEADING if head else 0.0
    return before + measure_text(paragraph.text)
