"""A PDF file that is written object by object, and holds none of them: many small ones are packed
together, as the elements of a structure are.
"""

from __future__ import annotations

from hashlib import sha256
from typing import BinaryIO
from zlib import compress

from kinegrade.press.binding.values import Reference, write_value

_HEAD = b"%PDF-1.7\n%\x80\x80\x80\x80\n"
_TOGETHER = 100  # objects in a pack
# Bytes of a line of the table: what kind of place, where, and which of a pack
_KIND, _WHERE, _WHICH = 1, 5, 1
_LINE = _KIND + _WHERE + _WHICH
_BYTE = 8  # bits
_ALONE, _IN_PACK = 1, 2


class PackedFile:
    """Writes a PDF to a stream; same objects, same bytes."""

    def __init__(self, stream: BinaryIO) -> None:
        self._stream = stream
        self._digest = sha256()
        self._length = 0
        self._table = bytearray(_LINE)  # there is no object 0
        self._pack: list[tuple[int, bytes]] = []
        self._write(_HEAD)

    def reserve(self, count: int = 1) -> int:
        """The first of so many numbers for objects; those that are never used do no harm."""
        first = len(self._table) // _LINE
        self._table += bytes(_LINE * count)
        return first

    def put(self, number: int, text: bytes, data: bytes | None = None) -> None:
        """Write an object under its number, with the data of a stream."""
        if data is None:
            self._pack.append((number, text))
            if len(self._pack) == _TOGETHER:
                self._write_pack()
            return
        self._note(number, _ALONE, self._length)
        self._write(b"%d 0 obj\n%b\nstream\n%b\nendstream\nendobj\n" % (number, text, data))

    def close(self, catalogue: int) -> None:
        """Write the table of places, and where the file begins to be read."""
        if self._pack:
            self._write_pack()
        number, place = self.reserve(), self._length
        self._note(number, _ALONE, place)
        packed = compress(self._table)
        digest = b"<%b>" % self._digest.hexdigest()[:32].encode()
        about = write_value(
            {
                b"/Type": b"/XRef",
                b"/Size": b"%d" % (number + 1),
                b"/W": [b"%d" % width for width in (_KIND, _WHERE, _WHICH)],
                b"/Root": Reference(catalogue),
                b"/ID": [digest, digest],
                b"/Filter": b"/FlateDecode",
                b"/Length": b"%d" % len(packed),
            }
        )
        self._write(b"%d 0 obj\n%b\nstream\n%b\nendstream\nendobj\n" % (number, about, packed))
        self._write(b"startxref\n%d\n%%%%EOF\n" % place)

    def _write_pack(self) -> None:
        """Write the small objects that wait, each behind where it is in their pack."""
        pack, self._pack = self._pack, []
        holder, begin = self.reserve(), 0
        numbers: list[bytes] = []
        for place, (number, text) in enumerate(pack):
            self._note(number, _IN_PACK, holder, place)
            numbers.append(b"%d %d " % (number, begin))
            begin += len(text) + 1
        head = b"".join(numbers)
        packed = compress(b"%b%b\n" % (head, b"\n".join([text for _, text in pack])))
        about = b"<</Type/ObjStm/N %d/First %d/Filter/FlateDecode/Length %d>>" % (
            len(pack),
            len(head),
            len(packed),
        )
        self.put(holder, about, packed)

    def _note(self, number: int, kind: int, where: int, which: int = 0) -> None:
        line = ((kind << _BYTE * _WHERE) + where << _BYTE * _WHICH) + which
        self._table[_LINE * number : _LINE * (number + 1)] = line.to_bytes(_LINE)

    def _write(self, content: bytes) -> None:
        self._stream.write(content)
        self._digest.update(content)
        self._length += len(content)
