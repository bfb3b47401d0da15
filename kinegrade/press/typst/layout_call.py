"""A Typst source as one call of a layout with one string of data, and what all layouts have in it.

As all data is one string, what two sheets share is the same to Typst, which then need not lay it
out again.
"""

from __future__ import annotations

import json
from typing import Any

from kinegrade.language.math.units import write_unit
from kinegrade.language.typst_text import write_literal

Sheet = dict[str, Any]  # what a layout reads: text, numbers, lists and dictionaries of them


def write_layout_call(layout: str, sheet: Sheet) -> str:
    """Typst source that hands `sheet` to the function of that name in the file of that name.

    >>> print(write_layout_call("paper", {"code": "A"}), end="")
    #import "/paper.typ": paper
    #paper(json(bytes("{\\"code\\": \\"A\\"}")))
    """
    data = write_literal(json.dumps(sheet, ensure_ascii=False, sort_keys=True))
    return f'#import "/{layout}.typ": {layout}\n#{layout}(json(bytes({data})))\n'


def write_signed(number: str) -> str:
    """A number with a minus sign instead of a hyphen."""
    return number.replace("-", "\u2212")


def write_value(decimal: str, unit: str) -> str:
    """A number with its unit, if it has one.

    >>> write_value("-2", "m/s"), write_value("60", "deg"), write_value("2", "1")
    ('−2\u202fm/s', '60°', '2')
    """
    shown = "" if unit == "1" else write_unit(unit)
    space = "" if shown in ("", "°") else "\u202f"
    return f"{write_signed(decimal)}{space}{shown}"
