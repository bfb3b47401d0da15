"""The finite domains that parameters are drawn from: lists of values, and ranges with a step."""

from __future__ import annotations

import re
from typing import Any

from flint import fmpq

from kinegrade.errors import ExpressionError
from kinegrade.exact.text import decimal_text
from kinegrade.expression import rational, read

MAX_CHOICES = 2000
RANGE = re.compile(r"\s*(-?[\d.]+)\s*\.\.\s*(-?[\d.]+)\s+step\s+([\d.]+)\s*", re.ASCII)


def read_choices(draw: Any) -> tuple[str, ...]:
    """The drawable values as exact texts, in order, each once.

    `draw` is a list of numbers and expressions, or "0.1 .. 0.5 step 0.05". Raises ExpressionError.

    >>> read_choices("15 .. 60 step 15")
    ('15', '30', '45', '60')
    """
    if isinstance(draw, list):
        texts = [str(value) for value in draw]
        for text in texts:
            read(text)
    else:
        texts = read_range(str(draw))
    if not texts or len(texts) > MAX_CHOICES or len(set(texts)) != len(texts):
        raise ExpressionError(f"draw: expected 1 to {MAX_CHOICES} values, each once")
    return tuple(texts)


def read_range(text: str) -> list[str]:
    """The values of "first .. last step s"."""
    match = RANGE.fullmatch(text)
    if match is None:
        raise ExpressionError(f'draw: "{text}": expected a list, or a range like "0.1 .. 0.5 step 0.05"')
    first, last, step = (signed(part) for part in match.groups())
    if step <= 0 or last < first or (last - first) / step > MAX_CHOICES:
        raise ExpressionError(f'draw: "{text}": the step must be positive, the last value not before the first, '
                              f"and there may be at most {MAX_CHOICES} values")
    count = int(((last - first) / step).floor()) + 1
    return [decimal_text(first + step * index, 30) for index in range(count)]


def signed(text: str) -> Any:
    """A decimal with its sign."""
    if text.count(".") > 1 or text.strip("-.") == "":
        raise ExpressionError(f'draw: "{text}" is not a number')
    return -rational(text[1:]) if text.startswith("-") else fmpq(1) * rational(text)
