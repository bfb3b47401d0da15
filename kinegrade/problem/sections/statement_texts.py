"""The table `[text]`: texts that depend on values, each a list of wordings with their conditions.

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

from kinegrade.fields.table import Table
from kinegrade.fields.values import text
from kinegrade.problem.conditions import read_condition
from kinegrade.problem.sections.keys import WORDING
from kinegrade.problem.sections.values import present, words
from kinegrade.problem.template import Condition, Translated, Wording

_MOST = 20  # texts of a template, and wordings of a text
_LIKE = '{ if = "alpha > 0", en = "...", zh = "..." }'
_LAST = 'without "if" it applies at all values, so nothing after it does'


def read_texts(table: Table) -> dict[str, dict[int, Wording]]:
    """The texts by name, each with the wordings that can be read, by their position in the file."""
    texts = table.table("text")
    if len(texts) > _MOST:
        table.fault(
            "text", f"{len(texts)} texts", f"at most {_MOST}", "put fewer into the statement"
        )
        return {}
    return {name: _read_wordings(texts, name) for name in texts}


def _read_wordings(texts: Table, name: str) -> dict[int, Wording]:
    entries = texts.tables(name, _LIKE)
    if isinstance(texts.value(name), list) and not 1 <= len(entries) <= _MOST:
        expected = f"1 to {_MOST} of them, each under its own [[text.{name}]]"
        texts.fault(name, f"{len(entries)} wordings", expected)
        return {}
    for entry in entries[:-1]:
        if _applies_always(entry):
            entry.fault(None, _LAST, do="put it last")
    return present({number: _read_wording(entry) for number, entry in enumerate(entries)})


def _applies_always(entry: Table) -> bool:
    """Whether a wording has no condition, nor anything unknown that may be meant as one."""
    return entry.whole and "if" not in entry and set(entry) <= set(WORDING)


def _read_wording(table: Table) -> Wording | None:
    entry = table.only(*WORDING)
    condition = entry.optional("if", _read_condition)
    english, chinese = entry.required("en", text), entry.required("zh", text)
    if english is None or chinese is None:
        return None
    return Wording(condition, Translated(english.strip(), chinese.strip()))


def _read_condition(value: object) -> Condition:
    return read_condition(words(value))
