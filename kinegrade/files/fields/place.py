"""Where something stands in a file: a key path such as `questions[2].asks.v_B`, and its line."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

from kinegrade.language.lines import shorten

Place = tuple[str | int, ...]  # keys, and list positions from 0; () is the whole file
_LONGEST_KEY = 80


@dataclass(frozen=True)
class Where:
    """A file, a place in it, and the line of that place, from 1; None where it is unknown."""

    file: str
    place: Place
    line: int | None = None

    def __str__(self) -> str:
        """The place as messages name it.

        >>> str(Where("bank.toml", ("questions", 1, "points"), 9))
        'bank.toml:9: questions[2].points'
        """
        file = self.file if self.line is None else f"{self.file}:{self.line}"
        return f"{file}: {key_path(self.place)}" if self.place else file


class Source(Protocol):
    """Something that knows where a place is: a file, or a file laid over another one."""

    def where(self, place: Place) -> Where:
        """The file and line of a place; for something missing, those of the nearest enclosing
        table.
        """


def key_path(place: Place) -> str:
    """A place as people write it; list positions are counted from 1.

    >>> key_path(("questions", 1, "asks", "v_B"))
    'questions[2].asks.v_B'
    """
    steps = (
        f"[{step + 1}]" if isinstance(step, int) else f".{shorten(step, _LONGEST_KEY)}"
        for step in place
    )
    return "".join(steps).removeprefix(".")
