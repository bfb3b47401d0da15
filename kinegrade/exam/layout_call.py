"""A Typst source as one call of a layout with one string of data.

As all data is one string, what two sheets share is the same to Typst, which then need not lay it
out again.
"""

from __future__ import annotations

import json
from typing import Any

from kinegrade.exam.formula import write_literal

Sheet = dict[str, Any]  # what a layout reads: text, numbers, lists and dictionaries of them


def write_layout_call(layout: str, sheet: Sheet) -> str:
    """Typst source that hands `sheet` to the function of that name in the file of that name.

    >>> print(write_layout_call("paper", {"code": "A"}), end="")
    #import "/paper.typ": paper
    #paper(json(bytes("{\\"code\\": \\"A\\"}")))
    """
    data = write_literal(json.dumps(sheet, ensure_ascii=False, sort_keys=True))
    return f'#import "/{layout}.typ": {layout}\n#{layout}(json(bytes({data})))\n'
