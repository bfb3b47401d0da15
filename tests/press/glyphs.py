"""The letters of marked contents of a page, by the tables of its fonts."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

import pikepdf

_ROWS = re.compile(rb"begin(bfchar|bfrange)(.*?)end", re.DOTALL)
_CODES = re.compile(rb"<([0-9A-Fa-f]+)>")


def read_marked_texts(page: pikepdf.Page) -> dict[int, str]:
    """The text of each marked content that belongs to an element, by its number; a new line is a
    space, but after a hyphen.
    """
    tables = {name: _read_table(font) for name, font in page.resources.get("/Font", {}).items()}
    texts: dict[int, str] = {}
    table: Mapping[int, str] = {}
    marks: list[int | None] = []
    height, is_new_line = 0.0, False
    for operands, operator in pikepdf.parse_content_stream(page):
        match str(operator):
            case "BDC" | "BMC":
                marks.append(_find_number(operands))
            case "EMC":
                marks.pop()
            case "Tf":
                table = tables[str(operands[0])]
            case "cm":
                height, before = float(operands[5]), height
                is_new_line = is_new_line or height != before
            case "Tj" | "TJ":
                numbers = [mark for mark in marks if mark is not None]
                if numbers:
                    known = texts.get(numbers[-1], "")
                    apart = " " if is_new_line and not known.endswith("-") else ""
                    texts[numbers[-1]] = known + apart + "".join(_decode(operands[0], table))
                    is_new_line = False
            case _:
                pass
    return texts


def _find_number(operands: pikepdf.Object) -> int | None:
    """The number of a marked content; None of what is not in the structure."""
    properties = operands[1] if len(operands) > 1 else None
    if isinstance(properties, pikepdf.Dictionary) and "/MCID" in properties:
        return int(properties.MCID)
    return None


def _decode(shown: pikepdf.Object, table: Mapping[int, str]) -> Iterator[str]:
    for part in shown if isinstance(shown, pikepdf.Array) else [shown]:
        if isinstance(part, pikepdf.String):
            codes = bytes(part)
            for place in range(0, len(codes), 2):
                yield table.get(int.from_bytes(codes[place : place + 2]), "")


def _read_table(font: pikepdf.Object) -> dict[int, str]:
    """The letters of a font by their codes of two bytes."""
    table: dict[int, str] = {}
    for kind, rows in _ROWS.findall(font.ToUnicode.read_bytes()):
        codes = [bytes.fromhex(code.decode()) for code in _CODES.findall(rows)]
        step = 2 if kind == b"bfchar" else 3
        for place in range(0, len(codes), step):
            first, letters = codes[place], codes[place + step - 1].decode("utf-16-be")
            last = codes[place + step - 2] if kind == b"bfrange" else first
            for code in range(int.from_bytes(first), int.from_bytes(last) + 1):
                further = code - int.from_bytes(first)
                table[code] = letters[:-1] + chr(ord(letters[-1]) + further)
    return table
