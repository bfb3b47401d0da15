"""Equations of worked solutions taken apart: what stands between the relation signs, as values."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from kinegrade.worked.document import Block
from tests.worked.latex_value import Unreadable, value_of
from tests.worked.telling import displayed

UNITS = {"": 1.0, "m": 1.0, "cm": 0.01, "mm": 0.001, "rad": 1.0, "m^2": 1.0}
UNIT = re.compile(r"\\,\\unit\{([\w^]+)\}$")
NUMBER = re.compile(r"\d+(?:\.\d+)?")


def chains(blocks: Iterable[Block]) -> Iterator[tuple[str, list[str]]]:
    """(left side, parts) of every equation; lines that begin with the mark of alignment go on the
    line before.
    """
    texts: list[str] = []
    for line in displayed(blocks):
        if line.startswith("&"):
            texts[-1] += " " + line[1:]
        else:
            texts.append(line)
    for text in texts:
        left, _, right = text.partition("&")
        yield (
            left.strip(),
            [part.strip() for part in re.split(r"=|\\approx|\\propto", right) if part.strip()],
        )


def part_value(part: str) -> float | None:
    """The value of a part in SI, angles in radians; None where it has symbols in it."""
    unit = UNIT.search(part)
    name = unit[1] if unit else ""
    try:
        return value_of(UNIT.sub("", part), {}) * UNITS[name]
    except Unreadable:
        return None


def largest(part: str) -> float:
    """The largest number that is written in a part."""
    return max((float(number) for number in NUMBER.findall(part)), default=0.0)


def disagreements(blocks: Iterable[Block]) -> tuple[int, list[str]]:
    """How many parts were compared with the end of their equation, and those that differ by more
    than rounding.
    """
    count, wrong = 0, []
    for left, parts in chains(blocks):
        values = [(part, value) for part in parts if (value := part_value(part)) is not None]
        for part, value in values[:-1]:
            count += 1
            end = values[-1][1]
            room = 0.004 * max(abs(end), min(largest(part), 10.0))
            if abs(value - end) > room * (5 if left.startswith(r"\tan") else 1):
                wrong.append(f"{left} = {' = '.join(parts)}")
    return count, wrong
