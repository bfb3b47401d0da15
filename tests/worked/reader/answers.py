"""What stands beside the answers in their boxes."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from kinegrade.language.math.reading import read_math
from kinegrade.language.math.tree import Mark, Row, Sign, Space
from kinegrade.problem.solution import Solution
from kinegrade.sign_conventions import ALONG_AXES, SENSES
from kinegrade.worked.case import write_row
from kinegrade.worked.document import Block, Display
from tests.worked.telling import is_box


def find_without_way(blocks: Iterable[Block], solution: Solution) -> Iterator[str]:
    """The boxed velocities, accelerations and rotations of which the question has a sign, not zero,
    without words beside them that say where they point.
    """
    asked = set(_list_directed(solution))
    for block in blocks:
        left: Row = ()
        for line in block.lines if isinstance(block, Display) else ():
            left = line[: line.index(Mark())] if Mark() in line else left
            told = Space("quad") in line
            if any(map(is_box, line)) and not told and _drop_minus(left) in asked:
                yield write_row(line)


def _list_directed(solution: Solution) -> Iterator[str]:
    for name, answer in solution.answers.items():
        ask = solution.template.asks[name]
        directed = ask.sign in (*SENSES, *ALONG_AXES) and ask.unit.time < 0
        if directed and not answer.is_zero:
            yield write_row(read_math(ask.symbol, ""))


def _drop_minus(left: Row) -> str:
    return write_row(left[1:] if left[:1] == (Sign("-"),) else left)
