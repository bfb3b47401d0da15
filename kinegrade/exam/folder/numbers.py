"""Numbers as they stand in the files of an exam folder: taken from their digits, never through
binary floating point.
"""

from __future__ import annotations

import re
from decimal import Decimal
from fractions import Fraction
from functools import lru_cache

from kinegrade.errors import FieldError
from kinegrade.language.message import Message, Quoted
from kinegrade.numbers.written import NumberError, read_number

MOST_DIGITS = 100
RATIONAL = re.compile(r"-?[0-9]{1,300}(?:/[0-9]{0,299}[1-9][0-9]{0,299})?")
_NUMBER = re.compile(
    rf"-?[0-9]{{1,{MOST_DIGITS}}}(?:\.[0-9]{{1,{MOST_DIGITS}}})?(?:[eE][+-]?[0-9]{{1,2}})?"
)
_LONGEST_SHOWN = 120


def _show(found: object) -> str:
    """What was found as a message shows it: one line, cut where it is long."""
    text = str(found) if isinstance(found, Decimal) else repr(found)
    return text if len(text) <= _LONGEST_SHOWN else f"{text[:_LONGEST_SHOWN]}…"


def require_number(name: str, found: object) -> Fraction:
    """A number, or a text that spells one (a decimal or a plain fraction), exactly.

    Raises FieldError, which gives its name.
    """
    written = isinstance(found, Decimal | str | int) and not isinstance(found, bool)
    exact = _read_exactly(found) if written else None
    if exact is None:
        raise _refuse(name, found, Message("exam.a-number"))
    return exact


def require_double(name: str, found: object) -> float:
    """The same to double precision, rightly rounded, in a third of the time. Raises FieldError."""
    if isinstance(found, str | Decimal) and _NUMBER.fullmatch(str(found)):
        return float(found)
    return float(require_number(name, found))


def require_not_negative(name: str, found: object) -> Fraction:
    """A number of zero or more, exactly. Raises FieldError."""
    exact = require_number(name, found)
    if exact < 0:
        raise _refuse(name, found, Message("exam.zero-or-more"))
    return exact


def _refuse(name: str, found: object, expected: Message) -> FieldError:
    return FieldError(Message("exam.is", name=Quoted(name), found=_show(found)), expected)


@lru_cache(maxsize=4096)  # points and tolerances repeat on every paper
def _read_exactly(found: Decimal | str | int) -> Fraction | None:
    if isinstance(found, str) and not (_NUMBER.fullmatch(found) or RATIONAL.fullmatch(found)):
        return None
    try:
        return read_number(found)
    except NumberError:
        return None
