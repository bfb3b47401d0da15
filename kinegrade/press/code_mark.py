"""The QR code of a paper's code, as rows of dark modules: any typesetter can draw it.

It is on every page, so that a loose scanned page can be matched to its paper.
"""

from __future__ import annotations

import re
from typing import NamedTuple

import segno
from msgspec import Struct

# Scanners read all eight mask patterns of the standard alike; trying each of them to choose the
# best balanced one would take five times as long.
PATTERN = 3
_DARK = re.compile(rb"\x01+")


class _Run(NamedTuple):
    """Dark modules side by side, from column `x` of row `y` on; counted from the top left
    corner.
    """

    x: int
    y: int
    length: int


class CodeMark(Struct, frozen=True):
    """A square of `size` modules a side, of which `runs` are dark; leave four modules of white
    around it.
    """

    size: int
    runs: tuple[_Run, ...]


def make_code_mark(code: str) -> CodeMark:
    """The QR code of a paper's code; one of the usual nine characters makes 21 modules a side.

    >>> make_code_mark("F7H0-CV5F").size
    21
    """
    matrix = segno.make(code, error="m", micro=False, mask=PATTERN).matrix
    runs = tuple(
        _Run(dark.start(), y, len(dark[0]))
        for y, row in enumerate(matrix)
        for dark in _DARK.finditer(row)
    )
    return CodeMark(len(matrix), runs)
