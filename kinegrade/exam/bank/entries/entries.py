"""The entries [[questions]] of a bank's file: a template by its name, or some that are drawn by
family or tag.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from functools import cached_property, partial
from pathlib import Path
from typing import NamedTuple, assert_never

from msgspec import Struct
from msgspec.structs import replace

from kinegrade.errors import FieldError, KinegradeError, suggest
from kinegrade.exam.bank.blueprint import BankAsk, BankQuestion, Chosen, Dealing, Slot
from kinegrade.exam.bank.by_hand import HandQuestion, read_hand_question
from kinegrade.exam.bank.entries.alternatives import require_different, require_equal_points
from kinegrade.exam.bank.entries.asks import read_asks, read_kind, weigh_asks
from kinegrade.exam.bank.entries.domains import read_domains
from kinegrade.exam.bank.entries.kinds import ENTRY_KEYS, find_kind, read_dealing
from kinegrade.exam.bank.shipped_templates import Grouping, Shelf, read_shelf
from kinegrade.exam.bank.terms import BankTolerance, read_bank_tolerance, read_room
from kinegrade.files.fields.document import read_text, toml_table
from kinegrade.files.fields.faults import Faults
from kinegrade.files.fields.table import Table
from kinegrade.files.fields.values import flag, found, text, whole
from kinegrade.language.message import Message, Quoted
from kinegrade.problem.template.library.library import load_kept_template, load_template
from kinegrade.problem.template.sections.opening import TEMPLATE
from kinegrade.problem.template.template import Template

MAX_QUESTIONS = 50
_ANY_EXAMPLE = '["slider-crank", "four-bar-parallel-coupler"]'
_TEMPLATE_FILE = re.compile(r"[\w. -]{1,100}\.toml")


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
    """Reads entries; `folder` holds the shipped templates, others are in the folder `beside`.

    For a bank that is `kept` with an exam, `folder` holds exactly the templates that were chosen,
    including those that were beside the bank; rules introduced after the exam do not refuse them.
    `space` is the room for working where an entry states none.
    """

    faults: Faults
    folder: Path
    beside: Path
    kept: bool = False
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
        template = entry.required("template", self._template)
        if template is None:
            return ()
        asks = read_asks(entry, template, read_bank_tolerance(entry, wider))
        domains = read_domains(entry, template, kept=self.kept)
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
        own = read_own_question(entry, stated, self.folder if self.kept else None)
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
        templates = entry.listing("any", self._template, _ANY_EXAMPLE)
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
        pool = entry.required(by, partial(self._having, by)) if self._shelf.templates else None
        if not pool:
            return []
        names = [template.name for template in pool]
        named = text if self.kept else partial(_read_left_out, names)
        without = entry.listing("without", named, '["slider-crank"]')
        if set(names) <= set(without):
            what = Message(f"bank.none-of-{by}-left", name=Quoted(str(entry.value(by))))
            entry.fault("without", what, do=Message("bank.leave-out-fewer"))
        left = [template for template in pool if template.name not in without]
        if not self.kept:
            self._check_statements(left)
        return left

    def _check_statements(self, templates: Iterable[Template]) -> None:
        """Notes what the statements of templates lack that may be drawn; others are not held up."""
        # An exam's own copies have been checked
        from kinegrade.problem.statement_faults import check_statements  # noqa: PLC0415

        for template in templates:
            try:
                check_statements(template)
            except KinegradeError as error:
                self.faults.note_error((), error)

    def _having(self, by: Grouping, word: object) -> tuple[Template, ...]:
        """The shipped templates of a family or with a tag."""
        having = self._shelf.having(by, str(word))
        if not having:
            what = Message(f"bank.unknown-{by}", name=found(word))
            raise FieldError(what, do=suggest(str(word), self._shelf.known(by)))
        return having

    @cached_property
    def _shelf(self) -> Shelf:
        """All shipped templates, read when an entry first draws from them; none after a fault."""
        try:
            return read_shelf(self.folder, kept=self.kept)
        except KinegradeError as error:
            self.faults.note_error((), error)
        return Shelf({}, {"family": {}, "tag": {}})

    def _template(self, value: object) -> Template:
        """A shipped template, or a file beside the bank; the exam's copy where the bank is kept."""
        name = text(value)
        beside = name.endswith(".toml")
        if beside and not _TEMPLATE_FILE.fullmatch(name):
            raise FieldError(found(name), Message("bank.file-beside"))
        if self.kept:
            return load_kept_template(name.removesuffix(".toml"), self.folder)
        template = load_template(str(self.beside / name) if beside else name, self.folder)
        if not beside:
            _require_alone(template, self.beside / f"{name}.toml")
        from kinegrade.problem.statement_faults import check_statements  # noqa: PLC0415

        check_statements(template)
        return template


def _require_alone(shipped: Template, own: Path) -> None:
    """Raises FieldError where a file beside the bank has the name of a shipped template, and
    another text: it may be the one that is meant, unless it is a bank itself.
    """
    text = read_text(own, TEMPLATE) if own.exists() else shipped.file.text
    if text != shipped.file.text and "questions" not in toml_table(own.name, text, TEMPLATE):
        what = Message("bank.own-and-shipped", file=Quoted(own.name))
        raise FieldError(what, do=Message("bank.name-own", file=Quoted(own.name)))


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
