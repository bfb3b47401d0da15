"""What the checks of a page print is what a reader gets who works their printed numbers out again."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence
from functools import cache
from itertools import pairwise

from kinegrade.language.known import known_languages
from kinegrade.language.math.reading import read_math
from kinegrade.language.message import Message
from kinegrade.worked.document import Block, Prose, write_sentence
from tests.worked.reader.amounts import Amount, MixedUnits, Unreadable
from tests.worked.reader.equations import Line, Side
from tests.worked.reader.forms import is_decimal, measure_last_digit
from tests.worked.reader.formula_reader import find_symbols, read_formula

_ANY = "体"  # stands for any words: a Chinese sentence has no space beside it
_RELATION = re.compile(r"(=|\\approx)")
_CLOSE = 1e-9  # relative


def find_unrepeatable(blocks: Sequence[Block]) -> Iterator[str]:
    """The sides of checks whose printed numbers do not amount to the printed value, exactly after a
    sign of equality, else to within one of the last digit.
    """
    for check in _list_checks(blocks):
        yield from (side for side in check if not _is_repeatable(side))


def find_unlettered(blocks: Sequence[Block]) -> Iterator[str]:
    """The sides of checks that begin with numbers, other than 0 alone."""
    for check in _list_checks(blocks):
        for side in check:
            first = _RELATION.split(side)[0].strip()
            if first != "0" and not any(find_symbols(read_math(first, "test"))):
                yield side


def find_doubled(blocks: Sequence[Block]) -> Iterator[str]:
    """The sides of checks that print one number twice."""
    for check in _list_checks(blocks):
        for side in check:
            links = [link.strip() for link in _RELATION.split(side)[::2]]
            yield from (side for one, other in pairwise(links) if one == other)


def _list_checks(blocks: Sequence[Block]) -> Iterator[list[str]]:
    """Both sides of each check."""
    yield from filter(None, map(split_check, blocks))


def split_check(block: Block) -> list[str]:
    """Both sides of a check; none for anything else."""
    if not isinstance(block, Prose):
        return []
    sentences = map(_make_pattern, known_languages())
    found = next(filter(None, (one.fullmatch(block.text) for one in sentences)), None)
    return [side.strip().strip("$") for side in found.groups()] if found else []


@cache
def _make_pattern(language: str) -> re.Pattern[str]:
    message = Message("solution.check", way=_ANY, left=_ANY, right=_ANY)
    way, left, right, end = re.escape(write_sentence(message, language)).split(_ANY)
    return re.compile(rf"{way}.*{left}(\$.*\$){right}(\$.*\$){end}")


def _is_repeatable(side: str) -> bool:
    """Whether the last two links of a side are the same, as far as its digits say."""
    *_, formula, relation, value = ["", "", *_RELATION.split(side)]
    rows = [read_math(one.strip(), "test") for one in (formula, value)]
    try:
        printed, stated = (read_formula(row, _refuse) for row in rows)
    except (Unreadable, MixedUnits):
        return True  # a letter and its value
    away = abs(printed.value - stated.value)
    if relation == "=":
        return away <= _CLOSE * max(abs(printed.value), 1e-3)
    return not stated.value or away <= measure_last_digit(rows[1], stated.value) * (1 + 1e-6)


def is_off(line: Line) -> bool:
    """Whether printed numbers amount to another figure than the rounded one said of them, by more
    than one of its last digit.
    """
    sides = (Side("=", line.left), *line.sides)
    for side, stated in pairwise(sides):
        if is_decimal(side.row) or not is_decimal(stated.row) or stated.relation == "=":
            continue
        try:
            worked, figure = (read_formula(one.row, _refuse) for one in (side, stated))
        except (Unreadable, MixedUnits):
            continue
        last = measure_last_digit(stated.row, figure.value) if figure.value else math.inf
        if abs(worked.value - figure.value) > last * (1 + 1e-6):
            return True
    return False


def is_unequal(line: Line) -> bool:
    """Whether a sign of equality joins numbers that do not amount to the same as they are printed:
    2.419 sin 7.125 degrees is 0.30004, not 0.3.
    """
    for side, stated in pairwise((Side("=", line.left), *line.sides)):
        if stated.relation != "=":
            continue
        try:
            worked, figure = (read_formula(one.row, _refuse) for one in (side, stated))
        except (Unreadable, MixedUnits):
            continue
        if abs(worked.value - figure.value) > _CLOSE * max(abs(worked.value), 1e-3):
            return True
    return False


def _refuse(symbol: str) -> Amount:
    raise Unreadable(symbol)
