"""A check of a result by another way: two sides worked out with the numbers printed before, which
agree where no slip has been made.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Set
from dataclasses import dataclass, field, replace
from functools import cached_property

from kinegrade.language.math.tree import Row, list_nodes
from kinegrade.language.math.width import measure_row
from kinegrade.language.message import Message
from kinegrade.worked.case import Case
from kinegrade.worked.checks.sides import Side
from kinegrade.worked.document import Block
from kinegrade.worked.findings import Form
from kinegrade.worked.formulas.atoms import ZERO, list_summands
from kinegrade.worked.formulas.equation import WIDEST, Equation, equate
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.measures import double
from kinegrade.worked.formulas.notation import DIGITS, PLAIN, Notation
from kinegrade.worked.vectors.arms import introduce_lengths, name_length

_AT_A_GLANCE = 2 * WIDEST  # letters of both sides
_LONGEST = 5 * WIDEST  # of those that are told where no shorter one is found
_CLOSE = 1e-9  # relative: far below a digit that is printed


@dataclass(frozen=True)
class Check:
    """By which way, and what either side amounts to, in a unit; `arm` two points whose distance is
    told before, `form` what it says of rates, `points` whose vectors it takes as they have been
    found, `conditions` the formulas that stand in the way. It is content with the digits that the
    solution has without it, and says as many as both sides give: one whose terms nearly cancel
    would print all numbers of the page with seven.
    """

    way: Message
    sides: tuple[Side, Side]
    unit: str
    arm: tuple[str, str] | None = None
    form: Form = field(default_factory=dict)
    points: Set[str] = frozenset()
    conditions: tuple[Equation, ...] = ()

    @cached_property
    def digits(self) -> int:
        """How many digits of its value both sides give."""
        return self._count_digits(PLAIN)

    def _count_digits(self, notation: Notation) -> int:
        return min(side.count_digits(notation) for side in self.sides)

    @cached_property
    def _equations(self) -> tuple[Equation, Equation]:
        return self._work_out(PLAIN)

    def _work_out(self, notation: Notation) -> tuple[Equation, Equation]:
        digits = self._count_digits(notation)
        left, right = (side.work_out(self.unit, digits, notation) for side in self.sides)
        return left, right

    @cached_property
    def letters(self) -> float:
        """The letters of both sides, as many in every language."""
        return sum(measure_row(side.print_inline(PLAIN), words=False) for side in self._equations)

    @property
    def is_telling(self) -> bool:
        """Whether the sides are not the same from the start, term by term, and can be read."""
        return bool(self._list_uncancelled()) and self.letters <= _LONGEST and not self._is_empty

    @property
    def _is_empty(self) -> bool:
        """Whether either side is nothing but zero."""
        return all(side.numbers == ZERO for side in self.sides)

    def _list_uncancelled(self) -> list[Formula]:
        """What is left where each term goes against the same one on the other side, or beside
        itself with the other sign.
        """
        left = list[Formula]()
        first, second = (side.sum for side in self.sides)
        for one in (*list_summands(first), *list_summands(-second)):
            if -one in left:
                left.remove(-one)
            elif one != ZERO:
                left.append(one)
        return left

    @property
    def is_one_sided(self) -> bool:
        """Whether one of the sides is zero."""
        return ZERO in (side.left for side in self._equations)

    @property
    def is_short(self) -> bool:
        """Whether the sides are read at a glance."""
        return self.letters <= _AT_A_GLANCE

    def with_length(self, ends: tuple[str, str], case: Case) -> Check:
        """The check after the distance of two points, where it takes that."""
        letters = name_length(*ends, case).row
        sides = (side.print_inline(PLAIN) for side in self._equations)
        taken = any(_holds(side, letters) for side in sides)
        return replace(self, arm=ends) if taken else self

    def say(self, case: Case) -> Iterator[Block]:
        """The check in one sentence, after the length that it needs: the equation in letters, then
        both of its sides in numbers.
        """
        case.findings.is_checked = True
        for equation in introduce_lengths((self.arm,) if self.arm else (), case):
            here = case.say(Message("solution.here", equations=case.tell(equation)))
            yield replace(here, on_check=True)
        first, second = self._work_out(case.notation)
        stated = case.mention(Equation(first.left, equate(second.left)))
        left, right = (
            case.mention(side.drop_letters(worked))
            for side, worked in zip(self.sides, (first, second), strict=True)
        )
        for condition in self.conditions:
            case.tell(condition)
        digits = self._count_digits(case.notation)
        name = "solution.check-fewer" if 0 < digits < DIGITS else "solution.check"
        message = Message(
            name, way=self.way, equation=stated, left=left, right=right, digits=digits
        )
        yield replace(case.say(message), compact=True, on_check=True)


def _holds(formula: Row, letters: Row) -> bool:
    """Whether letters stand side by side in a formula."""
    nodes = tuple(list_nodes(formula))
    places = range(len(nodes) - len(letters) + 1)
    return any(nodes[place : place + len(letters)] == letters for place in places)


def choose_check(checks: Iterable[Check]) -> Check | None:
    """The first check that tells something and is short, else the shortest of those that tell."""
    telling = list[Check]()
    for check in checks:
        if check.is_telling:
            if check.is_short:
                return check
            telling.append(check)
    return min(telling, key=lambda check: check.letters, default=None)


def compare(
    way: Message,
    left: Side,
    right: Side,
    unit: str,
    *,
    form: Form | None = None,
    largest: float = 0.0,
) -> Check:
    """The check of two sides in one unit; where only the errors of doubles tell their values apart,
    measured by the larger of the left side and `largest`, both are rounded alike.
    """
    greatest = max(abs(double(left.value)), largest)
    same = abs(double(left.value) - double(right.value)) < _CLOSE * greatest
    other = replace(right, value=left.value) if same else right
    return Check(way, (left, other), unit, form=form or {})
