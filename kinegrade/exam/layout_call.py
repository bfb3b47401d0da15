"""A Typst source as one call of a layout with one string of data, and how its parts are gathered
with all their faults.

As all data is one string, what two sheets share is the same to Typst, which then need not lay it
out again.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable
from typing import Any, TypeVar

from kinegrade.errors import TypesetError
from kinegrade.exam.formula import write_literal

_Item = TypeVar("_Item")
_Value = TypeVar("_Value")
Sheet = dict[str, Any]  # what a layout reads: text, numbers, lists and dictionaries of them


def write_layout_call(layout: str, sheet: Sheet) -> str:
    """Typst source that hands `sheet` to the function of that name in the file of that name.

    >>> print(write_layout_call("paper", {"code": "A"}), end="")
    #import "/paper.typ": paper
    #paper(json(bytes("{\\"code\\": \\"A\\"}")))
    """
    data = write_literal(json.dumps(sheet, ensure_ascii=False, sort_keys=True))
    return f'#import "/{layout}.typ": {layout}\n#{layout}(json(bytes({data})))\n'


def gather(**parts: Callable[[], Any]) -> Sheet:
    """The value of every part; raises one TypesetError with the faults of all of them."""
    return dict(zip(parts, convert_each(lambda part: part(), parts.values()), strict=True))


def convert_each(convert: Callable[[_Item], _Value], items: Iterable[_Item]) -> list[_Value]:
    """Every item converted; raises one TypesetError with the faults of all of them."""
    values: list[_Value] = []
    problems: list[str] = []
    for item in items:
        try:
            values.append(convert(item))
        except TypesetError as error:
            problems += error.problems
    if problems:
        raise TypesetError(*problems)
    return values
