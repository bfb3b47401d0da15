"""A mechanism that several templates share: its file holds tables, over which each template lays
its own.

Entries of `[parameters]`, `[lengths]`, `[points]` and `[bodies]` are the mechanism's, then the
template's; of one name the template's wins, and a parameter is laid over key by key. Joints and
conditions are the mechanism's followed by the template's; the keys of `[figure]` are the template's
where it has them.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any

from kinegrade.errors import TemplateError, did_you_mean

FOLDER = "mechanisms"  # beside the templates
FILE_NAME = re.compile(r"[a-z0-9]+(-[a-z0-9]+)*", re.ASCII)
KINDS: Mapping[str, type] = {
    "parameters": dict,
    "lengths": dict,
    "points": dict,
    "bodies": dict,
    "joints": list,
    "conditions": list,
    "figure": dict,
}
LISTED = re.compile(r"(joints|conditions)\[(\d+)\]", re.ASCII)


@dataclass(frozen=True)
class Layers:
    """A template's own tables over those of its mechanism, which has none where the template stands
    alone.
    """

    file: str
    own: Mapping[str, Any]
    shared_file: str = ""
    shared: Mapping[str, Any] = field(default_factory=dict)

    def tables(self) -> dict[str, Any]:
        """The tables together."""
        both = {
            key: laid_over(key, self.shared[key], self.own[key])
            for key in self.shared
            if key in self.own
        }
        return {**self.shared, **self.own, **both}

    def standing(self, path: str) -> tuple[str, str]:
        """The file, and the place in it, of what stands at `path` of the tables together.

        `path` may also be a name or a sentence alone. A parameter that both describe stands in both
        files.
        """
        listed = LISTED.fullmatch(path)
        if listed:
            return self.standing_in_list(listed[1], int(listed[2]))
        table, dot, name = path.partition(".")
        if not dot or table not in KINDS:
            table, name = "", path
        keys = (table,) if table else tuple(KINDS)
        if not holds(self.shared, keys, name):
            return self.file, path
        if not holds(self.own, keys, name):
            return self.shared_file, path
        return (
            f"{self.file} over {self.shared_file}" if table == "parameters" else self.file
        ), path

    def standing_in_list(self, key: str, index: int) -> tuple[str, str]:
        """The file of an entry of a list, counted as it is in that file."""
        shared = len(self.shared.get(key, ()))
        return (
            (self.shared_file, f"{key}[{index}]")
            if index < shared
            else (self.file, f"{key}[{index - shared}]")
        )


def laid_over(key: str, shared: Any, own: Any) -> Any:
    """A template's own table or list over the mechanism's; one of the wrong kind is kept, to be
    refused later.
    """
    if isinstance(shared, list) and isinstance(own, list):
        return [*shared, *own]
    if not isinstance(shared, dict) or not isinstance(own, dict):
        return own
    entries = {**shared, **own}
    if key == "parameters":
        entries |= {
            name: {**shared[name], **own[name]}
            for name in shared
            if isinstance(shared[name], dict) and isinstance(own.get(name), dict)
        }
    return entries


def holds(tables: Mapping[str, Any], keys: Iterable[str], name: str) -> bool:
    """Whether a name or sentence stands in one of the tables or lists under `keys`."""
    return any(isinstance(tables.get(key), KINDS[key]) and name in tables[key] for key in keys)


def mechanism_name(name: Any) -> str:
    """A name that can stand for a file in the folder and nowhere else. Raises TemplateError for any
    other.
    """
    if not isinstance(name, str) or not FILE_NAME.fullmatch(name):
        raise TemplateError(
            f"expected a file's name in {FOLDER}/ without .toml: small letters, digits, hyphens"
        )
    return name


def sharable(tables: Mapping[str, Any]) -> dict[str, Any]:
    """Those tables of a mechanism's file that templates can share."""
    return {
        key: value
        for key, value in tables.items()
        if key in KINDS and isinstance(value, KINDS[key])
    }


def mechanism_faults(file: str, tables: Mapping[str, Any]) -> list[str]:
    """What a mechanism's file holds that templates cannot share, a line for each."""
    return [f"{file}: {unsharable(key)}" for key in tables if key not in sharable(tables)]


def unsharable(key: str) -> str:
    """Why what stands under a key cannot be shared."""
    if key == "mechanism":
        return (
            "mechanism: a mechanism cannot build on a further one: write all its tables in this "
            "file"
        )
    if key in KINDS:
        return f"{key}: expected a {'table' if KINDS[key] is dict else 'list'}"
    return f"{key!r:.60} cannot be shared: leave it to the templates: {did_you_mean(key, KINDS)}"
