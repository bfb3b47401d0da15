"""The text of a statement taken apart: what stands as it is, and the slots that are filled in.

A slot is `{{ name }}` or `{{ name.value }}` and nothing else: there is no language behind it. So a
template from a stranger can print what it has, and do no more.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator
from dataclasses import dataclass

from kinegrade.errors import suggest
from kinegrade.language.message import Message, Text

_BRACES = re.compile(r"\{\{(?P<inside>.*?)\}\}|(?P<other>\{\{|\{%|\{#)", re.DOTALL)
_NAMED = re.compile(r"\s*(?P<name>[A-Za-z_]\w*)(?P<value>\s*\.\s*value)?\s*", re.ASCII)
_LONGEST_SHOWN = 40
_DOLLARS = re.compile(r"(?<!\\)\$\$?")
_ALLOWED = Message("template.slots-allowed")


@dataclass(frozen=True)
class Slot:
    """A place in a text where something is filled in; with `value` a given without its symbol."""

    name: str
    value: bool


@dataclass(frozen=True)
class SlotFault:
    """What is wrong with a slot: `name` is the unknown name, "" where the fault is another one."""

    what: Message
    do: Text
    name: str = ""


def split_slots(text: str) -> tuple[str | Slot, ...]:
    """A text in pieces, in order; braces that hold anything but a name stay as they are.

    >>> split_slots("the crank {{ r }} of {{ l.value }}")
    ('the crank ', Slot(name='r', value=False), ' of ', Slot(name='l', value=True))
    """
    found: list[str | Slot] = []
    place = 0
    for match in _BRACES.finditer(text):
        slot = _read_slot(match)
        if slot is not None:
            found += [text[place : match.start()], slot]
            place = match.end()
    found.append(text[place:])
    return tuple(piece for piece in found if piece)


def find_slots_in_formulas(text: str) -> tuple[Slot, ...]:
    """The slots between dollar signs; what is filled in brings its own dollar signs.

    >>> find_slots_in_formulas("$r$ is {{ r.value }}, and $v = {{ v.value }}$")
    (Slot(name='v', value=True),)
    """
    found: list[Slot] = []
    opened = ""
    for piece in split_slots(text):
        if isinstance(piece, Slot):
            found += [piece] if opened else []
        else:
            for mark in _DOLLARS.findall(piece):
                opened = _find_open_formula(opened, mark)
    return tuple(found)


def _find_open_formula(opened: str, mark: str) -> str:
    """What formula is open after dollar signs: "" for none. Two signs also end one formula and
    begin another.
    """
    if not opened:
        return mark
    if opened == mark:
        return ""
    return opened


def find_slot_faults(
    text: str, parameters: Collection[str], texts: Collection[str]
) -> Iterator[SlotFault]:
    """What is wrong with the slots of a text that may name these parameters and texts.

    >>> [fault.what for fault in find_slot_faults("{{ 7*7 }} {{ r }}", ["r"], [])]
    [Message('template.slot', slot='{{ 7*7 }}')]
    """
    for match in _BRACES.finditer(text):
        slot = _read_slot(match)
        if slot is None:
            passage = match[0] if match["other"] is None else text[match.start() :]
            yield SlotFault(Message("template.slot", slot=_shorten(passage)), _ALLOWED)
        elif slot.name in texts:
            if slot.value:
                what = Message("template.slot-no-value", slot=_shorten(match[0]))
                yield SlotFault(what, Message("template.write-slot", name=slot.name))
        elif slot.name not in parameters:
            what = Message("template.slot-unknown", slot=_shorten(match[0]))
            yield SlotFault(what, suggest(slot.name, {*parameters, *texts}), slot.name)


def _read_slot(match: re.Match[str]) -> Slot | None:
    """The slot in braces; None where they do not form one."""
    named = _NAMED.fullmatch(match["inside"]) if match["other"] is None else None
    return Slot(named["name"], named["value"] is not None) if named else None


def _shorten(text: str) -> str:
    """The beginning of a passage, in one line."""
    line = " ".join(text[: 2 * _LONGEST_SHOWN].split())
    return line if len(line) <= _LONGEST_SHOWN else f"{line[: _LONGEST_SHOWN - 1]}…"
