"""The kinds of entries of a bank, told by their keys, and how their numbers are dealt."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal, TypeAlias

from kinegrade.exam.bank.blueprint import Dealing
from kinegrade.exam.bank.keys import (
    ANY,
    BY_HAND,
    COUNTED,
    DEALT,
    DRAWN,
    FAMILY,
    NAMED,
    OWN,
    TAG,
    TEXT,
)
from kinegrade.exam.bank.shipped_templates import Grouping
from kinegrade.files.fields.table import Table
from kinegrade.files.fields.values import flag
from kinegrade.language.message import Message, list_all
from kinegrade.problem.template.sections.stepwise_keys import STEPWISE

_Kind: TypeAlias = (
    Literal["template", "any", "text", "steps"] | Grouping
)  # the key that says what an entry is
ENTRY_KEYS: Mapping[_Kind, tuple[str, ...]] = {
    "template": (*NAMED, *DEALT, *COUNTED),
    "any": (*ANY, *DEALT, *COUNTED),
    "family": (*FAMILY, *DRAWN, *DEALT, *COUNTED),
    "tag": (*TAG, *DRAWN, *DEALT, *COUNTED),
    "text": (*TEXT, *BY_HAND, *COUNTED),
    "steps": (*OWN, *STEPWISE, *DEALT, *COUNTED),
}
_ALL_KEYS = tuple(dict.fromkeys(key for keys in ENTRY_KEYS.values() for key in keys))
_ONE_KIND = Message("bank.one-kind")


def find_kind(entry: Table) -> _Kind | None:
    """The key by which an entry says what it is; None after a fault."""
    kinds = [key for key in ENTRY_KEYS if key in entry]
    if len(kinds) == 1:
        return kinds[0]
    misspelt = entry.only(*_ALL_KEYS).excused
    if entry.whole and misspelt.isdisjoint(ENTRY_KEYS):
        everything = Message("bank.all-these", keys=list_all(kinds))
        what = everything if kinds else Message("bank.no-template")
        entry.fault(None, what, _ONE_KIND)
    return None


def read_dealing(entry: Table) -> Dealing:
    """How the numbers of an entry's questions are dealt."""
    same = entry.with_default("same", flag, False)
    repeats = entry.with_default("repeats", flag, False)
    if same and repeats:
        what, do = Message("bank.same-and-repeats"), Message("bank.leave-one-out")
        entry.fault("repeats", what, do=do)
    if same:
        return "same"
    return "repeated" if repeats else "own"
