"""The PDF of Typst with its small objects in compressed streams, as PDF has them since 1.5.

Typst writes each element of a page's structure as an object of its own: hundreds of some 150 bytes,
as much as all else. Packing them without a look at streams takes a quarter of the time that a
library for PDF needs to read and write the file.
"""

from __future__ import annotations

import re
import zlib
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

_TABLE = re.compile(
    rb"xref\n0 (\d+)\n((?:\d{10} \d{5} [nf][ \r]\n)+)trailer\s*<<(.*)>>\s*startxref", re.DOTALL
)
_OFFSET = re.compile(rb"(\d{10}) 00000 n")
_BEGIN, _END, _STREAM = b" 0 obj\n", b"\nendobj\n", b"\nstream\n"
# Read of any file at once, these stand alone: a stream is unpacked whole, and the structure is long
_ALONE = re.compile(rb"/Type\s*/(?:Catalog|Pages?)\b")
_RESOURCE = re.compile(rb"/Font|/ColorSpace|/ProcSet")
_SIZE = re.compile(rb"/Size \d+")
_LEVEL = 4  # of compression: 6 takes a millisecond more for one per cent


class _Object(NamedTuple):
    """An object as it stands in the file, its number, and what it holds."""

    whole: bytes
    number: int
    held: bytes


def pack(pdf: bytes) -> bytes:
    """A PDF as Typst writes it, packed: same input, same bytes. What is written in another way is
    given back as it is.
    """
    start = int(pdf[pdf.rindex(b"startxref") :].split()[1])
    table = _TABLE.match(pdf, start)
    if table is None:
        return pdf
    count, entries, trailer = int(table[1]), table[2], table[3]
    offsets = sorted(int(offset) for offset in _OFFSET.findall(entries))
    packed = _Packed(pdf[: offsets[0]], count)
    structure, resources = list[_Object](), list[_Object]()
    for each in _list_objects(pdf, [*offsets, start]):
        if _STREAM in each.held or _ALONE.search(each.held):
            packed.place(each)
        else:
            (resources if _RESOURCE.search(each.held) else structure).append(each)
    packed.place_together(structure)
    packed.place_together(resources)
    return packed.close(trailer)


def _list_objects(pdf: bytes, offsets: Sequence[int]) -> Iterator[_Object]:
    for begin, end in pairwise(offsets):
        whole = pdf[begin:end]
        number, mark, held = whole.partition(_BEGIN)
        if not (mark and number.isdigit() and held.endswith(_END)):
            raise ValueError(f"no object of a PDF at {begin}")
        yield _Object(whole, int(number), held.removesuffix(_END))


class _Packed:
    """A PDF that grows object by object; `places` says by number where each is, as a table of
    references has it: its kind, where it begins or which stream holds it, its place in there.
    """

    def __init__(self, head: bytes, count: int) -> None:
        self._bytes = bytearray(head)
        self._count = count
        self._places: dict[int, tuple[int, int, int]] = {0: (0, 0, 65535)}

    def place(self, each: _Object) -> None:
        """An object as it is."""
        self._places[each.number] = (1, len(self._bytes), 0)
        self._bytes += each.whole

    def place_together(self, objects: Sequence[_Object]) -> None:
        """Objects in a stream of their own, if there are any."""
        if not objects:
            return
        index, held = list[bytes](), bytearray()
        for place, each in enumerate(objects):
            self._places[each.number] = (2, self._count, place)
            index.append(b"%d %d " % (each.number, len(held)))
            held += each.held + b"\n"
        first = b"".join(index)
        kind = b"/Type/ObjStm/N %d/First %d" % (len(objects), len(first))
        self._add_stream(kind, first + held)

    def close(self, trailer: bytes) -> bytes:
        """The whole, with its table of references at the end."""
        start, number = len(self._bytes), self._count
        self._places[number] = (1, start, 0)
        rows = [self._places.get(each, (0, 0, 0)) for each in range(number + 1)]
        table = b"".join(
            bytes([kind]) + where.to_bytes(4, "big") + place.to_bytes(2, "big")
            for kind, where, place in rows
        )
        sized = _SIZE.sub(b"/Size %d" % (number + 1), trailer)
        self._add_stream(b"/Type/XRef/W[1 4 2]" + sized, table)
        return bytes(self._bytes) + b"startxref\n%d\n%%%%EOF" % start

    def _add_stream(self, kind: bytes, held: bytes) -> None:
        """A compressed stream as an object with the next number."""
        packed = zlib.compress(held, _LEVEL)
        self._places[self._count] = (1, len(self._bytes), 0)
        head = b"%d 0 obj\n<<%s/Filter/FlateDecode/Length %d>>" % (self._count, kind, len(packed))
        self._bytes += head + b"stream\n" + packed + b"\nendstream\nendobj\n"
        self._count += 1
