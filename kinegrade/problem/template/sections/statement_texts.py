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

from kinegrade.files.fields.table import Table
from kinegrade.files.fields.values import text
from kinegrade.language.known import known_languages
from kinegrade.language.message import Message
from kinegrade.problem.template.conditions import read_condition
from kinegrade.problem.template.sections.values import present, words
from kinegrade.problem.template.template import Condition, Wording
from kinegrade.problem.template.translated import Translated

_MOST = 20  # texts of a template, and wordings of a text
_AT_MOST = Message("template.at-most", most=_MOST)
_LIKE = '{ if = "alpha > 0", en = "...", zh = "..." }'


def read_texts(table: Table) -> dict[str, dict[int, Wording]]:
    """The texts by name, each with the wordings that can be read, by their position in the file."""
    texts = table.table("text")
    if len(texts) > _MOST:
        what, expected = Message("template.texts", count=len(texts)), _AT_MOST
        table.fault("text", what, expected, Message("template.put-fewer"))
        return {}
    return {name: _read_wordings(texts, name) for name in texts}


def _read_wordings(texts: Table, name: str) -> dict[int, Wording]:
    entries = texts.tables(name, _LIKE)
    if isinstance(texts.value(name), list) and not 1 <= len(entries) <= _MOST:
        expected = Message("template.wordings-each", most=_MOST, name=name)
        texts.fault(name, Message("template.wordings", count=len(entries)), expected)
        return {}
    for entry in entries[:-1]:
        if _applies_always(entry):
            entry.fault(None, Message("template.not-last"), do=Message("template.put-last"))
    return present({number: _read_wording(entry) for number, entry in enumerate(entries)})


def _applies_always(entry: Table) -> bool:
    """Whether a wording has no condition, nor anything unknown that may be meant as one."""
    return entry.whole and "if" not in entry and set(entry) <= {"if", *known_languages()}


def _read_wording(table: Table) -> Wording | None:
    entry = table.only("if", *known_languages())
    condition = entry.optional("if", _read_condition)
    texts = [(language, entry.optional(language, text)) for language in known_languages()]
    written = tuple((language, words.strip()) for language, words in texts if words is not None)
    if not written:
        _note_no_text(entry)
        return None
    return Wording(condition, Translated(written))


def _note_no_text(entry: Table) -> None:
    """A fault for a wording in no language, unless what stands there is at fault already."""
    if not any(language in entry for language in known_languages()):
        entry.fault(None, Message("texts.none"), Message("texts.in-one-language"))


def _read_condition(value: object) -> Condition:
    return read_condition(words(value))
