"""Single fields of the JSON files of an exam folder, each with the fault that it may have.

`exam_folder` and `key_line` use them. Numbers are taken from the digits that stand in the files,
never through binary floating point.
"""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from decimal import Decimal
from fractions import Fraction
from functools import lru_cache
from typing import Any, TypeVar

from kinegrade.exact.written import NumberError, written_number

MOST_DIGITS = 100
NUMBER = rf"-?[0-9]{{1,{MOST_DIGITS}}}(?:\.[0-9]{{1,{MOST_DIGITS}}})?(?:[eE][+-]?[0-9]{{1,2}})?"
RATIONAL = re.compile(r"-?[0-9]{1,300}(?:/[0-9]{0,299}[1-9][0-9]{0,299})?")
_NUMBER = re.compile(NUMBER)
_IDENTIFIER = re.compile(r"[^\W\d][\w'\u2032-]{0,79}")
_COLUMNS_OF_GRADES = {"student", "name", "total", "out_of", "percent", "status"}
_KINDS: Mapping[type, str] = {str: "a text", list: "a list", dict: "an object", Decimal: "a number"}
_LONGEST_SHOWN = 120
Item = TypeVar("Item")


class FieldError(Exception):
    """One fault in a file, to become one line of an ExamError."""


def parsed(text: str) -> Any:
    """JSON whose numbers are Decimals, digit by digit as they stand. Raises FieldError."""
    try:
        return json.loads(
            text, parse_float=Decimal, parse_int=Decimal, parse_constant=_refuse_constant
        )
    except (ValueError, ArithmeticError, RecursionError) as fault:
        raise FieldError(f"broken JSON ({fault}) - expected one JSON object") from fault


def _refuse_constant(name: str) -> Any:
    raise ValueError(f"{name} is not a number")


def shown(found: object) -> str:
    """What was found as a message shows it: one line, cut where it is long."""
    text = str(found) if isinstance(found, Decimal) else repr(found)
    return text if len(text) <= _LONGEST_SHOWN else f"{text[:_LONGEST_SHOWN]}…"


def list_of(item: Any, name: str) -> Sequence[Any]:
    """A list, empty where there is none."""
    found = item.get(name) if isinstance(item, dict) else None
    return found if isinstance(found, list) else []


def field(item: Any, name: str, kind: type[Item]) -> Item:
    """A field of that kind. Raises FieldError."""
    found = item.get(name) if isinstance(item, dict) else None
    if not isinstance(found, kind):
        raise FieldError(f'no "{name}" that is {_KINDS[kind]} - expected one')
    return found


def identifier(item: Any, name: str) -> str:
    """The id of a question or an ask. Raises FieldError."""
    found = field(item, name, str)
    if not _IDENTIFIER.fullmatch(found) or found in _COLUMNS_OF_GRADES:
        raise FieldError(
            f'"{name}" is {shown(found)} - expected letters, digits, "_" and "-", and no column of '
            "grades.csv"
        )
    return found


def amount(item: Any, name: str) -> Fraction:
    """A number, or a text that spells one (a decimal or a plain fraction), exactly. Raises
    FieldError.
    """
    found = item.get(name) if isinstance(item, dict) else None
    exact = _exactly(found) if isinstance(found, Decimal | str) else None
    if exact is None:
        raise FieldError(f'"{name}" is {shown(found)} - expected a number')
    return exact


@lru_cache(maxsize=4096)  # points and tolerances repeat on every paper
def _exactly(text: Decimal | str) -> Fraction | None:
    if isinstance(text, str) and not (_NUMBER.fullmatch(text) or RATIONAL.fullmatch(text)):
        return None
    try:
        return written_number(text)
    except NumberError:
        return None


def not_negative(item: Any, name: str) -> Fraction:
    """A number of zero or more, exactly. Raises FieldError."""
    exact = amount(item, name)
    if exact < 0:
        raise FieldError(f'"{name}" is {shown(item[name])} - expected zero or more')
    return exact
