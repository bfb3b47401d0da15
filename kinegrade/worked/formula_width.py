"""The approximate printed width of a LaTeX formula, in letters: accurate enough to decide what
fits on a line of a display.

>>> round(measure_width(r"\\frac{a + b}{2}")), round(measure_width(r"x_{A}"), 1)
(4, 1.7)
"""

from __future__ import annotations

import re
from collections.abc import Iterator

_TOKEN = re.compile(r"\\[A-Za-z]+|\\.|\S")
_SILENT = frozenset(
    {r"\left", r"\right", r"\mathrm", r"\boldsymbol", r"\overrightarrow", r"\text", r"\!", "&"}
)
_WIDTHS = {
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
_SMALL = 0.7  # of a subscript relative to the letter that carries it


def measure_width(latex: str) -> float:
    """The width of a formula in letters of its body."""
    return _measure_group(iter(_TOKEN.findall(latex)))


def _measure_group(tokens: Iterator[str]) -> float:
    """The width of everything up to the closing brace."""
    total = 0.0
    for token in tokens:
        if token == "}":
            break
        total += _measure_token(token, tokens)
    return total


def _measure_token(token: str, tokens: Iterator[str]) -> float:
    """The width of one token with its arguments."""
    if token == "{":
        return _measure_group(tokens)
    if token in "^_":
        return _SMALL * _measure_argument(tokens)
    if token == r"\frac":
        return max(_measure_argument(tokens), _measure_argument(tokens)) + 0.5
    if token == r"\sqrt":
        return 1 + _measure_argument(tokens)
    if token in _SILENT:
        return 0.0
    return _WIDTHS.get(token, 1.0)


def _measure_argument(tokens: Iterator[str]) -> float:
    """The width of the argument that comes next."""
    token = next(tokens, "}")
    return 0.0 if token == "}" else _measure_token(token, tokens)


def chain_lines(left: str, parts: tuple[tuple[str, str], ...]) -> tuple[str, ...]:
    """left = first = second ..., continued on further lines where one is too short; aligned at the
    first sign.
    """
    lines, room = [left + " &"], WIDEST - measure_width(left)
    used = 0.0
    for sign, text in parts:
        if used and used + measure_width(text) + 2 > room:
            lines.append("&")
            used = 0.0
        lines[-1] += (" " if used else "") + f"{sign} {text}"
        used += measure_width(text) + 2
    return tuple(lines)
