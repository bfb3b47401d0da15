"""The table at the end of a PDF file that says where its objects are, as Typst writes it."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from itertools import pairwise

from kinegrade.press.binding.values import Dictionary, Reference, read_dictionary

_END = re.compile(rb"startxref\s+(\d+)\s+%%EOF\s*\Z")
_NEAR_END = 64  # bytes within which that stands
_HEAD = re.compile(rb"xref\s+0 (\d+)\s*?\r?\n")
_LINE = 20  # bytes
_USED = b"n"


@dataclass(frozen=True)
class Table:
    """Where each object is, by its number, and what stands behind the table."""

    places: Mapping[int, slice]
    trailer: Dictionary
    root: Reference


def read_table(pdf: bytes) -> Table | None:
    """The table of a file; None where it has another form, or parts elsewhere."""
    end = _END.search(pdf, max(len(pdf) - _NEAR_END, 0))
    head = _HEAD.match(pdf, int(end[1])) if end else None
    if head is None:
        return None
    after = head.end() + _LINE * int(head[1])
    lines = (pdf[start : start + _LINE] for start in range(head.end(), after, _LINE))
    used = [(int(line[:10]), number) for number, line in enumerate(lines) if line[17:18] == _USED]
    steps = pairwise((*sorted(used), (head.start(), 0)))
    places = {number: slice(start, stop) for (start, number), (stop, _) in steps}
    trailer = read_dictionary(pdf[after:].partition(b"trailer")[2])
    root = trailer.get(b"/Root")
    return Table(places, trailer, root) if isinstance(root, Reference) else None
