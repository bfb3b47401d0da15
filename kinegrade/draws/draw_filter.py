"""Filtering a question's deck: which of its combinations are good enough for students, and why the
others are not.

A part of the order can be filtered alone, in any process: what is found depends on the question,
the secret and the positions only. Many combinations are screened together, because that costs
little more than screening one.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, fields
from functools import cached_property
from typing import TYPE_CHECKING, assert_never

from kinegrade.draws.dealt import DealtDraws
from kinegrade.draws.deck import Combination, Deck
from kinegrade.draws.earlier import NONE_EARLIER, EarlierDraws
from kinegrade.draws.examining import (
    Examined,
    Reason,
    Refused,
    find_too_fine,
    name_reason,
    require_legible,
    require_room,
    solve_sensible,
)
from kinegrade.errors import Problem
from kinegrade.figure.sketch import Sketcher, sketch
from kinegrade.language.message import Message
from kinegrade.mechanics.plan import Plan
from kinegrade.numbers.tolerance import USUAL_CARRY, Tolerance
from kinegrade.problem.printed_givens import mark_question
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.hints import FigureHints
from kinegrade.problem.template.template import Template
from kinegrade.students.rounding.accuracy import Accuracy
from kinegrade.students.rounding.rounding import Rounding, take_one

if TYPE_CHECKING:
    from kinegrade.students.separation import Separation

# Combinations from which it is judged which mistakes can be kept apart from the truth
_SAMPLE = 400
_TOGETHER = 100  # combinations that are screened at once, whatever part of them is asked for

Verdict = Reason | None  # why a combination is refused; None for a good one
_WIDEN = Message("template.widen")


@dataclass(frozen=True)
class _Screened:
    """A combination, why doubles refuse it already, and the `roundings` of students by ask."""

    values: Combination
    refusal: Refused | None
    roundings: Mapping[str, Rounding[float]]


@dataclass(frozen=True)
class DrawFilter:
    """The filter of one question, by the tolerances of the asks it names, the significant figures
    that students `carry`, and the `honest` asks whose tolerance may be widened; see `Accuracy`.
    What is among the `earlier` draws is refused.

    With `four_decimals` every right answer is still right when given to four decimals. Figures are
    drawn last, by `sketcher`, for what would be dealt otherwise. `widening` says how there are more
    values to be drawn.
    """

    template: Template
    asks: tuple[str, ...]
    deck: Deck
    tolerances: Mapping[str, Tolerance]
    four_decimals: bool = False
    carry: int = USUAL_CARRY
    honest: frozenset[str] = frozenset()
    sketcher: Sketcher = sketch
    earlier: EarlierDraws = NONE_EARLIER
    widening: Message = _WIDEN

    def __getstate__(self) -> dict[str, object]:
        """What another process receives; it works out the rest itself."""
        return {each.name: getattr(self, each.name) for each in fields(self)}

    @property
    def accuracy(self) -> Accuracy:
        """What accuracy the question asks for."""
        return Accuracy(self.tolerances, self.carry, self.honest)

    def verdicts(self, part: range) -> tuple[Verdict, ...]:
        """The verdict on the combination at each position of a part of the order."""
        return tuple(self._judge(self._find_screened(position)) for position in part)

    def _judge(self, screened: _Screened) -> Verdict:
        """The verdict on a combination; what was found is kept for its paper."""
        if self.earlier.has(screened.values):
            return "earlier"
        found = self._examine_screened(screened)
        match found:
            case Refused(reason=reason):
                return reason
            case Examined():
                self.dealt.keep(screened.values, found)
                return None
            case _:
                assert_never(found)

    def examine(self, combinations: Sequence[Combination]) -> list[Examined | Refused]:
        """For each combination what is fit for students, or why it is not."""
        return [self._examine_screened(each) for each in self._screen(combinations)]

    def _find_screened(self, position: int) -> _Screened:
        """The combination at a position, screened with those before and after it."""
        number, place = divmod(position, _TOGETHER)
        if number not in self._blocks:
            self._blocks.clear()
            first = number * _TOGETHER
            block = range(first, min(first + _TOGETHER, self.deck.size))
            self._blocks[number] = self._screen([self.deck.combination(each) for each in block])
        return self._blocks[number][place]

    def _screen(self, combinations: Sequence[Combination]) -> list[_Screened]:
        """Combinations looked at in doubles, all at once."""
        if self.separation is None or not combinations:
            return [_Screened(values, None, {}) for values in combinations]
        from kinegrade.draws.screening import screen
        from kinegrade.students.comparison import collect_columns

        seen = self.separation.compare(collect_columns(combinations))
        refusals = screen(self.separation, self.accuracy, seen)
        return [
            _Screened(values, refusal, take_one(seen.roundings, place))
            for place, (values, refusal) in enumerate(zip(combinations, refusals, strict=True))
        ]

    def _examine_screened(self, screened: _Screened) -> Examined | Refused:
        return screened.refusal or self._examine_one(screened.values, screened.roundings)

    def explain_first(self) -> Problem:
        """Why the first combination is refused, as an example; "" where it is good."""
        (found,) = self.examine([self.deck.combination(0)])
        return found.detail if isinstance(found, Refused) else ""

    def _examine_one(
        self, values: Combination, roundings: Mapping[str, Rounding[float]]
    ) -> Examined | Refused:
        """An instance in which no mistake is taken for the truth."""
        try:
            solution = solve_sensible(self.template, values, self.asks, self.plan)
            examined = require_room(solution, self.accuracy, roundings)
        except Refused as refusal:
            return refusal
        zero = self._find_zero_by_chance(solution)
        if zero:
            return Refused("degenerate", Message("template.is-zero", ask=zero), zero)
        fine = self.four_decimals and find_too_fine(examined)
        if fine:
            return Refused("decimals", name_reason("decimals"), fine)
        try:
            require_legible(solution, self._marks, self.sketcher)
        except Refused as refusal:
            return refusal
        return examined

    @cached_property
    def _marks(self) -> FigureHints:
        """What the figure of the question marks."""
        return mark_question(self.template, self.asks)

    def _find_zero_by_chance(self, solution: Solution) -> str:
        """The first ask whose answer is zero here and not in all draws, which would be easier than
        the others; "" where there is none.
        """
        always = self.separation.zero if self.separation else frozenset()
        zero = (name for name, answer in solution.answers.items() if answer.is_zero)
        return next((name for name in zero if name not in always), "")

    @cached_property
    def separation(self) -> Separation | None:
        """Which mistakes are kept apart from the truth; None if nothing is asked, as with a
        template whose asks are all on request, or if no instance of the sample can be asked.
        """
        if self.plan is None or not self.asks:
            return None
        from kinegrade.students.comparison import collect_columns
        from kinegrade.students.kept_apart import find_separation

        asks = {name: self.template.asks[name] for name in self.asks}
        sample = collect_columns(self._sample.first(_SAMPLE))
        return find_separation(self.template, asks, self.accuracy, self.plan, sample)

    @cached_property
    def dealt(self) -> DealtDraws:
        """The question at the values that are dealt, each solved once."""
        return DealtDraws(self.template, self.asks, self.accuracy, self.plan)

    @cached_property
    def plan(self) -> Plan | None:
        """The plan of every instance: that of the first sensible one of the sample, if any."""
        for values in self._sample.walk(_SAMPLE):
            with suppress(Refused):
                return solve_sensible(self.template, values, self.asks, None).motion.plan
        return None

    @cached_property
    def _blocks(self) -> dict[int, list[_Screened]]:
        """The combinations that were screened last, by the number of their block."""
        return {}

    @property
    def _sample(self) -> Deck:
        """Combinations in an order that does not depend on the secret."""
        return Deck(self.deck.domains, "sample", self.template.name)
