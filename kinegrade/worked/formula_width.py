"""The approximate printed width of a LaTeX formula, in letters: accurate enough to decide what
fits on a line of a display.

>>> round(width(r"\\frac{a + b}{2}")), round(width(r"x_{A}"), 1)
(4, 1.7)
"""

from __future__ import annotations

import re
from collections.abc import Iterator

TOKEN = re.compile(r"\\[A-Za-z]+|\\.|\S")
SILENT = frozenset(
    {r"\left", r"\right", r"\mathrm", r"\boldsymbol", r"\overrightarrow", r"\text", r"\!", "&"}
)
WIDTHS = {
    r"\,": 0.3,
    r"\ ": 0.5,
    r"\quad": 2.0,
    r"\qquad": 4.0,
    **dict.fromkeys("+-=<>", 1.9),
    r"\approx": 1.9,
    **{
        rf"\{name}": len(name) + 0.5 for name in ("sin", "cos", "tan", "arcsin", "arccos", "arctan")
    },
}
WIDEST = 68  # letters that fit on a line of a display
SMALL = 0.7  # of a subscript relative to the letter that carries it


def width(latex: str) -> float:
    """The width of a formula in letters of its body."""
    return group(iter(TOKEN.findall(latex)))


def group(tokens: Iterator[str]) -> float:
    """The width of everything up to the closing brace."""
    total = 0.0
    for token in tokens:
        if token == "}":
            break
        total += one(token, tokens)
    return total


def one(token: str, tokens: Iterator[str]) -> float:
    """The width of one token with its arguments."""
    if token == "{":
        return group(tokens)
    if token in "^_":
        return SMALL * following(tokens)
    if token == r"\frac":
        return max(following(tokens), following(tokens)) + 0.5
    if token == r"\sqrt":
        return 1 + following(tokens)
    if token in SILENT:
        return 0.0
    return WIDTHS.get(token, 1.0)


def following(tokens: Iterator[str]) -> float:
    """The width of the argument that comes next."""
    token = next(tokens, "}")
    return 0.0 if token == "}" else one(token, tokens)


def chained(left: str, parts: tuple[tuple[str, str], ...]) -> tuple[str, ...]:
    """left = first = second ..., continued on further lines where one is too short; aligned at the
    first sign.
    """
    lines, room = [left + " &"], WIDEST - width(left)
    used = 0.0
    for sign, text in parts:
        if used and used + width(text) + 2 > room:
            lines.append("&")
            used = 0.0
        lines[-1] += (" " if used else "") + f"{sign} {text}"
        used += width(text) + 2
    return tuple(lines)
