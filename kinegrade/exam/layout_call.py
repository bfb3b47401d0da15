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
from kinegrade.exam.formula import literal

Item = TypeVar("Item")
Value = TypeVar("Value")
Sheet = dict[str, Any]  # what a layout reads: text, numbers, lists and dictionaries of them


def layout_call(layout: str, sheet: Sheet) -> str:
    """Typst source that hands `sheet` to the function of that name in the file of that name.

    >>> print(layout_call("paper", {"code": "A"}), end="")
    #import "/paper.typ": paper
    #paper(json(bytes("{\\"code\\": \\"A\\"}")))
    """
    data = literal(json.dumps(sheet, ensure_ascii=False, sort_keys=True))
    return f'#import "/{layout}.typ": {layout}\n#{layout}(json(bytes({data})))\n'


def gathered(**parts: Callable[[], Any]) -> Sheet:
    """The value of every part; raises one TypesetError with the faults of all of them."""
    return dict(zip(parts, each(lambda part: part(), parts.values()), strict=True))


def each(convert: Callable[[Item], Value], items: Iterable[Item]) -> list[Value]:
    """Every item converted; raises one TypesetError with the faults of all of them."""
    values: list[Value] = []
    problems: list[str] = []
    for item in items:
        try:
            values.append(convert(item))
        except TypesetError as error:
            problems += error.problems
    if problems:
        raise TypesetError(*problems)
    return values
