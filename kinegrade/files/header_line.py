"""Which line of a table is its header, where titles stand above it, as in sheets of registrars."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TypeAlias

from kinegrade.files.cell_text import trim

MOST_ABOVE = 40  # lines in which a header is looked for
# Whether the cells of a line are the header
HeaderSign: TypeAlias = Callable[[Sequence[str]], bool]


def find_header(lines: Sequence[Sequence[str]], is_header: HeaderSign) -> int:
    """The place of the first line that is taken for the header; else of the first of the longest,
    as titles are short.

    >>> find_header([["Class of 2026"], ["id", "name"], ["7", "Ann"]], lambda cells: False)
    1
    """
    known = (place for place, cells in enumerate(lines) if is_header(cells))
    longest = max(range(len(lines)), key=lambda place: _measure(lines[place]), default=0)
    return next(known, longest)


def _measure(cells: Sequence[str]) -> int:
    """How many cells there are up to the last filled one."""
    return max((place for place, cell in enumerate(cells, 1) if trim(cell)), default=0)
