"""The text of a statement taken apart: what stands as it is, and the slots that are filled in.

A slot is `{{ name }}`, or a name with one of a few parts behind a point, and nothing else: there is
no language behind it. So a template from a stranger can print what it has, and do no more.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping
from functools import lru_cache
from itertools import pairwise
from typing import Literal, assert_never, get_args

from msgspec import Struct

from kinegrade.errors import suggest
from kinegrade.language.message import Message, Text
from kinegrade.numbers.units import is_unit
from kinegrade.problem.template.driven import Drives

_BRACES = re.compile(r"\{\{(?P<inside>.*?)\}\}|(?P<other>\{\{|\{%|\{#)", re.DOTALL)
_NAMED = re.compile(r"\s*(?P<name>[A-Za-z_]\w*)(?:\s*\.\s*(?P<part>[a-z]+))?\s*", re.ASCII)
_LONGEST_SHOWN = 40
_WORD = re.compile(r"\s*([a-z°][^\s,.;:)，。；：]*)")
_OTHER_WORDS = ("in", "turn")  # units that prose has for other things
_DOLLARS = re.compile(r"(?<!\\)\$\$?")
_ALLOWED = Message("template.slots-allowed")


Part = Literal["", "value", "size", "turning", "moving"]
_VALUES: tuple[Part, ...] = ("", "value", "size")
_PARTS: Mapping[str, Part] = {part: part for part in get_args(Part)}


class Slot(Struct, frozen=True):
    """A place in a text where something is filled in: a text, or a given with its symbol; by its
    `part` a given's number alone or without its sign, or how something driven goes.
    """

    name: str
    part: Part

    def list_givens(self, driven: Drives) -> frozenset[str]:
        """The givens that it prints, or the text."""
        match self.part:
            case "" | "value" | "size":
                return frozenset({self.name})
            case "turning" | "moving":
                return driven[self.part][self.name].givens
            case _:
                assert_never(self.part)


class Fillings(Struct, frozen=True):
    """What the slots of a text may name: givens, texts, and what inputs drive."""

    givens: Collection[str]
    texts: Collection[str]
    driven: Drives

    def list_names(self, part: Part) -> frozenset[str]:
        """The names that may stand before a part."""
        match part:
            case "":
                return frozenset((*self.givens, *self.texts))
            case "value" | "size":
                return frozenset(self.givens)
            case "turning" | "moving":
                return frozenset(self.driven[part])
            case _:
                assert_never(part)


class SlotFault(Struct, frozen=True):
    """What is wrong with a slot: `name` is the unknown name, "" where the fault is another one."""

    what: Message
    do: Text
    name: str = ""


@lru_cache(maxsize=1024)
def split_slots(text: str) -> tuple[str | Slot, ...]:
    """A text in pieces, in order; braces that hold anything but a name stay as they are.

    >>> split_slots("the crank {{ r }} of {{ l.value }}")
    ('the crank ', Slot(name='r', part=''), ' of ', Slot(name='l', part='value'))
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


def find_slots(text: str) -> tuple[Slot, ...]:
    """The slots of a text, in order."""
    return tuple(piece for piece in split_slots(text) if isinstance(piece, Slot))


def find_slots_in_formulas(text: str) -> tuple[Slot, ...]:
    """The slots between dollar signs; what is filled in brings its own dollar signs.

    >>> find_slots_in_formulas("$r$ is {{ r.value }}, and $v = {{ v.value }}$")
    (Slot(name='v', part='value'),)
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


def find_units_behind(text: str) -> Iterator[tuple[Slot, str]]:
    """The units that are typed behind slots of values, which print their own.

    >>> [unit for _, unit in find_units_behind("at {{ n.value }} rad/s with {{ r }} in a slot")]
    ['rad/s']
    """
    pieces = split_slots(text)
    for slot, behind in pairwise(pieces):
        word = _WORD.match(behind) if isinstance(behind, str) else None
        if not isinstance(slot, Slot) or slot.part not in _VALUES or word is None:
            continue
        if word[1] not in _OTHER_WORDS and is_unit(word[1]):
            yield slot, word[1]


def _find_open_formula(opened: str, mark: str) -> str:
    """What formula is open after dollar signs: "" for none. Two signs also end one formula and
    begin another.
    """
    if not opened:
        return mark
    if opened == mark:
        return ""
    return opened


def find_slot_faults(text: str, fillings: Fillings) -> Iterator[SlotFault]:
    """What is wrong with the slots of a text that may name these.

    >>> known = Fillings(["r"], [], {"turning": {}, "moving": {}})
    >>> [fault.what for fault in find_slot_faults("{{ 7*7 }} {{ r }}", known)]
    [Message('template.slot', slot='{{ 7*7 }}')]
    """
    for match in _BRACES.finditer(text):
        slot = _read_slot(match)
        if slot is None:
            passage = match[0] if match["other"] is None else text[match.start() :]
            yield SlotFault(Message("template.slot", slot=_shorten(passage)), _ALLOWED)
        elif slot.name not in fillings.list_names(slot.part):
            yield _explain_unknown(slot, _shorten(match[0]), fillings)


def _explain_unknown(slot: Slot, written: str, fillings: Fillings) -> SlotFault:
    """That a slot names nothing that has such a part."""
    match slot.part:
        case "" | "value" | "size" if slot.name in fillings.texts:
            what = Message("template.slot-no-value", slot=written)
            return SlotFault(what, Message("template.write-slot", name=slot.name))
        case "" | "value" | "size":
            known = {*fillings.givens, *fillings.texts}
            what = Message("template.slot-unknown", slot=written)
        case "turning" | "moving":
            known = {*fillings.list_names(slot.part)}
            what = Message(f"template.slot-not-{slot.part}", slot=written)
        case _:
            assert_never(slot.part)
    return SlotFault(what, suggest(slot.name, known), slot.name)


def _read_slot(match: re.Match[str]) -> Slot | None:
    """The slot in braces; None where they do not form one."""
    named = _NAMED.fullmatch(match["inside"]) if match["other"] is None else None
    part = _PARTS.get(named["part"] or "") if named else None
    return Slot(named["name"], part) if named and part is not None else None


def _shorten(text: str) -> str:
    """The beginning of a passage, in one line."""
    line = " ".join(text[: 2 * _LONGEST_SHOWN].split())
    return line if len(line) <= _LONGEST_SHOWN else f"{line[: _LONGEST_SHOWN - 1]}…"
