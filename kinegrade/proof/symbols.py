"""Symbols that two givens share, and letters of the figure that nothing explains."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Set
from itertools import combinations

from kinegrade.errors import TypesetError
from kinegrade.language.math.reading import read_math
from kinegrade.language.math.tree import Letter, Row, Scripts, list_parts
from kinegrade.language.message import Message
from kinegrade.problem.template.template import Template


def note_shared_symbols(template: Template) -> Iterator[Message]:
    """A remark for each two givens that are printed with one symbol."""
    for one, other in combinations(template.parameters.values(), 2):
        if _read(one.symbol) == _read(other.symbol):
            yield Message(
                "template.shared-symbol", name=one.name, other=other.name, symbol=one.symbol
            )


def note_unexplained_letters(template: Template, formulas: Iterable[str]) -> Iterator[Message]:
    """A remark for each mark of the figure with a letter that is no symbol of a given or of an ask,
    and is in none of the statement's formulas.
    """
    known = {_read(given.symbol) for given in template.parameters.values()}
    known |= {_read(ask.symbol) for ask in template.asks.values()}
    known |= {(node,) for formula in formulas for node in _read(formula)}
    figure = template.figure
    marks = (*figure.lengths, *figure.angles, *figure.radii, *figure.arrows)
    for symbol in dict.fromkeys(mark.symbol for mark in marks):
        if not _is_explained(_read(symbol), known):
            yield Message("template.unexplained-letter", symbol=symbol)


def _read(symbol: str) -> Row:
    """A formula as a row; an empty one where it cannot be read, which is said elsewhere."""
    try:
        return read_math(symbol, "figure")
    except TypesetError:
        return ()


def _is_explained(row: Row, known: Set[Row]) -> bool:
    """Whether a formula consists of known ones, numbers and signs."""
    if not row or row in known:
        return True
    end = next((end for end in range(len(row), 0, -1) if row[:end] in known), 0)
    if end:
        return _is_explained(row[end:], known)
    first, *others = row
    if isinstance(first, Letter) or (isinstance(first, Scripts) and first.lower is not None):
        return False
    return all(_is_explained(part, known) for part in (*list_parts(first), tuple(others)))
