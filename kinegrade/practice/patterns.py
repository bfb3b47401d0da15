"""Texts that differ from draw to draw in their numbers alone, kept as the pattern that they share
and the numbers of each.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

_NUMBER = re.compile(r"[0-9]+(?:[.,][0-9]+)?")
Skeleton = tuple[str, ...]
Numbers = tuple[str, ...]
Pattern = tuple[str | int, ...]


Line = tuple[int, str]  # the place of its pattern, and the numbers that fill it, between blanks


@dataclass(frozen=True)
class Pooled:
    """`patterns` are lines in pieces: what all their uses have in common, and the places of numbers
    among those of a use. `draws` has the lines of each text of each draw.
    """

    patterns: tuple[Pattern, ...]
    draws: tuple[tuple[tuple[Line, ...], ...], ...]


def pool_texts(draws: Sequence[Sequence[str]]) -> Pooled:
    """The texts of several draws, any number for each.

    >>> pooled = pool_texts([["r = 2 m, s = 2 m"], ["r = 3 m, s = 3 m"]])
    >>> pooled.patterns
    (('r = ', 0, ' m, s = ', 0, ' m'),)
    >>> pooled.draws
    ((((0, '2'),),), (((0, '3'),),))
    """
    uses: dict[Skeleton, list[Numbers]] = {}

    def take_lines(text: str) -> list[tuple[Skeleton, int]]:
        return [_take_apart(line, uses) for line in text.splitlines(keepends=True)]

    skeletons = [list(map(take_lines, texts)) for texts in draws]
    made = {skeleton: _make_pattern(skeleton, numbers) for skeleton, numbers in uses.items()}
    order = {skeleton: place for place, skeleton in enumerate(made)}

    def place_line(part: tuple[Skeleton, int]) -> Line:
        skeleton, number = part
        return order[skeleton], made[skeleton][1][number]

    return Pooled(
        tuple(pattern for pattern, _ in made.values()),
        tuple(tuple(tuple(map(place_line, lines)) for lines in texts) for texts in skeletons),
    )


def _take_apart(line: str, uses: dict[Skeleton, list[Numbers]]) -> tuple[Skeleton, int]:
    """What stands between the numbers of a line, and which of the uses of that this is."""
    skeleton = tuple(_NUMBER.split(line))
    same = uses.setdefault(skeleton, [])
    same.append(tuple(_NUMBER.findall(line)))
    return skeleton, len(same) - 1


def _make_pattern(skeleton: Skeleton, uses: Sequence[Numbers]) -> tuple[Pattern, Numbers]:
    """A pattern and the numbers of its uses: those that are equal in all uses stand in the pattern,
    and places that are always filled alike share a number.
    """
    columns = list(zip(*uses, strict=True))
    varied = dict.fromkeys(column for column in columns if len(set(column)) > 1)
    numbered = {column: place for place, column in enumerate(varied)}
    pieces: list[str | int] = [skeleton[0]]
    for column, text in zip(columns, skeleton[1:], strict=True):
        pieces += [numbered.get(column, column[0]), text]
    rows = zip(*varied, strict=True) if varied else [()] * len(uses)
    return _join_texts(pieces), tuple(" ".join(row) for row in rows)


def _join_texts(pieces: Sequence[str | int]) -> Pattern:
    """The pieces with neighbouring texts made one."""
    joined: list[str | int] = []
    for piece in pieces:
        last = joined[-1] if joined else None
        if isinstance(piece, str) and isinstance(last, str):
            joined[-1] = last + piece
        else:
            joined.append(piece)
    return tuple(joined)
