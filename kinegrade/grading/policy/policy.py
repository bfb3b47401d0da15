"""A policy: how a class is marked differently from what the papers say, after the exam.

`policy_reading` makes one from a file and documents its grammar; `marks` marks by it, and
`decision` applies the ruling for one answer box. Without a policy the exam folder alone decides.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Set
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Literal, assert_never

from kinegrade.exam.folder.asks import Ask
from kinegrade.exam.folder.keys import Key
from kinegrade.expressions.tree import Expression
from kinegrade.grade_scale.stated import StatedScale
from kinegrade.grading.lateness.rule import NO_PENALTIES, Penalties
from kinegrade.grading.typed.conversion import Conversion
from kinegrade.numbers.tolerance import Tolerance
from kinegrade.stated_marking import StatedTolerance

Attempts = Literal["last", "first", "best"]
Void = Literal["full", "drop"]


NO_ROOM = StatedTolerance()
FULL_CREDIT = Fraction(1)  # share of the points


@dataclass(frozen=True, slots=True)
class Accepted:
    """Another answer that counts: `credit` is its share of the points; `students` is None where it
    counts for all. Where it does not `lead`, no later answer has credit for following from it.

    `scale` converts the value of `tree` to the ask's unit. `number` is its position in the policy,
    from 1; `text` is the value as written there.
    """

    number: int
    text: str
    tree: Expression
    scale: Conversion
    credit: Fraction
    students: frozenset[str] | None
    leads: bool = True


@dataclass(frozen=True, slots=True)
class Ruling:
    """What a policy says about one ask; by default, nothing. Credits are shares of its points.

    `follow_through` is the credit for an answer that follows from the student's wrong answer to an
    earlier ask.
    """

    room: StatedTolerance = NO_ROOM
    void: Void | None = None
    points: Fraction | None = None
    wrong_unit: Fraction = Fraction(0)
    mistakes: Mapping[str, Fraction] = field(default_factory=dict, hash=False)
    accepted: tuple[Accepted, ...] = ()
    follow_through: Fraction = FULL_CREDIT

    def ask(self, ask: Ask) -> Ask:
        """The ask with its points under the policy; a dropped ask has none."""
        match self.void:
            case "drop":
                return replace(ask, points=Fraction(0))
            case "full" | None:
                return ask if self.points is None else replace(ask, points=self.points)
            case _:
                assert_never(self.void)

    def key(self, key: Key) -> Key:
        """A key with its tolerance under the policy."""
        return self.beside(key, key.value)

    def beside(self, key: Key, value: Fraction) -> Key:
        """A key for another value, by the rule that `key` has under the policy."""
        return Key(value, self.rule(key.rule), key.period, key.mistakes)

    def rule(self, printed: Tolerance) -> Tolerance:
        """The rule that holds where the paper prints another."""
        if self.room == NO_ROOM:
            return printed
        stated = self.room.over(
            StatedTolerance(printed.relative, printed.absolute, printed.figures)
        )
        return Tolerance(
            stated.relative or Fraction(0), stated.absolute or Fraction(0), stated.figures
        )


@dataclass(frozen=True, slots=True)
class Policy:
    """Which of a student's rows counts, and a ruling for each answer column that has one; `text` is
    the content of the file, `scale` says which grades totals earn, `penalties` what is subtracted
    from them. Of the questions that only hands mark, those `dropped_by_hand` count for nobody.
    """

    attempts: Attempts = "last"
    rulings: Mapping[str, Ruling] = field(default_factory=dict, hash=False)
    text: str = ""
    scale: StatedScale | None = None
    penalties: Penalties = NO_PENALTIES
    dropped_by_hand: frozenset[str] = frozenset()

    def list_given(self, asks: Iterable[Ask]) -> Mapping[str, Fraction]:
        """The points that everybody gets who handed in, by answer column."""
        ruled = ((ask, self.ruling(ask.column)) for ask in asks)
        return {ask.column: each.ask(ask).points for ask, each in ruled if each.void == "full"}

    @property
    def dropped(self) -> Set[str]:
        """The answer columns that count for nobody."""
        return {column for column, each in self.rulings.items() if each.void == "drop"}

    def ruling(self, column: str) -> Ruling:
        """The ruling for an answer column."""
        return self.rulings.get(column, _AS_PRINTED)


_AS_PRINTED = Ruling()
AS_PRINTED = Policy()
