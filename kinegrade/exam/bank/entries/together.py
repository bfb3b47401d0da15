"""What the questions of a bank have to be together, whatever each is alone."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction

from kinegrade.exam.bank.blueprint import Slot, list_wishes, name_templates
from kinegrade.exam.bank.entries.alternatives import MOST_ALTERNATIVES
from kinegrade.exam.bank.entries.entries import MAX_QUESTIONS, Entry
from kinegrade.exam.bank.matching import match_slots
from kinegrade.files.fields.table import Table
from kinegrade.language.message import Message, Quoted
from kinegrade.numbers.tolerance import MOST_CARRY
from kinegrade.problem.template.template import TemplateFile
from kinegrade.problem.template.translated import Translated


def require_fit(table: Table, entries: Sequence[Entry]) -> None:
    """A fault for each thing in which the entries of a bank's table do not make an exam."""
    slots = tuple(slot for entry in entries for slot in entry.slots)
    if not slots and all(entry.by_hand is not None for entry in entries):
        table.fault("questions", Message("bank.all-by-hand"), Message("bank.one-with-template"))
    if slots and all(slot.candidates[0].bonus for slot in slots):
        table.fault("questions", Message("bank.all-bonus"), Message("bank.one-that-counts"))
    count = sum(entry.count for entry in entries)
    if count > MAX_QUESTIONS:
        what = Message("bank.questions", count=count)
        table.fault("questions", what, Message("bank.questions-at-most", most=MAX_QUESTIONS))
    _require_different_names(entries)
    _require_one_explanation(entries)
    _require_enough(entries, slots)
    _require_alternatives(entries, slots)


def _require_alternatives(entries: Sequence[Entry], slots: Sequence[Slot]) -> None:
    """A fault where what is drawn for each student leaves no choice, is more than there are letters
    for, or might give a student one template twice.
    """
    named = name_templates(slots)
    seen: dict[str, str] = {}
    drawn = [(entry, slot) for entry in entries for slot in entry.slots if slot.drawn]
    for entry, slot in drawn:
        if not slot.given:
            continue
        left = [each.template.name for each in slot.candidates if each.template.name not in named]
        if not slot.given < len(left) <= MOST_ALTERNATIVES:
            what = Message("bank.templates-to-give", count=len(left))
            entry.table.fault(
                "per-student",
                what,
                Message("bank.more-than-given", given=slot.given, most=MOST_ALTERNATIVES),
                Message("bank.choose-without"),
            )
        for name in left:
            other = seen.setdefault(name, slot.identifier)
            if other != slot.identifier:
                what = Message("bank.given-twice", template=name, question=other)
                entry.table.fault("per-student", what, do=Message("bank.choose-without"))
                break


def _require_different_names(entries: Sequence[Entry]) -> None:
    """A fault where two different template files share a name: the exam folder keeps one file per
    name.
    """
    files: dict[str, TemplateFile] = {}
    for entry in entries:
        named = (slot.candidates for slot in entry.slots if not slot.drawn)
        for template in (each.template for candidates in named for each in candidates):
            if files.setdefault(template.name, template.file) != template.file:
                shared = template.scheme.has_mechanism
                entry.table.fault(
                    "template" if shared else "name",
                    Message("bank.name-taken", name=Quoted(template.name)),
                    do=Message("bank.rename-file" if shared else "bank.rename"),
                )


def _require_one_explanation(entries: Sequence[Entry]) -> None:
    """A fault for each mistake that two entries explain in different words: marks name it by its
    identifier alone.
    """
    told: dict[str, Translated] = {}
    for entry in entries:
        for template in (slot.candidates[0].template for slot in entry.slots):
            for mistake in template.scheme.mistakes:
                if told.setdefault(mistake.identifier, mistake.means) != mistake.means:
                    what = Message("bank.mistake-told-twice", name=Quoted(mistake.identifier))
                    place = (*entry.table.place, "mistakes", mistake.identifier)
                    entry.table.faults.note(place, what, do=Message("bank.tell-alike"))


def _require_enough(entries: Sequence[Entry], slots: Sequence[Slot]) -> None:
    """A fault if there are not enough templates to give every question a different one."""
    chosen = match_slots(list_wishes(slots, lambda slot, name: 0))
    for entry in entries:
        once = [slot for slot in entry.slots if not slot.given]
        count = len(once)
        left = sum(not slot.drawn or slot.identifier in chosen for slot in once)
        if left < count:
            entry.table.fault(
                "number",
                Message("bank.too-few-templates", count=count, left=left),
                do=Message("bank.draw-fewer"),
            )


def require_carried(entries: Iterable[Entry], carry: int) -> None:
    """A fault for each entry with an ask whose tolerance the figures carried cannot meet."""
    for entry in entries:
        first = (slot.candidates if slot.given else slot.candidates[:1] for slot in entry.slots)
        asks = (ask for candidates in first for each in candidates for ask in each.asks)
        needed = {ask.name: ask.tolerance.carried(Fraction(0)) for ask in asks}
        for name, figures in needed.items():
            if figures > carry:
                more = Message("bank.carry-or-allow-more", figures=figures)
                entry.table.fault(
                    None,
                    Message("bank.takes-figures", ask=name, figures=figures),
                    Message("bank.figures-carried", carry=carry),
                    more if figures <= MOST_CARRY else Message("bank.allow-more"),
                )
