"""A document around prose, for pandoc: headings, pictures, styles and tables as values of its JSON
form.

Attributes are a style for Word and a class for HTML.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from typing import Any, Literal

from kinegrade.language.prose.pandoc_tree import Node, make_text

Alignment = Literal["Default", "Right", "Center"]  # default: as the style of the cell has it
_VERSION = [1, 23, 1]  # of the form, as pandoc 3 has it


def make_document(blocks: Iterable[Node]) -> bytes:
    """A whole document, to be handed to pandoc as `json`."""
    return json.dumps({"pandoc-api-version": _VERSION, "meta": {}, "blocks": list(blocks)}).encode()


def make_image(
    data_uri: str, length: float, description: str, side: Literal["width", "height"] = "width"
) -> Node:
    """A picture with its bytes in the address; one of its sides is so many millimetres long."""
    return {
        "t": "Image",
        "c": [["", [], [[side, f"{length:.2f}mm"]]], [make_text(description)], [data_uri, ""]],
    }


def make_heading(level: int, inlines: Sequence[Node]) -> Node:
    """A heading; 1 is the highest."""
    return {"t": "Header", "c": [level, ["", [], []], list(inlines)]}


def make_styled(name: str, blocks: Sequence[Node]) -> Node:
    """Blocks in a style: "Answer box" is Word's style of that name and the HTML class
    "answer-box".
    """
    return {
        "t": "Div",
        "c": [["", [name.lower().replace(" ", "-")], [["custom-style", name]]], list(blocks)],
    }


def make_table(
    name: str,
    widths: Sequence[float],
    alignments: Sequence[Alignment],
    head: Sequence[Node],
    rows: Sequence[Sequence[Node]],
    *,
    row_heads: int = 0,
) -> Node:
    """A table whose columns have these parts of the page's width; a cell is one block, those of
    `head` say what is below them, the first `row_heads` of a row what is beside them.
    """
    columns = [
        [{"t": f"Align{side}"}, {"t": "ColWidth", "c": width}]
        for side, width in zip(alignments, widths, strict=True)
    ]
    body = [_make_attributes(), row_heads, [], [_make_row(row) for row in rows]]
    return {
        "t": "Table",
        "c": [
            ["", [name], []],
            [None, []],
            columns,
            [_make_attributes(), [_make_row(head)]],
            [body],
            [_make_attributes(), []],
        ],
    }


def _make_row(cells: Iterable[Node]) -> list[Any]:
    return [
        _make_attributes(),
        [[_make_attributes(), {"t": "AlignDefault"}, 1, 1, [cell]] for cell in cells],
    ]


def _make_attributes() -> list[Any]:
    """No identifier, no class, no further attribute."""
    return ["", [], []]
