"""The line of every key and list entry in a TOML or JSON text that a parser has accepted.

Lines are worked out only when a fault is to be reported, so parsing stays as fast as it is. JSON is
read as a single inline table.
"""

from __future__ import annotations

import json
import re
import tomllib
from bisect import bisect_left
from collections.abc import Callable, Mapping

from kinegrade.files.fields.place import Place

_SPACE = re.compile(r"(?:[ \t\r\n]|#[^\n]*)*")
_BARE_KEY = re.compile(r"[A-Za-z0-9_-]+")
_STRINGS = (
    re.compile(r'"""(?:[^\\]|\\.)*?"""(?:"{0,2})', re.DOTALL),
    re.compile(r"'''.*?'''(?:'{0,2})", re.DOTALL),
    re.compile(r'"(?:[^"\\]|\\.)*"'),
    re.compile(r"'[^']*'"),
)
_PLAIN = re.compile(r"[^,\]}#\n]*")


def lines_of_toml(text: str) -> Mapping[Place, int]:
    """The line, from 1, on which each place of a valid TOML text first occurs.

    >>> lines_of_toml('[[questions]]\\nasks = { v_B = 3 }')[("questions", 0, "asks", "v_B")]
    2
    """
    scan = _Scan(text, _toml_key)
    scan.document()
    return scan.lines


def lines_of_json(text: str) -> Mapping[Place, int]:
    """The line, from 1, on which each place of a valid JSON text occurs.

    >>> lines_of_json('{"students": [\\n{"name": "Ada"}]}')[("students", 0, "name")]
    2
    """
    scan = _Scan(text, json.loads)
    scan.skip()
    scan.value(())
    return scan.lines


def _toml_key(quoted: str) -> str:
    """The key that a text in quotation marks stands for."""
    return str(tomllib.loads(f"key = {quoted}")["key"])


class _Scan:
    """Goes through a text once; `at` is the position of the next character."""

    def __init__(self, text: str, unquote: Callable[[str], str]) -> None:
        self.text, self.unquote, self.at = text, unquote, 0
        self.lines: dict[Place, int] = {}
        self._line_ends = [found.start() for found in re.finditer("\n", text)]
        self._entries: dict[Place, int] = {}  # the number of [[tables]] in each list so far

    def document(self) -> None:
        """A whole TOML text: table headers, and keys with values below them."""
        table: Place = ()
        self.skip()
        while self.at < len(self.text):
            if self._next("["):
                table = self._header()
            else:
                self._pair(table)
            self.skip()

    def value(self, place: Place) -> None:
        """A value, with everything inside it."""
        if self._next("["):
            self._list(place)
        elif self._next("{"):
            self._table(place)
        else:
            self._take(next((form for form in _STRINGS if form.match(self.text, self.at)), _PLAIN))

    def skip(self) -> None:
        """Skips blanks, line ends and comments."""
        self._take(_SPACE)

    def _header(self) -> Place:
        """[table] or [[list of tables]]: the place of what follows."""
        line = self._line()
        listed = self._next("[")
        *outer, last = self._keys()
        place: Place = ()
        for key in outer:
            place = self._latest((*place, key))
            self.lines.setdefault(place, line)
        place = (*place, last)
        self.lines.setdefault(place, line)
        if listed:
            self._entries[place] = self._entries.get(place, 0) + 1
            place = self._latest(place)
            self.lines[place] = line
        self.at = self.text.index("]", self.at) + (2 if listed else 1)
        return place

    def _latest(self, place: Place) -> Place:
        """The last entry of a list of tables, to which what follows belongs; otherwise the place
        itself.
        """
        entries = self._entries.get(place)
        return place if entries is None else (*place, entries - 1)

    def _pair(self, table: Place) -> None:
        """A key, dotted or not, and its value."""
        line = self._line()
        place = table
        for key in self._keys():
            place = (*place, key)
            self.lines.setdefault(place, line)
        self.at += 1  # the = or : between key and value
        self.skip()
        self.value(place)

    def _keys(self) -> list[str]:
        """The keys of a path, up to the character that ends it."""
        keys = [self._key()]
        while self._next("."):
            keys.append(self._key())
        return keys

    def _key(self) -> str:
        self.skip()
        if self.text[self.at] in "\"'":
            key = self.unquote(self._take(_STRINGS[2 if self.text[self.at] == '"' else 3]))
        else:
            key = self._take(_BARE_KEY)
        self.skip()
        return key

    def _list(self, place: Place) -> None:
        number = 0
        self.skip()
        while not self._next("]"):
            self.lines[*place, number] = self._line()
            self.value((*place, number))
            number += 1
            self._comma()

    def _table(self, place: Place) -> None:
        self.skip()
        while not self._next("}"):
            self._pair(place)
            self._comma()

    def _comma(self) -> None:
        self.skip()
        self._next(",")
        self.skip()

    def _next(self, sign: str) -> bool:
        """Whether this character comes next; if so, it is consumed."""
        found = self.text.startswith(sign, self.at)
        self.at += found
        return found

    def _take(self, form: re.Pattern[str]) -> str:
        """The next text of that form, which may be empty; it is consumed."""
        found = form.match(self.text, self.at)
        taken = found[0] if found else ""
        self.at += len(taken)
        return taken

    def _line(self) -> int:
        return bisect_left(self._line_ends, self.at) + 1
