"""The letters of checks stand for what the page has found with its sign before."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from kinegrade.language.math.reading import read_math
from kinegrade.problem.solution import Solution
from kinegrade.worked.document import Block
from tests.worked.reader.checks import split_check
from tests.worked.reader.equations import Line, read_page
from tests.worked.reader.formula_reader import find_symbols, name_symbol
from tests.worked.reader.givens import read_givens

# The letters whose sign says in which sense something moves: v, a, omega, alpha
_MOVING = re.compile(r"(?:v|a|\\omega|\\alpha)(?:[_^]|$)")

_SIZE = re.compile(r"\\left\|.*?\\right\|")


def find_senseless(blocks: Sequence[Block], solution: Solution) -> Iterator[str]:
    """The sides of checks that take the letter of a velocity, an acceleration or a rotation of
    which the page has given no value with its sign before, but the magnitude at most.
    """
    signed = {symbol for symbol, _ in read_givens(solution)}
    for block in blocks:
        for side in split_check(block):
            first = _SIZE.sub("1", re.split(r"=|\\approx", side)[0].strip())
            letters = find_symbols(read_math(first, "test"))
            missing = {one for one in letters if _MOVING.match(one)} - signed
            yield from (f"{one} in {side}" for one in sorted(missing))
        for part in read_page((block,)):
            if isinstance(part, Line) and part.sides:
                signed.add(name_symbol(part.left))
