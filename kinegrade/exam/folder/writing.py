"""How an exam folder is written: its head and the lines of its key as bytes.

`kinegrade.exam.generating.generate` writes them; `head` and `exact_keys` read them again.
"""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction

import msgspec

from kinegrade.exam.folder.key.lines import KeyLine
from kinegrade.exam.folder.records import ExamHead


def encode_head(head: ExamHead) -> bytes:
    """The bytes of exam.json, laid out for people."""
    table = msgspec.to_builtins(head, enc_hook=_encode_points, builtin_types=(Decimal,))
    for question in table["questions"]:
        if not question["bonus"]:
            del question["bonus"]
        for ask in question["asks"]:
            del ask["question"], ask["bonus"]  # the ask is listed under its question
    return msgspec.json.format(_ENCODER.encode(table), indent=1) + b"\n"


def encode_line(line: KeyLine) -> bytes:
    """The bytes of a line of key.jsonl."""
    return msgspec.json.format(_ENCODER.encode(line), indent=0) + b"\n"


def make_decimal(number: Fraction) -> Decimal:
    """A number of few decimal digits as it is written; whole numbers without a point.

    >>> make_decimal(Fraction(5, 2)), make_decimal(Fraction(3))
    (Decimal('2.5'), Decimal('3'))
    """
    return Decimal(int(number) if number == int(number) else repr(float(number)))


def _encode_points(found: object) -> Decimal:
    """Points, the only fractions of a head."""
    if not isinstance(found, Fraction):
        raise NotImplementedError(type(found))
    return make_decimal(found)


_ENCODER = msgspec.json.Encoder(decimal_format="number")
