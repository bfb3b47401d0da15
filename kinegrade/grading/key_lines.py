"""Single lines of key.jsonl, found by student: for what is wanted of some papers only, or of one at
a time.

Students who are not there any more may still have given a pool its variants: their lines are those
of variants.jsonl.

`exam_record` and `givens` use it; a class of any size needs memory for one paper, and a number for
each of the others.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import msgspec

from kinegrade.answer_file import POOL


class _Head(msgspec.Struct, gc=False):
    student: str


class KeyLines:
    """The lines of one key.jsonl, each read when it is wanted."""

    def __init__(self, path: Path) -> None:
        """Finds where the line of each student begins. Raises OSError, and ValueError where a line
        is none.
        """
        self._places: dict[str, tuple[Path, int]] = {}
        self._find(path)
        if (pool := path.with_name(POOL)).exists():
            self._find(pool)

    def _find(self, path: Path) -> None:
        decode = msgspec.json.Decoder(_Head).decode
        with path.open("rb") as stream:
            place = 0
            for line in stream:
                if line.strip():
                    self._places.setdefault(decode(line).student, (path, place))
                place += len(line)

    def __contains__(self, student: str) -> bool:
        return student in self._places

    def paper(self, student: str, number: Callable[[str], Any] = float) -> Any:
        """The JSON on a student's line; `number` makes one of the digits of a decimal. Raises
        KeyError, ValueError.
        """
        path, place = self._places[student]
        with path.open("rb") as stream:
            stream.seek(place)
            return json.loads(stream.readline(), parse_float=number)

    @property
    def first(self) -> str:
        """The student of the first line. Raises StopIteration where there is none."""
        return next(iter(self._places))
