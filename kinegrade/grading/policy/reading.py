"""A policy file: how to mark a class again, differently from what the papers say.

`keys` lists what may be written in it. A setting nearer to the ask overrides one further out,
number by number. Of everything that applies to an answer, the best credit counts. What the exam's
bank says about credit (`kinegrade.stated_marking`) is furthest out of all. `read_policy` and
`stated_policy` are called by `grade`.
"""

from __future__ import annotations

from collections.abc import Mapping, Set
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from pathlib import Path
from typing import get_args

from kinegrade.errors import PolicyError, suggest
from kinegrade.exam.folder.asks import Ask, add_counted, list_questions
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.files.fields.document import FileKind, parsed_table, read_text, toml_table
from kinegrade.files.fields.table import Table
from kinegrade.files.fields.values import amount, choice, whole
from kinegrade.grade_scale.stated import StatedScale, read_scale
from kinegrade.grading.lateness.reading import read_penalties
from kinegrade.grading.policy import keys
from kinegrade.grading.policy.accepted_reading import AcceptedReader
from kinegrade.grading.policy.policy import FULL_CREDIT, NO_ROOM, Attempts, Policy, Ruling, Void
from kinegrade.language.message import Message, Quoted, Text, list_all
from kinegrade.marks_folder.layout import POLICY
from kinegrade.stated_marking import (
    HONEST,
    StatedCredit,
    StatedTolerance,
    find_identifier,
    read_credit,
    read_tolerance,
)

_POLICY_FILE = FileKind(Message("policy.file"), PolicyError, 1_000_000)
_HEAD_FILE = FileKind(Message("policy.exam-head"), PolicyError, 0, Message("policy.restore-exam"))
_ATTEMPTS: tuple[Attempts, ...] = get_args(Attempts)
_VOIDS: tuple[Void, ...] = get_args(Void)
_FIGURES = whole(1, 15)


@dataclass(frozen=True, slots=True)
class _Level:
    """What the exam, a question or an ask says about the answer boxes in it."""

    room: StatedTolerance = NO_ROOM
    void: Void | None = None
    credit: StatedCredit = field(default_factory=StatedCredit)

    def over(self, wider: _Level) -> _Level:
        return _Level(
            self.room.over(wider.room),
            self.void or wider.void,
            self.credit.over(wider.credit),
        )


def read_policy(path: Path, exam: ExamFolder) -> Policy:
    """The policy in a file, for the asks of that exam. Raises PolicyError with all faults at
    once.
    """
    text = read_text(path, _POLICY_FILE)
    table = toml_table(str(path), text, _POLICY_FILE)
    return _Reader(exam).policy(table, text, _read_stated(exam))


def read_kept_policy(marks: Path, exam: ExamFolder) -> Policy:
    """The policy by which the class was marked whose marks stand in a folder. Raises
    PolicyError.
    """
    kept = marks / POLICY
    return read_policy(kept, exam) if kept.exists() else stated_policy(exam)


def stated_policy(exam: ExamFolder) -> Policy:
    """What applies without a policy: the credit table of the exam's bank. Raises PolicyError."""
    nothing = parsed_table(str(exam.head_file), {}, _POLICY_FILE)
    return _Reader(exam).policy(nothing, "", _read_stated(exam))


def _read_stated(exam: ExamFolder) -> _Level:
    """What the exam's bank states, as kept in exam.json."""
    content = {} if exam.head.credit is None else {"credit": exam.head.credit}
    head = parsed_table(str(exam.head_file), content, _HEAD_FILE)
    level = _Level(credit=read_credit(head, lambda: head.table("credit").table("mistakes")))
    head.faults.require_none()
    return level


def _read_stated_scale(exam: ExamFolder) -> StatedScale | None:
    """The scale of the exam's bank, as kept in exam.json. Raises PolicyError."""
    content = {} if exam.head.scale is None else {"scale": exam.head.scale}
    head = parsed_table(str(exam.head_file), content, _HEAD_FILE)
    scale = read_scale(head)
    head.faults.require_none()
    return scale


class _Reader:
    """Reads one policy for one exam."""

    def __init__(self, exam: ExamFolder) -> None:
        self.exam = exam
        self.accepted = AcceptedReader(exam, frozenset(exam.students))

    @cached_property
    def mistakes(self) -> frozenset[str]:
        """All mistakes that lead to a wrong answer on some paper.

        The papers are read for these only where a policy names one.
        """
        return frozenset(
            find_identifier(label)
            for paper in self.exam.papers()
            for key in paper.keys
            for label in key.mistakes
        )

    def policy(self, content: Table, text: str, stated: _Level) -> Policy:
        """A whole file; raises PolicyError when anything is at fault."""
        table = content.only(*keys.POLICY)
        attempts: Attempts = table.with_default("attempts", choice(_ATTEMPTS), "last")
        level = self._level(table).over(stated)
        questions = self._questions(table)
        rulings = self._rulings(questions, level)
        dropped = self._dropped_by_hand(questions)
        scale, penalties = read_scale(table), read_penalties(table, self.exam)
        self._require_any_counted(table, rulings, dropped)
        table.faults.require_none()
        scale = scale or _read_stated_scale(self.exam)
        return Policy(attempts, rulings, text, scale, penalties, dropped)

    def _require_any_counted(
        self, content: Table, rulings: Mapping[str, Ruling], dropped: Set[str]
    ) -> None:
        """Notes that a policy drops all that counts, bonus aside: everybody would fail."""
        asks = (rulings[ask.column].ask(ask) for ask in self.exam.asks)
        hands = [each for each in self.exam.head.by_hand if each.question not in dropped]
        drops = dropped or any(each.void == "drop" for each in rulings.values())
        if drops and not add_counted(asks) and all(each.bonus for each in hands):
            do = Message("policy.leave-one")
            content.fault(None, Message("policy.nothing-counts"), do=do)

    @property
    def by_hand(self) -> tuple[str, ...]:
        """The questions that only hands mark."""
        return tuple(each.question for each in self.exam.head.by_hand)

    def _questions(self, content: Table) -> Table:
        """The tables of the questions."""
        known = *list_questions(self.exam.asks), *self.by_hand
        unknown = Message("fields.unknown-question")
        return content.table("questions").only(*known, unknown=unknown, hint=self._explain_question)

    def _dropped_by_hand(self, tables: Table) -> frozenset[str]:
        """The questions that only hands mark and that count for nobody."""
        return frozenset(each for each in self.by_hand if self._is_dropped(tables.table(each)))

    def _is_dropped(self, content: Table) -> bool:
        """Whether a question that only hands mark is dropped; points for all are given by hand."""
        table = content.only(*keys.QUESTION_BY_HAND, hint=_explain_by_hand)
        void: Void | None = table.optional("void", choice(_VOIDS))
        if void == "full":
            table.fault("void", Message("policy.full-by-hand"), do=_explain_by_hand("void"))
        return void == "drop"

    def _rulings(self, tables: Table, wider: _Level) -> dict[str, Ruling]:
        """A ruling for each answer column."""
        rulings: dict[str, Ruling] = {}
        for question in list_questions(self.exam.asks):
            table = tables.table(question).only(*keys.QUESTION)
            level = self._level(table).over(wider)
            asks = [ask for ask in self.exam.asks if ask.question == question]
            asked = table.table("asks").only(
                *(ask.ask for ask in asks), unknown=Message("fields.unknown-ask")
            )
            for ask in asks:
                rulings[ask.column] = self._ruling(asked.table(ask.ask), ask, level)
        return rulings

    def _explain_question(self, name: str) -> Text:
        """What is to be done about the name of a question that there is not."""
        known = [*list_questions(self.exam.asks), *self.by_hand]
        parts = [each for each in known if each[:-1] == name and each[-1].isalpha()]
        if parts:
            return Message("policy.alternatives-apart", questions=list_all(map(Quoted, parts)))
        return suggest(name, known)

    def _ruling(self, content: Table, ask: Ask, wider: _Level) -> Ruling:
        """What applies to one ask."""
        table = content.only(*keys.ASK)
        level = self._level(table).over(wider)
        credit = level.credit
        return Ruling(
            room=level.room,
            void=level.void,
            points=table.optional("points", amount),
            wrong_unit=credit.wrong_unit or Fraction(0),
            mistakes=credit.mistakes,
            accepted=tuple(self.accepted.read(table, ask)),
            follow_through=FULL_CREDIT if credit.follow_through is None else credit.follow_through,
        )

    def _level(self, table: Table) -> _Level:
        """What a table says about all answer boxes in it."""
        return _Level(
            _read_room(table),
            table.optional("void", choice(_VOIDS)),
            read_credit(table, lambda: self.mistakes),
        )


def _explain_by_hand(_: str) -> Text:
    """What is to be done about a rule for a question that only hands mark."""
    return Message("policy.marked-by-hand")


def _read_room(table: Table) -> StatedTolerance:
    """The tolerance that a table states; an honest one is found as a paper is set, never later."""
    stated = table.value("tolerance")
    if stated == HONEST or (isinstance(stated, Mapping) and HONEST in stated):
        what, expected = Message("policy.honest"), Message("policy.a-tolerance")
        table.fault("tolerance", what, expected, Message("policy.honest-in-bank"))
        return StatedTolerance()
    return read_tolerance(table, _FIGURES)
