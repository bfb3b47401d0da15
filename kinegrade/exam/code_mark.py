"""The QR code of a paper's code, as rows of dark modules: any typesetter can draw it.

It stands on every page, so that a scanned loose page tells whose it is.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import groupby

import segno

# Any of the eight patterns that the standard lays over the modules is read alike; trying all of them to choose the
# fairest would take five times as long.
PATTERN = 3


@dataclass(frozen=True)
class Run:
    """Dark modules side by side, from column `x` of row `y` on; counted from the top left corner."""

    x: int
    y: int
    length: int


@dataclass(frozen=True)
class CodeMark:
    """A square of `size` modules a side, of which `runs` are dark; leave four modules of white around it."""

    size: int
    runs: tuple[Run, ...]


def code_mark(code: str) -> CodeMark:
    """The QR code of a paper's code; one of the usual nine characters makes 21 modules a side.

    >>> code_mark("F7H0-CV5F").size
    21
    """
    matrix = segno.make(code, error="m", micro=False, mask=PATTERN).matrix
    runs = tuple(run for y, row in enumerate(matrix) for run in _runs(y, row))
    return CodeMark(len(matrix), runs)


def _runs(y: int, row: bytearray) -> list[Run]:
    runs: list[Run] = []
    x = 0
    for dark, modules in groupby(row):
        length = len(list(modules))
        if dark:
            runs.append(Run(x, y, length))
        x += length
    return runs
