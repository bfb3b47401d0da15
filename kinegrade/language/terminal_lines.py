"""Tables and paragraphs for a terminal, in which a Chinese character is two columns wide."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from itertools import pairwise
from unicodedata import combining, east_asian_width

_CLOSING = "，。；：、）！？"  # begins no line


def align(
    header: Sequence[str], rows: Iterable[Sequence[str]], numbers: Collection[int] = ()
) -> str:
    """Lines with aligned columns; columns whose index is in `numbers` are flush right.

    >>> print(align(("who", "points"), [("Ann", "7"), ("王伟", "12")], numbers=(1,)), end="")
    who   points
    Ann        7
    王伟      12
    """
    lines = [header, *rows]
    widths = [max(map(_measure_width, column)) for column in zip(*lines, strict=True)]
    return "".join(f"{_write_line(line, widths, numbers)}\n" for line in lines)


def _measure_width(text: str) -> int:
    """The number of columns that a text takes.

    >>> _measure_width("a王")
    3
    """
    return sum(
        0 if combining(letter) else 2 if east_asian_width(letter) in "WF" else 1 for letter in text
    )


def cut(text: str, columns: int) -> str:
    """A text cut to a number of columns; an ellipsis stands for what is left out.

    >>> cut("欧阳文清", 6), cut("Ann", 6)
    ('欧阳…', 'Ann')
    """
    if _measure_width(text) <= columns:
        return text
    while _measure_width(text) >= columns:
        text = text[:-1]
    return f"{text}…"


def wrap(text: str, columns: int) -> list[str]:
    """A paragraph in lines of at most so many columns, broken at blanks and between Chinese
    characters; a longer word stands alone.

    >>> wrap("the crank OA turns", 10), wrap("曲柄绕轴转动。", 8)
    (['the crank', 'OA turns'], ['曲柄绕轴', '转动。'])
    """
    lines = [""]
    for piece in _split(text):
        if lines[-1] and _measure_width(f"{lines[-1]}{piece}".rstrip()) > columns:
            lines.append("")
        lines[-1] += piece if lines[-1] else piece.lstrip()
    return [line.rstrip() for line in lines]


def _split(text: str) -> list[str]:
    """The pieces between which a line may end, blanks among them."""
    pieces = [""]
    for before, letter in pairwise(f" {text}"):
        ends = before.isspace() or letter.isspace() or 2 in map(_measure_width, (before, letter))
        if ends and letter not in _CLOSING:
            pieces.append("")
        pieces[-1] += letter
    return pieces


def _write_line(cells: Sequence[str], widths: Sequence[int], numbers: Collection[int]) -> str:
    padded = []
    for index, (cell, wide) in enumerate(zip(cells, widths, strict=True)):
        blanks = " " * (wide - _measure_width(cell))
        padded.append(f"{blanks}{cell}" if index in numbers else f"{cell}{blanks}")
    return "  ".join(padded).rstrip()
