"""The finite domains that parameters are drawn from: lists of values, and ranges with a step."""

from __future__ import annotations

import re
from functools import lru_cache
from typing import Any

from flint import arb, fmpq

from kinegrade.errors import FieldError
from kinegrade.expressions.evaluation import evaluate, make_elementary_functions
from kinegrade.expressions.reading import MAX_LENGTH, read_expression, read_rational
from kinegrade.files.fields.values import found
from kinegrade.language.message import Message
from kinegrade.numbers.balls import PRECISIONS, Balls
from kinegrade.numbers.rounded_text import write_decimal

_MAX_CHOICES = 2000
_LARGEST = fmpq(10) ** 100  # what is worked out from such values still fits into doubles
_NUMBER = r"[\d.]+(?:/\d+)?"  # a decimal, or a fraction
_RANGE = re.compile(
    rf"\s*(-?{_NUMBER})\s*\.\.\s*(-?{_NUMBER})\s+step\s+({_NUMBER})"
    r"(?:\s+without\s+([-\d./, ]+))?\s*",
    re.ASCII,
)
_PLACES = 30  # of a decimal; a value that has more is written as a fraction


def read_choices(draw: object) -> tuple[str, ...]:
    """The drawable values as exact texts, in order, each once.

    `draw` is a list of numbers and expressions, or "0.1 .. 0.5 step 0.05", or that without some of
    its values. Raises FieldError, or ExpressionError for an expression that cannot be read.

    >>> read_choices("15 .. 60 step 15 without 30, 45")
    ('15', '60')
    """
    if not isinstance(draw, list):
        return tuple(_read_range(str(draw)))
    texts = [str(value) for value in draw]
    if (
        not texts
        or len(texts) > _MAX_CHOICES
        or len({find_digits(text) for text in texts}) != len(texts)
    ):
        what = Message("template.values", count=len(texts))
        raise FieldError(what, Message("template.values-each-once", most=_MAX_CHOICES))
    return tuple(texts)


def find_digits(text: str) -> str:
    """The value of an expression without names to 30 digits, by which equal ones are found: 1/2 and
    0.5.
    """
    balls = Balls(PRECISIONS[0])
    with balls.context():
        value = evaluate(
            read_expression(text), {"pi": balls.turns(1)}, make_elementary_functions(balls), balls
        )
    if not isinstance(value, arb):
        raise FieldError(found(text), Message("template.a-number"))
    if not abs(value) < _LARGEST:
        raise FieldError(
            found(text), Message("template.number-too-large"), Message("template.another-unit")
        )
    return write_decimal(value, 30)


@lru_cache(maxsize=1024)
def find_doubles(choices: tuple[str, ...]) -> tuple[float, ...]:
    """The values of drawable texts as doubles."""
    return tuple(float(find_digits(choice)) for choice in choices)


def _read_range(text: str) -> list[str]:
    """The values of "first .. last step s without a, b"."""
    match = _RANGE.fullmatch(text) if len(text) <= MAX_LENGTH else None
    if match is None:
        raise FieldError(found(text), Message("template.a-range"))
    first, last, step = (_read_signed(part) for part in match.groups()[:3])
    if step <= 0 or last < first or (last - first) / step > _MAX_CHOICES:
        raise FieldError(found(text), Message("template.range-order", most=_MAX_CHOICES))
    count = int(((last - first) / step).floor()) + 1
    values = [first + step * index for index in range(count)]
    parts = match[4].split(",") if match[4] else []
    left_out = [_read_signed(part.strip()) for part in parts]
    if not set(left_out) < set(values):
        raise FieldError(found(text), Message("template.left-out"))
    return [_write(value) for value in values if value not in left_out]


def _write(value: Any) -> str:
    """A rational as it stands: a decimal if it ends."""
    ends = (value * 10**_PLACES).q == 1
    return write_decimal(value, _PLACES) if ends else f"{value.p}/{value.q}"


def _read_signed(text: str) -> Any:
    """A decimal or a fraction with its sign."""
    number, slash, below = text.partition("/")
    sound = not slash or (below.isdecimal() and int(below) > 0)
    if number.count(".") > 1 or number.strip("-.") == "" or not sound:
        raise FieldError(found(text), Message("template.a-decimal"))
    value = fmpq(1) * read_rational(number.removeprefix("-")) / int(below or "1")
    return -value if text.startswith("-") else value
