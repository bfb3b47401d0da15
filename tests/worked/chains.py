"""Equations of worked solutions taken apart: what stands between the relation signs, as values."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from kinegrade.language.math.reading import read_math
from kinegrade.worked.document import Block
from tests.worked.reader.amounts import Amount, MixedUnits, Unreadable
from tests.worked.reader.formula_reader import read_formula
from tests.worked.telling import displayed

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
    try:
        return read_formula(read_math(part, "test"), _refuse).value
    except (Unreadable, MixedUnits):
        return None


def _refuse(symbol: str) -> Amount:
    raise Unreadable(symbol)


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
