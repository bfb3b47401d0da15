"""A policy: how a class is marked in another way than the papers say, after the exam is over.

`policy_reading` makes one from a file, where its grammar stands; `marks` marks by it, `decision`
applies the ruling for one answer box. Without a policy everything is as the exam folder has it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Literal, assert_never

from kinegrade.exam.folder.keys import Ask, Key, rule
from kinegrade.expression import Expression
from kinegrade.grading.unit_spelling import Conversion
from kinegrade.stated_marking import StatedTolerance

Attempts = Literal["last", "first", "best"]
Void = Literal["full", "drop"]


NO_ROOM = StatedTolerance()
FULL_CREDIT = Fraction(1)  # share of the points


@dataclass(frozen=True, slots=True)
class Accepted:
    """An answer that counts too: `credit` is its share of the points; `students` is None where it
    counts for all.

    `scale` brings the value of `tree` into the ask's unit. `number` is its place in the policy,
    from 1; `text` is as it stands there.
    """

    number: int
    text: str
    tree: Expression
    scale: Conversion
    credit: Fraction
    students: frozenset[str] | None


@dataclass(frozen=True, slots=True)
class Ruling:
    """What a policy says about one ask; as it stands here, nothing. Credits are shares of its
    points.

    `follow_through` is that of an answer that follows from the student's own wrong answer to an
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
        """The ask with the points it has now; a dropped one has none."""
        match self.void:
            case "drop":
                return replace(ask, points=Fraction(0))
            case "full" | None:
                return ask if self.points is None else replace(ask, points=self.points)
            case _:
                assert_never(self.void)

    def key(self, key: Key) -> Key:
        """A key with the tolerance it has now."""
        return key if self.room == NO_ROOM else self.beside(key, key.value)

    def beside(self, key: Key, value: Fraction) -> Key:
        """A key for another value, by the same rule as `key` has now."""
        stated = key.rule or rule(Fraction(0), key.tolerance)
        room = self.room.over(StatedTolerance(stated.relative, stated.absolute, stated.figures))
        now = rule(room.relative or Fraction(0), room.absolute or Fraction(0), room.figures)
        return now.key(value, key.period, key.mistakes)


@dataclass(frozen=True, slots=True)
class Policy:
    """Which of a student's rows counts, and a ruling for each answer column that has one; `text` is
    the file's.
    """

    attempts: Attempts = "last"
    rulings: Mapping[str, Ruling] = field(default_factory=dict, hash=False)
    text: str = ""

    def ruling(self, column: str) -> Ruling:
        """The ruling for an answer column."""
        return self.rulings.get(column, _AS_PRINTED)


_AS_PRINTED = Ruling()
AS_PRINTED = Policy()
