"""The table `[text]` of a template: texts that depend on values, each a list of wordings with their
conditions.

    [[text.turning]]
    if = "alpha > 0"
    en = "speeding up"
    zh = "加速"

    [[text.turning]]
    en = "at a constant rate"
    zh = "匀速"

The first wording whose condition holds applies; one without `if`, which must be the last, at all
values that are left.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from typing import Any

from kinegrade.errors import ExpressionError, KinegradeError, did_you_mean
from kinegrade.language import LANGUAGES
from kinegrade.problem.conditions import read_condition
from kinegrade.problem.template import Translated, Wording

MOST = 20  # texts of a template, and wordings of a text
NAME = re.compile(r"[A-Za-z]\w{0,30}", re.ASCII)
KNOWN = ("if", *LANGUAGES)
Fault = Callable[[str, str], None]  # takes a path in the template's tables and what is wrong there


def read_texts(table: Mapping[str, Any], fault: Fault) -> dict[str, tuple[Wording, ...]]:
    """The texts by name, as far as they can be read; the rest is reported to `fault`."""
    if len(table) > MOST:
        fault("text", f"{len(table)} texts: expected at most {MOST}: put fewer into the statement")
        return {}
    for name in table:
        if not NAME.fullmatch(name):
            fault(f"text.{name}", "not usable as a name: a letter, then letters, digits and _")
    return {name: _wordings(f"text.{name}", entries, fault) for name, entries in table.items()}


def _wordings(path: str, entries: Any, fault: Fault) -> tuple[Wording, ...]:
    if not isinstance(entries, list) or not 1 <= len(entries) <= MOST:
        fault(path, f"expected 1 to {MOST} wordings, each under its own [[{path}]]")
        return ()
    found = []
    for index, entry in enumerate(entries):
        place = f"{path}[{index}]"
        try:
            found.append(_wording(entry))
        except KinegradeError as error:
            for problem in error.problems:
                fault(place, problem)
    for index, one in enumerate(found[:-1]):
        if one.condition is None:
            fault(
                f"{path}[{index}]",
                'without "if" it applies at all values, so nothing after it does: put it last',
            )
    return tuple(found)


def _wording(entry: Any) -> Wording:
    """One wording. Raises ExpressionError with all that is wrong with it."""
    faults = tuple(_faults(entry))
    if faults:
        raise ExpressionError(*faults)
    condition = read_condition(entry["if"]) if "if" in entry else None
    return Wording(condition, Translated(entry["en"].strip(), entry["zh"].strip()))


def _faults(entry: Any) -> Iterator[str]:
    if not isinstance(entry, dict):
        yield 'expected a table: { if = "alpha > 0", en = "...", zh = "..." }'
        return
    for key in entry:
        if key not in KNOWN:
            yield f'unknown key "{key}": {did_you_mean(key, KNOWN)}'
    if not isinstance(entry.get("if", ""), str):
        yield 'if: expected a condition as text, like "alpha > 0"'
    for language in LANGUAGES:
        text = entry.get(language)
        if not isinstance(text, str) or not text.strip():
            yield f"{language}: expected the text in this language"
