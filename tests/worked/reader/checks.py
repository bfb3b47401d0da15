"""What the checks of a page print is what a reader gets who works their printed numbers out again."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence
from functools import cache
from itertools import pairwise, product

from kinegrade.language.known import known_languages
from kinegrade.language.math.reading import read_math
from kinegrade.language.math.tree import Number, list_nodes
from kinegrade.language.message import Message
from kinegrade.worked.document import Block, Prose, write_sentence
from tests.worked.reader.amounts import Amount, MixedUnits, Unreadable
from tests.worked.reader.equations import Line, Side, read_page
from tests.worked.reader.forms import find_angles, is_decimal, measure_usual_digit
from tests.worked.reader.formula_reader import ROUNDED, find_symbols, read_formula

_SENTENCES = ("solution.check", "solution.check-fewer")
_ANY = "体"  # stands for any words: a Chinese sentence has no space beside it
RELATION = re.compile(r"(=|\\approx)")
_DECIMALS = 2  # of a rounded angle in degrees
_CLOSE = 1e-6  # of the room that a digit leaves


def find_unrepeatable(blocks: Sequence[Block]) -> Iterator[str]:
    """The sides of checks whose printed numbers do not amount to the printed value, to within one
    of the fourth digit.
    """
    for check in _list_checks(blocks):
        yield from (side for side in check if not _is_repeatable(side))


def find_unlettered(blocks: Sequence[Block]) -> Iterator[str]:
    """The sides of checks that begin with numbers, other than 0 alone."""
    for check in _list_checks(blocks):
        for side in check:
            first = RELATION.split(side)[0].strip()
            if first != "0" and not any(find_symbols(read_math(first, "test"))):
                yield side


def find_doubled(blocks: Sequence[Block]) -> Iterator[str]:
    """The sides of checks that print one number twice."""
    for check in _list_checks(blocks):
        for side in check:
            links = [link.strip() for link in RELATION.split(side)[::2]]
            yield from (side for one, other in pairwise(links) if one == other)


def _list_checks(blocks: Sequence[Block]) -> Iterator[list[str]]:
    """Both sides of each check."""
    yield from filter(None, map(split_check, blocks))


def split_check(block: Block) -> list[str]:
    """Both sides of a check, each with its letters; none for anything else."""
    if not isinstance(block, Prose):
        return []
    sentences = (_make_pattern(*each) for each in product(known_languages(), _SENTENCES))
    found = next(filter(None, (one.fullmatch(block.text) for one in sentences)), None)
    return list_sides(*found.groups()) if found else []


def list_sides(equation: str, left: str, right: str) -> list[str]:
    """Both sides of a check's equation in letters, each with its numbers."""
    lettered = equation.strip("$").split(" = ")
    worked = [side.strip().strip("$") for side in (left, right)]
    return [
        numbers if letters == RELATION.split(numbers)[0].strip() else f"{letters} = {numbers}"
        for letters, numbers in zip(lettered, worked, strict=True)
    ]


@cache
def _make_pattern(language: str, sentence: str) -> re.Pattern[str]:
    parts = dict.fromkeys(("way", "equation", "left", "right", "digits"), _ANY)
    text = re.escape(write_sentence(Message(sentence, **parts), language))
    way, equation, left, right, *end = text.split(_ANY)
    last = r"\d".join(end)
    return re.compile(rf"{way}.*{equation}(\$[^$]*\$){left}(\$.*\$){right}(\$.*\$){last}")


def _is_repeatable(side: str) -> bool:
    """Whether the last two links of a side are the same, as far as its digits say."""
    *_, formula, relation, value = ["", "", *RELATION.split(side)]
    rows = [read_math(one.strip(), "test") for one in (formula, value)]
    try:
        printed, stated = (read_formula(row, _refuse) for row in rows)
    except (Unreadable, MixedUnits):
        return True  # a letter and its value
    return not _is_missed(printed.value, Side(relation, rows[1]), stated.value)


def is_off(line: Line) -> bool:
    """Whether printed numbers amount to another figure than the one said of them, by more than one
    of its fourth digit.
    """
    sides = (Side("=", line.left), *line.sides)
    for side, stated in pairwise(sides):
        if is_decimal(side.row) or not is_decimal(stated.row):
            continue
        try:
            worked, figure = (read_formula(one.row, _refuse) for one in (side, stated))
        except (Unreadable, MixedUnits):
            continue
        if _is_missed(worked.value, stated, figure.value):
            return True
    return False


def _is_missed(worked: float, stated: Side, figure: float) -> bool:
    """Whether printed numbers are worth another figure than is stated; about 0 nothing is known."""
    if not figure:
        return False
    last = measure_usual_digit(stated.row, figure)
    if stated.relation == "=":
        angle = list(find_angles(stated.row))
        fourth = 10.0 ** (math.floor(math.log10(abs(figure))) - ROUNDED + 1)
        last = math.radians(10.0**-_DECIMALS) if angle else min(last, fourth)
    return abs(worked - figure) > last * (1 + _CLOSE)


def find_short_about(blocks: Sequence[Block]) -> Iterator[str]:
    """The lines, other than those of checks, in which a number of fewer digits than a rounded one
    keeps stands after the sign of about: it is exact, and numbers put in stand for all their digits.
    """
    for block in blocks:
        for part in () if split_check(block) else read_page((block,)):
            if isinstance(part, Line) and any(map(_is_short_about, part.sides)):
                yield part.text


def _is_short_about(side: Side) -> bool:
    if side.relation != r"\approx" or not is_decimal(side.row):
        return False
    nodes = tuple(list_nodes(side.row))
    digits = ".".join(node.digits for node in nodes if isinstance(node, Number))
    if list(find_angles(side.row)):
        return len(digits.partition(".")[2]) < _DECIMALS
    return len(digits.replace(".", "").lstrip("0")) < ROUNDED


def _refuse(symbol: str) -> Amount:
    raise Unreadable(symbol)
