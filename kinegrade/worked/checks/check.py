"""A check of a result by another way: two sides worked out with the numbers printed before, which
agree where no slip has been made.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

from kinegrade.language.math.width import measure_row
from kinegrade.language.message import Message
from kinegrade.mechanics.rates import Rate
from kinegrade.worked.case import Case
from kinegrade.worked.deductions.deductions import explain_deduction
from kinegrade.worked.document import Block
from kinegrade.worked.formulas.atoms import ZERO, list_summands
from kinegrade.worked.formulas.equation import WIDEST, Equation, Link, approximate, equate
from kinegrade.worked.formulas.exactness import is_rounded
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.measures import double
from kinegrade.worked.formulas.notation import PLAIN
from kinegrade.worked.formulas.numbers import state_number
from kinegrade.worked.vectors.projection import Deduction
from kinegrade.worked.vectors.stage import Stage
from kinegrade.worked.vectors.vectors import name_part

_AT_A_GLANCE = 2 * WIDEST  # letters of both sides
_LONGEST = 4 * WIDEST  # of those that are told where no shorter one is found
_CLOSE = 1e-9  # relative: far below a digit that is printed


@dataclass(frozen=True)
class Lacking:
    """A vector that the answers do without, with the deduction that gives it."""

    stage: Stage
    deduction: Deduction
    solved: frozenset[Rate]

    def explain(self) -> Iterator[Block]:
        """The deduction, under what it is for."""
        (rate,) = self.deduction.unknowns
        ((equation, part),) = self.stage.occurrences(rate)
        vector = self.stage.case.text(name_part(equation, part, self.stage.case, bold=True))
        yield self.stage.case.say(Message("solution.check-needs", vector=vector))
        yield from explain_deduction(self.stage, self.deduction, self.solved)


@dataclass(frozen=True)
class Check:
    """By which way, and what either side amounts to; `lacking` is what the check alone needs,
    `sums` the terms of both sides where they stand there by a short name.
    """

    way: Message
    left: Equation
    right: Equation
    lacking: tuple[Lacking, ...] = ()
    sums: tuple[Formula, Formula] | None = None

    @cached_property
    def letters(self) -> float:
        """The letters of both sides."""
        return sum(measure_row(side.print_inline(PLAIN)) for side in (self.left, self.right))

    @property
    def is_telling(self) -> bool:
        """Whether the sides are not the same from the start, term by term, and can be read."""
        return bool(self._list_uncancelled()) and self.letters <= _LONGEST

    def _list_uncancelled(self) -> list[Formula]:
        """What is left where each term goes against the same one on the other side, or beside
        itself with the other sign.
        """
        left = list[Formula]()
        first, second = self.sums or (self.left.left, self.right.left)
        for one in (*list_summands(first), *list_summands(-second)):
            if -one in left:
                left.remove(-one)
            elif one != ZERO:
                left.append(one)
        return left

    @property
    def is_one_sided(self) -> bool:
        """Whether one of the sides is zero."""
        return ZERO in (self.left.left, self.right.left)

    @property
    def is_short(self) -> bool:
        """Whether the sides are read at a glance."""
        return self.letters <= _AT_A_GLANCE

    def say(self, case: Case) -> Iterator[Block]:
        """The check in one sentence, after the vectors that it needs."""
        for one in self.lacking:
            yield from one.explain()
        left, right = map(case.tell, (self.left, self.right))
        said = case.say(Message("solution.check", way=self.way, left=left, right=right))
        yield replace(said, compact=True)


@dataclass(frozen=True)
class Side:
    """One side in numbers, and its value in SI; in letters first where it has such, told by the
    `short` ones where there are.
    """

    numbers: Formula
    value: Any
    letters: Formula | None = None
    short: Formula | None = None

    @property
    def sum(self) -> Formula:
        """Its terms, in letters where it has such."""
        return self.letters or self.numbers

    def work_out(self, unit: str) -> Equation:
        """The side with its value; alone where it is nothing but a value."""
        letters = self.short or self.letters
        if letters is None:
            return Equation(self.numbers, self._find_value(unit))
        return Equation(letters, (*equate(self.numbers), *self._find_value(unit)))

    def _find_value(self, unit: str) -> tuple[Link, ...]:
        if self.numbers.is_decimal:
            return ()
        *_, decimal = state_number(self.value, unit)
        alone = self.letters is None and is_rounded(self.numbers)
        return approximate(decimal.right) if alone else (decimal,)


def choose_check(checks: Iterable[Check]) -> Check | None:
    """The first check that tells something and is short, else the shortest of those that tell."""
    telling = list[Check]()
    for check in checks:
        if check.is_telling:
            if check.is_short:
                return check
            telling.append(check)
    return min(telling, key=lambda check: check.letters, default=None)


def compare(way: Message, left: Side, right: Side, unit: str, largest: float = 0.0) -> Check:
    """The check of two sides in one unit; where only the errors of doubles tell their values apart,
    measured by the larger of the left side and `largest`, both are rounded alike.
    """
    greatest = max(abs(double(left.value)), largest)
    same = abs(double(left.value) - double(right.value)) < _CLOSE * greatest
    other = replace(right, value=left.value) if same else right
    sides = left.work_out(unit), other.work_out(unit)
    return Check(way, *sides, sums=(left.sum, right.sum))
