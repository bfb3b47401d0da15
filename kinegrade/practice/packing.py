"""What a page bakes, small: what is alike stands together, because that compresses better, and the
bytes are written in 85 letters. `unpack.js` undoes it.
"""

from __future__ import annotations

import zlib
from base64 import b85encode
from collections import defaultdict
from collections.abc import Sequence
from typing import Any

import msgspec

from kinegrade.practice.document import PracticeSheet
from kinegrade.practice.patterns import Line


def pack(sheet: PracticeSheet, **others: Any) -> str:
    """A sheet and what else its script has to know, as a text without "<"."""
    packed = msgspec.to_builtins(sheet)
    for question, written in zip(sheet.questions, packed["questions"], strict=True):
        texts = [draw.texts for draw in question.draws]
        columns = _transpose(written["draws"])
        columns["texts"] = [[[pattern for pattern, _ in text] for text in each] for each in texts]
        motions = _transpose(columns.pop("motion"))
        written |= {"draws": columns, "motions": motions, "numbers": _sort_numbers(texts)}
    told = msgspec.json.encode({"sheet": packed, **others})
    return b85encode(zlib.compress(told, 9)).decode().replace("<", ",")


def _transpose(rows: Sequence[dict[str, Any] | None]) -> dict[str, list[Any]]:
    """Each field of all rows; of a row that is None, None."""
    names = next((list(row) for row in rows if row), [])
    return {name: [row and row[name] for row in rows] for name in names}


def _sort_numbers(texts: Sequence[Sequence[Sequence[Line]]]) -> dict[int, list[str]]:
    """The numbers of all lines by their pattern, in the order in which lines are read."""
    found: dict[int, list[str]] = defaultdict(list)
    for draw in texts:
        for text in draw:
            for pattern, numbers in text:
                found[pattern].append(numbers)
    return dict(found)
