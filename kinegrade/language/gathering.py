"""All faults of many texts at once: each text is converted, and the faults are raised together."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any, TypeVar

from kinegrade.errors import Problem, TypesetError

_Item = TypeVar("_Item")
_Value = TypeVar("_Value")


def gather(**parts: Callable[[], Any]) -> dict[str, Any]:
    """The value of every part; raises one TypesetError with the faults of all of them."""
    return dict(zip(parts, convert_each(lambda part: part(), parts.values()), strict=True))


def convert_each(convert: Callable[[_Item], _Value], items: Iterable[_Item]) -> list[_Value]:
    """Every item converted; raises one TypesetError with the faults of all of them."""
    values: list[_Value] = []
    faults: list[Problem] = []
    for item in items:
        try:
            values.append(convert(item))
        except TypesetError as error:
            faults += error.faults
    if faults:
        raise TypesetError(*faults)
    return values
