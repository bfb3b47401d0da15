"""A policy's file: how to mark a class again, in another way than the papers say.

    attempts = "best"     # which of a student's rows counts: "last" (as without a policy), "first"
                          # or "best"
    tolerance = { relative = "2 %" }     # and absolute (in the ask's unit), figures; what is not
                                         # stated stays
    credit = { follow-through = "1/2", wrong-unit = "50 %", mistakes = { sense-reversed = 0.5 } }
                          # shares of the points; follow-through is for an answer that follows from
                          # the student's wrong answer to an earlier ask: all of them where nothing
                          # is stated, 0 turns it off

    [questions.q1]        # a question can have a tolerance and credits, and so can an ask
    void = "drop"         # its points leave everybody's total, or "full": everybody who handed in
                          # gets them
    [questions.q2.asks.v_B]
    tolerance = { figures = 2 }
    points = 3            # instead of those on the paper
    accept = [            # answers that count too
      { value = "2*sqrt(3)", unit = "m/s" },           # without a unit, in that of the ask
      { value = "r*omega", credit = "1/2" },           # of this paper's numbers: parameters and
                                                       # right answers, in SI
      { value = "-v_B", student = ["007", "0012"] },   # for some students only
    ]

What stands nearer to the ask goes before what stands further out, number by number. Of all that
applies to an answer, the best credit counts. What the exam's bank says about credit
(`kinegrade.exam.bank_credit`) stands further out than all of it. `read_policy` and `stated_policy`
are called by `grade`.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cached_property
from pathlib import Path
from typing import Any

from kinegrade.angular import is_angle
from kinegrade.errors import ExpressionError, PolicyError, did_you_mean
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.folder.keys import Ask, questions
from kinegrade.expression import Expression, names, read
from kinegrade.fields.document import FileKind, read_text, toml_table
from kinegrade.grading.number_text import Unreadable
from kinegrade.grading.policy import NO_ROOM, Accepted, Attempts, Policy, Room, Ruling, Void
from kinegrade.grading.policy_values import Values, shown, written
from kinegrade.grading.unit_spelling import Conversion, WrongUnit, conversion, written_unit

_POLICY_FILE = FileKind("a policy file", PolicyError, 1_000_000)
_ATTEMPTS = ("last", "first", "best")
_VOIDS = ("full", "drop")


@dataclass(frozen=True, slots=True)
class _Level:
    """What the exam, a question or an ask says for the answer boxes in it."""

    room: Room = NO_ROOM
    void: Void | None = None
    wrong_unit: Fraction | None = None
    mistakes: Mapping[str, Fraction] = field(default_factory=dict)
    follow_through: Fraction | None = None

    def over(self, wider: _Level) -> _Level:
        return _Level(
            self.room.over(wider.room),
            self.void or wider.void,
            wider.wrong_unit if self.wrong_unit is None else self.wrong_unit,
            {**wider.mistakes, **self.mistakes},
            wider.follow_through if self.follow_through is None else self.follow_through,
        )


_CREDITS = ("follow-through", "wrong-unit", "mistakes")


def read_policy(path: Path, exam: ExamFolder) -> Policy:
    """The policy in a file, for the asks of that exam. Raises PolicyError with all faults at
    once.
    """
    text = read_text(path, _POLICY_FILE)
    table = toml_table(str(path), text, _POLICY_FILE).content
    return _Reader(Values(path), exam).policy(table, text, _stated(exam))


def stated_policy(exam: ExamFolder) -> Policy:
    """What holds without a policy, by the credit table of the exam's bank. Raises PolicyError."""
    return _Reader(Values(exam.head_file), exam).policy({}, "", _stated(exam))


def _stated(exam: ExamFolder) -> _Level:
    values = Values(exam.head_file)
    table = values.table("credit", exam.head.credit, _CREDITS)
    level = _credited(values, "", table, table.get("mistakes") or ())
    if values.faults:
        raise PolicyError(
            *(f"{fault} - restore the exam folder as it was generated" for fault in values.faults)
        )
    return level


def _credited(
    values: Values, inside: str, credit: Mapping[str, Any], known: Iterable[str]
) -> _Level:
    """A credit table, of which the mistakes are some of those `known`."""
    named = values.named(f"{inside}credit.mistakes", credit.get("mistakes"), known, "mistake")
    shares = {name: values.share(f"{inside}credit.mistakes.{name}", share) for name, share in named}
    return _Level(
        wrong_unit=values.share(f"{inside}credit.wrong-unit", credit.get("wrong-unit")),
        mistakes={name: share for name, share in shares.items() if share is not None},
        follow_through=values.share(f"{inside}credit.follow-through", credit.get("follow-through")),
    )


class _Reader:
    """Reads one policy for one exam."""

    def __init__(self, values: Values, exam: ExamFolder) -> None:
        self.values, self.exam = values, exam
        self.students = set(exam.students)

    @cached_property
    def mistakes(self) -> frozenset[str]:
        """All that lead to a wrong answer on some paper.

        The papers are read for them only where a policy names one.
        """
        return frozenset(
            name for paper in self.exam.papers() for key in paper.keys for name in key.mistakes
        )

    def policy(self, content: Mapping[str, Any], text: str, stated: _Level) -> Policy:
        table = self.values.table("", content, ("attempts", "tolerance", "credit", "questions"))
        attempts: Attempts = (
            self.values.word("attempts", table.get("attempts"), _ATTEMPTS) or "last"
        )
        rulings = self._rulings(self._level("", table).over(stated), table.get("questions"))
        if self.values.faults:
            raise PolicyError(*self.values.faults)
        return Policy(attempts, rulings, text)

    def _rulings(self, wider: _Level, content: Any) -> dict[str, Ruling]:
        tables = dict(
            self.values.named("questions", content, questions(self.exam.asks), "question")
        )
        rulings: dict[str, Ruling] = {}
        for question in questions(self.exam.asks):
            place, asks = (
                f"questions.{question}",
                [ask for ask in self.exam.asks if ask.question == question],
            )
            table = self.values.table(
                place, tables.get(question), ("tolerance", "credit", "void", "asks")
            )
            level = self._level(place, table).over(wider)
            named = dict(
                self.values.named(
                    f"{place}.asks", table.get("asks"), [ask.ask for ask in asks], "ask"
                )
            )
            rulings |= {
                ask.column: self._ruling(f"{place}.asks.{ask.ask}", ask, named.get(ask.ask), level)
                for ask in asks
            }
        return rulings

    def _ruling(self, place: str, ask: Ask, content: Any, wider: _Level) -> Ruling:
        table = self.values.table(
            place, content, ("tolerance", "credit", "void", "points", "accept")
        )
        level = self._level(place, table).over(wider)
        points = self.values.amount(f"{place}.points", table.get("points"))
        accepted = tuple(self._accepted(f"{place}.accept", ask, table.get("accept")))
        return Ruling(
            level.room,
            level.void,
            points,
            level.wrong_unit or Fraction(0),
            level.mistakes,
            accepted,
            Fraction(1) if level.follow_through is None else level.follow_through,
        )

    def _level(self, place: str, table: Mapping[str, Any]) -> _Level:
        inside = f"{place}." if place else ""
        credit = self.values.table(f"{inside}credit", table.get("credit"), _CREDITS)
        credited = _credited(
            self.values, inside, credit, self.mistakes if "mistakes" in credit else ()
        )
        return replace(
            credited,
            room=self.values.room(f"{inside}tolerance", table.get("tolerance")),
            void=self.values.word(f"{inside}void", table.get("void"), _VOIDS),
        )

    def _accepted(self, place: str, ask: Ask, content: Any) -> Iterator[Accepted]:
        if not isinstance(content, list | None):
            self.values.fault(place, 'expected a list like [{ value = "2*sqrt(3)" }]')
            return
        for number, entry in enumerate(content or [], 1):
            here = f"{place}[{number}]"
            table = self.values.table(here, entry, ("value", "unit", "credit", "student"))
            credit = self.values.share(f"{here}.credit", table.get("credit", 1))
            students = self._students(f"{here}.student", table.get("student"))
            tree = self._tree(f"{here}.value", table.get("value"))
            if tree is not None and credit is not None:
                scale = self._scale(here, ask, tree, table.get("unit"))
                yield Accepted(number, written(table["value"]), tree, scale, credit, students)

    def _students(self, place: str, content: Any) -> frozenset[str] | None:
        listed: Sequence[Any] = (
            content if isinstance(content, list) else [] if content is None else [content]
        )
        for student in listed:
            if not isinstance(student, str):
                self.values.fault(
                    place, f"expected a student's id in quotation marks, not {written(student)!r}"
                )
            elif student not in self.students:
                self.values.fault(
                    place, f'no student "{shown(student)}": {_likely(student, self.students)}'
                )
        return (
            None if content is None else frozenset(each for each in listed if isinstance(each, str))
        )

    def _tree(self, place: str, content: Any) -> Expression | None:
        if isinstance(content, bool) or not isinstance(content, str | int):
            self.values.fault(place, 'expected a number or an expression like "2*sqrt(3)"')
            return None
        try:
            return read(str(content))
        except ExpressionError as fault:
            self.values.fault(place, str(fault))
            return None

    def _scale(self, place: str, ask: Ask, tree: Expression, unit: Any) -> Conversion:
        """What the value is to be multiplied by: as its unit says.

        A value of givens, or of angles, is in SI.
        """
        question = [other for other in self.exam.asks if other.question == ask.question]
        units = {other.ask: other.unit for other in question}
        used = [name for name in names(tree) if name != "pi"]
        if set(used) - units.keys():
            drawn = self.exam.parameters(self.exam.students[0], ask.question)
            units |= {name: each.unit for name, each in drawn.items()}
        for name in sorted(set(used) - units.keys()):
            self.values.fault(
                f"{place}.value", f'unknown name "{name}": {did_you_mean(name, units)}'
            )
        if unit is not None:
            return self._typed_unit(f"{place}.unit", ask, unit)
        angles = frozenset(name for name in used if units.get(name) in ("deg", "rad"))
        own = written_unit(ask.unit)
        return (
            Conversion(1 / own.factor, -own.pi)
            if own and (used or is_angle(tree, angles))
            else Conversion()
        )

    def _typed_unit(self, place: str, ask: Ask, unit: Any) -> Conversion:
        try:
            if isinstance(unit, str):
                return conversion(unit, ask.unit)
            self.values.fault(place, f'expected a unit like "{ask.unit}", not {written(unit)!r}')
        except (WrongUnit, Unreadable) as fault:
            self.values.fault(place, str(fault))
        return Conversion()


def _likely(student: str, students: set[str]) -> str:
    """A hint that does not list a whole class."""
    hint = did_you_mean(student, students)
    return (
        hint.partition(" (known")[0]
        if hint.startswith("did")
        else "check the id against the roster"
    )
