"""Where a long line of LaTeX math may be broken: before a relation, or before a plus or minus,
outside all brackets.

A press breaks a line only where the page is too narrow for it.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

_RELATIONS = (
    r"= < > \approx \equiv \sim \le \leq \ge \geq \ne \neq \propto \Rightarrow \implies \to"
)
RELATIONS = frozenset(_RELATIONS.split())
_TOKEN = re.compile(r"\\[A-Za-z]+|\\.|\s+|.", re.DOTALL)
_OPENING = frozenset(("{", "(", "[", r"\left", r"\begin"))
_CLOSING = frozenset(("}", ")", "]", r"\right", r"\end"))
_FENCES = frozenset((r"\left", r"\right"))
_SIGNS = frozenset("+-")


@dataclass(frozen=True)
class EquationLine:
    """What is to the left of the alignment mark, and the pieces to its right; both are LaTeX math,
    and either may be empty.
    """

    left: str
    pieces: tuple[str, ...]


def split_equation_line(latex: str) -> EquationLine:
    """The parts of one line of a display.

    >>> split_equation_line(r"v_B &= v_A + (a + b) = 2")
    EquationLine(left='v_B', pieces=('= v_A', '+ (a + b)', '= 2'))
    """
    tokens = [match.group() for match in _TOKEN.finditer(latex)]
    depths = _count_depths(tokens)
    marks = [index for index, token in enumerate(tokens) if token == "&" and depths[index] == 0]
    start = marks[0] + 1 if marks else 0
    starts = [start] + [
        index
        for index in range(start + 1, len(tokens))
        if depths[index] == 0 and _breaks_before(tokens, index, start)
    ]
    ends = [*starts[1:], len(tokens)]
    pieces = ("".join(tokens[begin:end]).strip() for begin, end in zip(starts, ends, strict=True))
    return EquationLine(
        "".join(tokens[: max(start - 1, 0)]).strip(), tuple(piece for piece in pieces if piece)
    )


def _count_depths(tokens: Sequence[str]) -> list[int]:
    """How many brackets are open at each token; a fence's own bracket, as in `\\left(`, is not
    counted again.
    """
    depths, depth = [], 0
    for index, token in enumerate(tokens):
        fenced = index > 0 and tokens[index - 1] in _FENCES
        if token in _CLOSING and not fenced:
            depth = max(depth - 1, 0)
        depths.append(depth)
        if token in _OPENING and not fenced:
            depth += 1
    return depths


def _breaks_before(tokens: Sequence[str], index: int, start: int) -> bool:
    """Whether a relation or a binary sign stands at `index`; the sign of a term stays with its
    term.
    """
    before = "".join(tokens[start:index]).split()
    last = next((token for token in reversed(tokens[start:index]) if not token.isspace()), "")
    if tokens[index] in RELATIONS:
        return bool(before)
    bound = RELATIONS | _SIGNS | {"", ",", "_", "^", r"\pm", r"\mp", r"\cdot", r"\times"}
    return tokens[index] in _SIGNS and last not in bound
