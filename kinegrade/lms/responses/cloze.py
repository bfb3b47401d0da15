"""Several answers in one cell, as Moodle writes those of a Cloze question: "part 1: 1.2; part 2:
-5", in any language.

The words are taken from the cells themselves, because they are in the language of the person who
downloaded the file.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

_LONGEST_BEGINNING = 60
_BEGINNING = re.compile(r"([^\d:：;]*[^\W\d][^\d:：;]*\s)1(\s?[:：])")


@dataclass(frozen=True, slots=True)
class Wording:
    """The text before and after the number of a part: "part " and ":", "子问题 " and "："."""

    stem: str
    colon: str

    def mark(self, number: int) -> str:
        """The text that begins a part; all but the first follow "; "."""
        return f"{self.stem}{number}{self.colon}"

    def separator(self, number: int) -> str:
        """The text between a part and the one before it."""
        return f"; {self.mark(number)}"


def wording(cells: Sequence[str]) -> Wording | None:
    """The words with which at least half of these cells begin, as a person may have changed others;
    None where there are none, and the cells have no parts.

    >>> wording(["Teil 1: 3; Teil 2: 4", "Teil 1: ; Teil 2:", "3; 4"])
    Wording(stem='Teil ', colon=':')
    """
    beginnings = Counter(
        found.groups()
        for cell in cells
        if (found := _BEGINNING.match(cell[:_LONGEST_BEGINNING])) is not None
    )
    for words, count in beginnings.most_common(1):
        if 2 * count >= len(cells):
            return Wording(*words)
    return None


def part_count(cells: Sequence[str], words: Wording) -> int:
    """How many parts most of these cells have."""
    counts = Counter(_count(cell, words) for cell in cells)
    return counts.most_common(1)[0][0]


def _count(cell: str, words: Wording) -> int:
    number, place = 1, 0
    while (place := cell.find(words.separator(number + 1), place)) >= 0:
        number += 1
    return number


def parts(cell: str, words: Wording, count: int) -> tuple[str, ...] | None:
    """What was typed into each part, or None where it is unclear that the cell has `count` parts.

    >>> parts("part 1: 1,5; 2; part 2: ; part 3:", Wording("part ", ":"), 3)
    ('1,5; 2', '', '')
    """
    separators = [words.separator(number) for number in range(2, count + 1)]
    if not cell.startswith(words.mark(1)) or any(
        cell.count(separator) != 1 for separator in separators
    ):
        return None
    rest, typed = cell.removeprefix(words.mark(1)), []
    for separator in separators:
        if separator not in rest:
            return None
        before, _, rest = rest.partition(separator)
        typed.append(before)
    # Moodle puts a blank after the half-width colon, none after the full-width one
    blank = "" if words.colon.endswith("：") else " "
    return tuple(part.removeprefix(blank) for part in (*typed, rest))
