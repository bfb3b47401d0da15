"""How the objects of a file are written under the numbers that they have in a volume."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field

from kinegrade.press.binding.values import STRING

# Strings are found to be left alone
_NUMBERED = re.compile(rb"(\d++ 0 R\b|/StructParents? \d++|%b)" % STRING, re.DOTALL)
_REFERENCE, _KEYED = b" 0 R", b"/StructParent"
_BETWEEN = b"\nendobj\n"
_ELEMENT = b"/StructElem"
# The name of a header cell, and the names of those that a cell belongs to
_NAMED = re.compile(rb"(/ID ?%b|/Headers ?\[[^\]]*\])" % STRING, re.DOTALL)
_ID, _HEADERS = b"/ID", b"/Headers"
_STRING = re.compile(STRING, re.DOTALL)


@dataclass(frozen=True)
class Renumbering:
    """Object 1 gets the number behind `first`, but for those that are `moved` to another; elements
    have the places behind `key` in the index of the structure, and names that begin with `prefix`.

    What is `written` in place of a number or a name is worked out once, as a file says each often.
    """

    first: int
    moved: Mapping[int, int]
    key: int
    prefix: bytes
    written: dict[bytes, bytes] = field(default_factory=dict, repr=False, compare=False)

    def write(self, text: bytes) -> bytes:
        """The text of an object, or of a part of one."""
        return self._replace(_NUMBERED.split(self._rename(text)), self._number)

    def write_all(self, texts: Iterable[bytes]) -> Sequence[bytes]:
        """The texts of objects, in whose strings no parenthesis is left open: one behind the other,
        they are looked through in a third of the time.
        """
        renamed = [*map(self._rename, texts)]
        together = _BETWEEN.join(renamed)
        if together.count(_BETWEEN) != len(renamed) - 1:
            return [*map(self.write, texts)]
        return self._replace(_NUMBERED.split(together), self._number).split(_BETWEEN)

    def name(self, string: bytes) -> bytes:
        """The name that a header cell has in the volume."""
        return b"(%b-%b" % (self.prefix, string[1:])

    def _replace(self, pieces: list[bytes], write: Callable[[bytes], bytes]) -> bytes:
        """A text in pieces, of which every second is written anew."""
        if len(pieces) == 1:
            return pieces[0]
        written = self.written
        for found in {*pieces[1::2]}.difference(written):
            written[found] = write(found)
        pieces[1::2] = map(written.__getitem__, pieces[1::2])
        return b"".join(pieces)

    def _rename(self, text: bytes) -> bytes:
        """The text of an object with the names of header cells in the volume."""
        if _ELEMENT in text and (_ID in text or _HEADERS in text):
            return self._replace(_NAMED.split(text), self._name)
        return text

    def _name(self, found: bytes) -> bytes:
        return _STRING.sub(lambda string: self.name(string[0]), found)

    def _number(self, found: bytes) -> bytes:
        if found.endswith(_REFERENCE):
            number = int(found.removesuffix(_REFERENCE))
            return b"%d 0 R" % self.moved.get(number, self.first + number)
        if found.startswith(_KEYED):
            entry, _, key = found.partition(b" ")
            return b"%b %d" % (entry, self.key + int(key))
        return found
