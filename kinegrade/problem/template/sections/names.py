"""The names that a template's file declares: each is plain, and means one thing."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

from kinegrade.files.fields.table import Table
from kinegrade.language.message import Message, list_plainly
from kinegrade.mechanics.branches import BRANCHES
from kinegrade.mechanics.joints import GROUND

_RESERVED = frozenset({"pi", GROUND, *BRANCHES})
_PLAIN = re.compile(r"[A-Za-z]\w{0,30}", re.ASCII)
# Tables of names of which no two share one; only a body may be named after its point
_APART = (
    ("parameters", "lengths", "points"),
    ("parameters", "lengths", "bodies"),
    ("parameters", "text"),
    ("parameters", "steps"),
)
_DECLARING = ("parameters", "lengths", "points", "bodies", "asks", "text", "steps")

_APART_FROM_EXPRESSIONS = ("asks", "text")  # no expression holds their names

Declared = Mapping[str, tuple[str, ...]]


def declared_names(table: Table) -> Declared:
    """The names in each table that declares some, even where what they stand for cannot be read."""
    found = {}
    for key in _DECLARING:
        value = table.value(key)
        found[key] = tuple(value) if isinstance(value, dict) else ()
    return found


def check_names(table: Table, declared: Declared) -> None:
    """Notes names that cannot be used in expressions, and those that stand for two things."""
    for key, listed in declared.items():
        for name in listed:
            expected = _describe_expected(key, name)
            if expected:
                table.faults.note((key, name), Message("template.not-a-name"), expected)
    for key, name, first in dict.fromkeys(_find_declared_twice(declared)):
        what = Message("template.one-name-twice", other=f"{first}.{name}")
        table.faults.note((key, name), what, do=Message("template.rename-one"))


def _describe_expected(key: str, name: str) -> Message | None:
    """What was expected of a name in place of this one; None where it serves."""
    if not _PLAIN.fullmatch(name):
        return Message("template.plain-name")
    if name in _RESERVED and key not in _APART_FROM_EXPRESSIONS:
        return Message("template.name-other-than", names=list_plainly(sorted(_RESERVED)))
    return None


def _find_declared_twice(declared: Declared) -> Iterator[tuple[str, str, str]]:
    """Each name that is declared again: its table, the name, the table that had it before."""
    for group in _APART:
        first: dict[str, str] = {}
        for key in group:
            for name in declared[key]:
                if name in first:
                    yield key, name, first[name]
                first.setdefault(name, key)
