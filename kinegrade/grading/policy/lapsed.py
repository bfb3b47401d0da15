"""What a policy rules on, told by its keys: nothing, or rules that hold no more."""

from __future__ import annotations

import tomllib
from collections.abc import Iterable, Iterator, Mapping
from os import PathLike
from pathlib import Path
from typing import Any

from kinegrade.files.opening.regular import open_regular
from kinegrade.language.message import Message, list_first, list_plainly
from kinegrade.marks_folder.layout import POLICY

_MOST_NAMED = 5
_DEEPEST = 10  # tables in tables: no rule lies deeper


def describe_lapsed(
    folders: Iterable[Path], policy: str | PathLike[str] | None
) -> Iterator[Message]:
    """That this policy rules nothing, and which of these earlier markings were by rules that do not
    hold under it, or without any.
    """
    stated = {} if policy is None else _read_rules(Path(policy))
    if policy is not None and not any(_list_rules(stated)):
        yield Message("terminal.policy-rules-nothing", file=str(policy))
    for file in dict.fromkeys(folder / POLICY for folder in folders):
        before = _read_rules(file)
        if before and policy is None:
            yield Message("terminal.policy-lapsed", file=str(file), keys=list_plainly(before))
        elif lost := [key for key in _list_rules(before) if key not in set(_list_rules(stated))]:
            keys = list_first(lost, _MOST_NAMED)
            yield Message("terminal.rules-lapsed", file=str(file), policy=str(policy), keys=keys)


def _read_rules(file: Path) -> dict[str, Any]:
    """The tables of a policy; none where there is no file that anybody could mark by."""
    try:
        with open_regular(file) as content:
            return tomllib.loads(content.read().decode("utf-8-sig"))
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError, RecursionError):
        return {}


def _list_rules(table: Mapping[str, Any], depth: int = _DEEPEST) -> Iterator[str]:
    """What a policy rules on, by dotted keys; each accepted answer is a rule of its own."""
    for key, value in table.items():
        match value:
            case dict() if depth:
                yield from (f"{key}.{below}" for below in _list_rules(value, depth - 1))
            case list():
                yield from (f"{key} ({_show(each)})" for each in value)
            case _:
                yield key


def _show(rule: Any) -> str:
    """A rule of a list, such as an accepted answer."""
    if not isinstance(rule, dict):
        return str(rule)
    return ", ".join(f"{key} = {value}" for key, value in rule.items())
