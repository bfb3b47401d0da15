"""A PDF file taken apart into its objects, none of which is interpreted but the few that say what
belongs together.

Files are read as Typst writes them, one object after another behind a table of their places. Those
of other programs are brought into that form by pikepdf (qpdf), without what is not printed.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from io import BytesIO

from kinegrade.press.binding.table import Table, read_table
from kinegrade.press.binding.values import (
    STRING,
    Dictionary,
    Reference,
    Value,
    read_dictionary,
    read_value,
)

_LENGTH = re.compile(rb"/Length (\d+)(?! 0 R)")
_STREAM = b"\nstream\n"
_STRING = re.compile(STRING, re.DOTALL)
_OPENING = b"("
_END, _STREAM_ENDS = b"endobj", [b"endstream", b"endobj"]
# What a table says elsewhere, and what keeps a file from strangers
_FURTHER = (b"/Prev", b"/XRefStm", b"/Encrypt")
# Of what a file says of itself, all that a volume takes over, and what else Typst says
_KEPT = (b"/Type", b"/Pages", b"/StructTreeRoot", b"/Lang", b"/Metadata")
_EXPECTED = {*_KEPT, b"/MarkInfo", b"/ViewerPreferences", b"/Outlines", b"/PageLabels"}


@dataclass(frozen=True)
class Part:
    """The objects of a file by their numbers: the text of each, and the data of a stream; `about`
    are those that say something of the file alone, by their numbers.
    """

    objects: Mapping[int, tuple[bytes, bytes | None]]
    catalogue: Dictionary
    about: frozenset[int]

    def look_up(self, value: Value | None) -> Value | None:
        """The value itself, where it is said by reference."""
        return read_value(self.objects[value.number][0]) if isinstance(value, Reference) else value

    def look_up_dictionary(self, value: Value | None) -> Dictionary:
        """A dictionary that is said by reference or not; an empty one where there is none."""
        found = self.look_up(value)
        return found if isinstance(found, dict) else {}

    @property
    def pages(self) -> Dictionary:
        """The root of the tree of pages."""
        return self.look_up_dictionary(self.catalogue[b"/Pages"])

    def count_pages(self) -> int:
        """How many there are."""
        count = self.pages[b"/Count"]
        return int(count) if isinstance(count, bytes) else 0

    def find_last_box(self) -> Value | None:
        """The size of the last page, which it may have from what it belongs to."""
        node, box = self.pages, None
        while node:
            box = self.look_up(node.get(b"/MediaBox")) or box
            kids = self.look_up(node.get(b"/Kids"))
            node = self.look_up_dictionary(kids[-1]) if isinstance(kids, list) and kids else {}
        return box


def read_part(pdf: bytes) -> Part:
    """A PDF file taken apart. Raises pikepdf.PdfError where it is none."""
    return next(part for form in _list_forms(pdf) if (part := _take_apart(form)))


def count_pages(pdf: bytes) -> int:
    """The number of pages of a file, of which little is read. Raises pikepdf.PdfError."""
    table = read_table(pdf)
    if table is None:
        return read_part(pdf).count_pages()
    root, _ = _find_object(pdf, table, table.root.number) or (b"<<>>", None)
    pages = read_dictionary(root).get(b"/Pages")
    found = _find_object(pdf, table, pages.number) if isinstance(pages, Reference) else None
    count = read_dictionary(found[0]).get(b"/Count") if found else None
    return int(count) if isinstance(count, bytes) else read_part(pdf).count_pages()


def _list_forms(pdf: bytes) -> Iterator[bytes]:
    """The file as it is, then as qpdf writes it."""
    import pikepdf  # few files need it

    yield pdf
    plain = BytesIO()
    with pikepdf.open(BytesIO(pdf)) as document:
        for key in set(document.Root.keys()).difference(key.decode() for key in _KEPT):
            del document.Root[key]
        mode = pikepdf.ObjectStreamMode.disable
        document.save(plain, deterministic_id=True, object_stream_mode=mode)
    yield plain.getvalue()


def _take_apart(pdf: bytes) -> Part | None:
    """The file taken apart; None where it is written in another form."""
    table = read_table(pdf)
    if table is None or any(key in table.trailer for key in _FURTHER):
        return None
    objects = {}
    for number in table.places:
        content = _find_object(pdf, table, number)
        if content is None:
            return None
        objects[number] = content
    catalogue = read_dictionary(objects[table.root.number][0])
    if not catalogue.keys() <= _EXPECTED:
        return None
    said = (table.root, table.trailer.get(b"/Info"), *catalogue.values())
    about = (each for each in said if isinstance(each, Reference) and each != catalogue[b"/Pages"])
    return Part(objects, catalogue, frozenset(each.number for each in about))


def _find_object(pdf: bytes, table: Table, number: int) -> tuple[bytes, bytes | None] | None:
    """The text of an object, and its data if it is a stream; None where it is in another form, or
    its strings are not understood.
    """
    piece, head = pdf[table.places[number]], b"%d 0 obj\n" % number
    if not piece.startswith(head):
        return None
    text, stream, rest = piece[len(head) :].partition(_STREAM)
    data = None
    if stream:
        length = _LENGTH.search(text)
        if length is None:
            return None
        data, rest = rest[: int(length[1])], rest[int(length[1]) :]
        whole = rest.split() == _STREAM_ENDS
    else:
        text, end, rest = text.rpartition(_END)
        whole = bool(end) and not rest.strip()
    # A parenthesis that opens no string which is understood stays
    nested = _OPENING in text and _OPENING in _STRING.sub(b"", text)
    return (text.strip(), data) if whole and not nested else None
