"""The entries [[questions]] of a bank's file: a template by its name, or some that are drawn by
family or tag.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import NamedTuple, assert_never

from msgspec import Struct
from msgspec.structs import replace

from kinegrade.errors import FieldError, suggest
from kinegrade.exam.bank.blueprint import BankAsk, BankQuestion, Chosen, Dealing, Slot
from kinegrade.exam.bank.by_hand import HandQuestion, read_hand_question
from kinegrade.exam.bank.entries.alternatives import require_different, require_equal_points
from kinegrade.exam.bank.entries.asks import read_asks, read_kind, weigh_asks
from kinegrade.exam.bank.entries.domains import read_domains
from kinegrade.exam.bank.entries.kinds import ENTRY_KEYS, find_kind, read_dealing
from kinegrade.exam.bank.entries.named_templates import NamedTemplates
from kinegrade.exam.bank.shipped_templates import Grouping
from kinegrade.exam.bank.terms import BankTolerance, read_bank_tolerance, read_room
from kinegrade.files.fields.table import Table
from kinegrade.files.fields.values import flag, found, text, whole
from kinegrade.language.message import Message, Quoted
from kinegrade.problem.template.template import Template

MAX_QUESTIONS = 50
_ANY_EXAMPLE = '["slider-crank", "four-bar-parallel-coupler"]'


class _Terms(NamedTuple):
    """The room for working, how numbers are dealt, whether the points are a bonus, and what the
    entry is.
    """

    space: float
    dealing: Dealing
    bonus: bool
    chosen: Chosen


class Entry(Struct, frozen=True):
    """An entry of the bank and the questions it stands for, or the one to be marked `by_hand`."""

    table: Table
    slots: tuple[Slot, ...]
    by_hand: HandQuestion | None = None

    @property
    def count(self) -> int:
        """How many questions it stands for."""
        return sum(slot.count for slot in self.slots) + (self.by_hand is not None)


class Entries(Struct, frozen=True, dict=True):
    """Reads entries; `space` is the room for working where an entry states none."""

    templates: NamedTemplates
    space: float = 0.0

    def read(self, entry: Table, first: int, wider: BankTolerance) -> Entry:
        """One entry with its questions, numbered from `first`; none if it cannot be read."""
        by, identifier = find_kind(entry), f"q{first}"
        match by:
            case None:
                return Entry(entry, ())
            case "text":
                return Entry(entry, (), read_hand_question(entry, identifier, self.space))
            case "steps":
                return Entry(entry, self._own(entry.only(*ENTRY_KEYS[by]), identifier, wider))
            case "template":
                known = entry.only(*ENTRY_KEYS[by])
                return Entry(entry, self._named(known, identifier, wider))
            case "any":
                known = entry.only(*ENTRY_KEYS[by])
                return Entry(entry, self._given(known, identifier, wider))
            case "family" | "tag":
                if not entry.required(by, text):
                    return Entry(entry, ())
                known = entry.only(*ENTRY_KEYS[by])
                return Entry(entry, self._drawn(known, by, first, wider))
            case _:
                assert_never(by)

    def _named(self, entry: Table, identifier: str, wider: BankTolerance) -> tuple[Slot, ...]:
        """The question of a template that the bank names."""
        template = entry.required("template", self.templates.named)
        if template is None:
            return ()
        asks = read_asks(entry, template, read_bank_tolerance(entry, wider))
        domains = read_domains(entry, template, kept=self.templates.kept)
        question = BankQuestion(
            identifier, template, asks, domains, *self._read_terms(entry, "template")
        )
        return (Slot(identifier, (question,), drawn=False),)

    def _own(self, entry: Table, identifier: str, wider: BankTolerance) -> tuple[Slot, ...]:
        """The question that an entry states with steps of its own."""
        # Few banks have questions of their own
        from kinegrade.exam.bank.entries.own_questions import read_own_question  # noqa: PLC0415

        stated = read_bank_tolerance(entry, wider)
        terms = self._read_terms(entry, "steps")
        own = read_own_question(
            entry, stated, self.templates.folder if self.templates.kept else None
        )
        if own is None:
            return ()
        question = BankQuestion(identifier, own.template, own.asks, {}, *terms)
        return (Slot(identifier, (question,), drawn=False),)

    def _drawn(
        self, entry: Table, by: Grouping, first: int, wider: BankTolerance
    ) -> tuple[Slot, ...]:
        """The questions whose templates are drawn by family or tag."""
        number = entry.with_default("number", whole(1, MAX_QUESTIONS), 1)
        entry_tolerance = read_bank_tolerance(entry, wider)
        terms = self._read_terms(entry, by)
        per_student = entry.with_default("per-student", flag, False)
        kind = read_kind(entry)
        pool = self._pool(entry, by)
        if kind is None:
            return ()
        asks = weigh_asks(entry, pool, kind, entry_tolerance)
        choice = [(each, asks[each.name]) for each in pool if each.name in asks]
        if pool and not choice:
            name = Quoted(str(entry.value(by)))
            entry.fault("asks", Message(f"bank.none-of-{by}-asked", name=name))
        if not choice:
            return ()
        if per_student:
            require_equal_points(entry, choice)
            return (replace(_make_slot(f"q{first}", choice, terms), given=number),)
        return tuple(_make_slot(f"q{first + index}", choice, terms) for index in range(number))

    def _given(self, entry: Table, identifier: str, wider: BankTolerance) -> tuple[Slot, ...]:
        """The question of which each student gets one of the templates that the bank names."""
        entry_tolerance = read_bank_tolerance(entry, wider)
        terms, kind = self._read_terms(entry, "any"), read_kind(entry)
        templates = entry.listing("any", self.templates.named, _ANY_EXAMPLE)
        require_different(entry, templates)
        if kind is None or len(templates) < 2:
            return ()
        asks = weigh_asks(entry, templates, kind, entry_tolerance)
        for each in templates:
            if each.name not in asks:
                entry.fault("asks", Message("bank.gives-no-points", template=each.name))
        choice = [(each, asks[each.name]) for each in templates if each.name in asks]
        require_equal_points(entry, choice)
        return (replace(_make_slot(identifier, choice, terms), drawn=False, given=1),)

    def _read_terms(self, entry: Table, chosen: Chosen) -> _Terms:
        """What holds for each question of an entry with a template."""
        return _Terms(
            entry.with_default("space", read_room, self.space),
            read_dealing(entry),
            entry.with_default("bonus", flag, False),
            chosen,
        )

    def _pool(self, entry: Table, by: Grouping) -> list[Template]:
        """The templates of a family or with a tag, without those that the entry leaves out."""
        pool = (
            entry.required(by, partial(self.templates.having, by))
            if self.templates.has_shipped
            else None
        )
        if not pool:
            return []
        names = [template.name for template in pool]
        named = text if self.templates.kept else partial(_read_left_out, names)
        without = entry.listing("without", named, '["slider-crank"]')
        if set(names) <= set(without):
            what = Message(f"bank.none-of-{by}-left", name=Quoted(str(entry.value(by))))
            entry.fault("without", what, do=Message("bank.leave-out-fewer"))
        left = [template for template in pool if template.name not in without]
        if not self.templates.kept:
            self.templates.check_statements(left)
        return left


def _make_slot(
    identifier: str, choice: Sequence[tuple[Template, tuple[BankAsk, ...]]], terms: _Terms
) -> Slot:
    """A question that becomes one of these templates with their asks."""
    questions = (BankQuestion(identifier, template, asks, {}, *terms) for template, asks in choice)
    return Slot(identifier, tuple(questions), drawn=True)


def _read_left_out(names: Sequence[str], value: object) -> str:
    """The name of a template that is not to be drawn; it must be one of those that could be."""
    name = text(value)
    if name not in names:
        what = Message("bank.not-drawn-anyway", name=found(name))
        raise FieldError(what, do=suggest(name, names))
    return name
