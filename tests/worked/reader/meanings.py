"""What the letters of a page stand for is said before they are used, and is kept to."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from kinegrade.language.math.reading import read_math
from kinegrade.language.math.tree import Letter, Row, Scripts, Sign, list_nodes
from kinegrade.problem.solution import Solution
from kinegrade.worked.case import write_row
from kinegrade.worked.document import Block, Display, Heading, Pictures, Prose, TermTable
from tests.worked.reader.equations import Line, Said, read_page
from tests.worked.reader.forms import is_decimal
from tests.worked.reader.formula_reader import name_symbol
from tests.worked.reader.givens import read_givens
from tests.worked.telling import unbox

# How the languages name the normal and the tangential part of an acceleration
_PARTS = {
    "n": re.compile(r"\(n\)|（n|n and t|n und t|n、t|ormal accel|ormalbeschleun|法向加速度"),
    "t": re.compile(
        r"\(t\)|（t|，t |n and t|n und t|n、t|angential accel|angentialbeschl|切向加速度"
    ),
}
_MEANT = re.compile(r"\$([^$]*)\$( ?[(（])?")  # a formula, and whether its meaning follows
# v_{A} &= ... = -2 m/s (to the left), the letter of a point alone
_ALONG = re.compile(
    r"(?P<kind>[va])_\{[A-Z](?:_\{\w\})?'*\} &.*(?:=|\\approx) (?P<sign>-?)[\d.]+\\,\\unit\{[^}]*\}"
    r"\\quad(?P<way>\\text\{\([^)]*\)\})$"
)
_PART = re.compile(r"\^\{\\mathrm\{([nt])\}\}")


def find_unmarked(blocks: Sequence[Block], solution: Solution) -> Iterator[str]:
    """The first formulas with a normal or tangential part that no words have named, unless an
    answer has this symbol.
    """
    told = {part for ask in solution.template.asks.values() for part in _PART.findall(ask.symbol)}
    for block in blocks:
        match block:
            case Prose(text) | Heading(text, _):
                told.update(part for part, named in _PARTS.items() if named.search(text))
                formulas = [text]
            case Display(lines):
                formulas = list(map(write_row, lines))
            case TermTable(terms):
                formulas = [write_row(term.symbol) for term in terms]
            case Pictures():
                formulas = []
        for formula in formulas:
            missing = {*_PART.findall(formula)} - told
            told |= missing
            yield from (f"{part} in {formula}" for part in sorted(missing))


def find_negative_sizes(blocks: Sequence[Block], solution: Solution) -> Iterator[str]:
    """The letters that a sentence has defined as the magnitudes asked for, and that an equation
    says to be negative.
    """
    sizes = {one.symbol for one in solution.template.asks.values() if one.sign == "magnitude"}
    symbols = {name_symbol(read_math(symbol, "test")) for symbol in sizes}
    texts = [block.text for block in blocks if isinstance(block, Prose)]
    formulas = (one for text in texts for one in _MEANT.findall(text))
    defined = {name_symbol(read_math(formula, "test")) for formula, meant in formulas if meant}
    for part in read_page(blocks):
        match part:
            case Line(left, (*_, last)) if last.row[:1] == (Sign("-"),) and is_decimal(last.row):
                if name_symbol(left) in symbols & defined:
                    yield part.text
            case Line() | Said():
                continue


def find_two_senses(blocks: Sequence[Block]) -> Iterator[str]:
    """The velocities, and accelerations, of points that have one direction beside values of both
    signs: no single sense along that line is positive.
    """
    found: dict[tuple[str, str], str] = {}
    for block in blocks:
        for line in block.lines if isinstance(block, Display) else ():
            told = _ALONG.match(write_row(unbox(line)))
            if told is not None:
                kind, sign, way = told.group("kind", "sign", "way")
                if found.setdefault((kind, way), sign) != sign:
                    yield write_row(line)


def find_unnamed(blocks: Sequence[Block], solution: Solution) -> Iterator[str]:
    """The angular accelerations in equations whose letters no sentence has told before."""
    named = {symbol for symbol, _ in read_givens(solution)}
    for part in read_page(blocks):
        match part:
            case Said(row):
                named.update(_find_changes(row))
            case Line(left, sides):
                rows = (left, *(side.row for side in sides))
                missing = {symbol for row in rows for symbol in _find_changes(row)} - named
                named |= missing
                yield from (f"{symbol} in {part.text}" for symbol in sorted(missing))


def _find_changes(row: Row) -> Iterator[str]:
    """The angular accelerations in a formula."""
    for node in list_nodes(row):
        base = node.base if isinstance(node, Scripts) else node
        if base == Letter("alpha"):
            yield name_symbol((node,))
