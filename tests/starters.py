"""How a starter is read by the tests: what stands in it, in force or not, and what explains it."""

from __future__ import annotations

import re

_KEY = re.compile(r"#?(?P<key>[a-z-]+) = ")
_TABLE = re.compile(r"#?\[+(?P<table>[\w.]+)\]+")
_NOT_IN_FORCE = re.compile(r"^#(?=[a-z\[])", re.MULTILINE)


def put_in_force(text: str) -> str:
    """A starter with everything in force that can be."""
    return _NOT_IN_FORCE.sub("", text)


def list_keys(text: str) -> dict[str, list[str]]:
    """The keys that stand in each of a starter's tables, in force or not; tables of one name
    together.
    """
    found: dict[str, list[str]] = {"": []}
    table = ""
    for line in text.splitlines():
        if match := _TABLE.match(line):
            table = match["table"]
            found.setdefault(table, [])
        elif match := _KEY.match(line):
            found[table].append(match["key"])
    return found


def list_unexplained(text: str) -> list[str]:
    """The lines with a key or a table that no line of comment stands above."""
    lines = text.splitlines()
    return [
        line
        for above, line in zip(["", *lines], lines, strict=False)
        if (_KEY.match(line) or _TABLE.match(line)) and not above.startswith("# ")
    ]
