"""How the objects of a file are written under the numbers that they have in a volume."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass

from kinegrade.press.binding.values import STRING

# Strings are found to be left alone
_NUMBERED = re.compile(
    rb"(?P<number>\d+) 0 R\b|(?P<entry>/StructParents?) (?P<key>\d+)|" + STRING, re.DOTALL
)
_ELEMENT = b"/StructElem"
# The name of a header cell, and the names of those that a cell belongs to
_NAMED = re.compile(rb"/ID ?%b|/Headers ?\[[^\]]*\]" % STRING, re.DOTALL)
_STRING = re.compile(STRING, re.DOTALL)


@dataclass(frozen=True)
class Renumbering:
    """Object 1 gets the number behind `first`, but for those that are `moved` to another; elements
    have the places behind `key` in the index of the structure, and names that begin with `prefix`.
    """

    first: int
    moved: Mapping[int, int]
    key: int
    prefix: bytes

    def write(self, text: bytes) -> bytes:
        """The text of an object, or of a part of one."""
        if _ELEMENT in text:
            text = _NAMED.sub(self._name, text)
        return _NUMBERED.sub(self._number, text)

    def name(self, string: bytes) -> bytes:
        """The name that a header cell has in the volume."""
        return b"(%b-%b" % (self.prefix, string[1:])

    def _name(self, found: re.Match[bytes]) -> bytes:
        return _STRING.sub(lambda string: self.name(string[0]), found[0])

    def _number(self, found: re.Match[bytes]) -> bytes:
        match found.lastgroup:
            case "number":
                number = int(found["number"])
                return b"%d 0 R" % self.moved.get(number, self.first + number)
            case "key":
                return b"%b %d" % (found["entry"], self.key + int(found["key"]))
            case _:
                return found[0]
