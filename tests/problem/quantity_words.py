"""What is said of the functions of quantities beside their rows, for the reference of docs/."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

_ROW = re.compile(
    r'(?P<words>(?:^    #: .+\n)*)^    "(?P<name>\w+)": (?:MotionFunction|Measure)\(', re.M
)


def find_unsaid(room: Path) -> Iterator[str]:
    """The functions of a room of quantities of whose rows nothing is said, a line for each."""
    for file in sorted(room.glob("*.py")):
        for row in _ROW.finditer(file.read_text(encoding="utf-8")):
            if not row["words"]:
                yield f"{file.name}: {row['name']}: nothing is said of it"
