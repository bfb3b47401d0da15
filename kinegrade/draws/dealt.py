"""A question at the values that are dealt: solved once however often it is asked for, with how
honest rounding bears on its answers.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

from kinegrade.draws.deck import Combination
from kinegrade.draws.examining import Examined
from kinegrade.mechanics.plan import Plan
from kinegrade.numbers.tolerance import Tolerance
from kinegrade.problem.solution import Solution
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.template import Template
from kinegrade.students.rounding.accuracy import Accuracy
from kinegrade.students.rounding.rounding import Rounding, take_one

if TYPE_CHECKING:
    from kinegrade.numbers.noting.pad import Doubles

# Solutions that a process keeps for a question: of those set last, and of those that the filter
# found, of which most are dealt and set once; each takes 16 kB
_KEPT, _FOUND = 50, 300


@dataclass(frozen=True)
class DealtDraws:
    """The asks of a question at the values that are dealt; `plan` is that of every instance, None
    where none can be worked out.
    """

    template: Template
    asks: tuple[str, ...]
    accuracy: Accuracy
    plan: Plan | None

    def solved(self, values: Combination) -> Solution:
        """The solution of a combination that was dealt. Raises MechanismError for one that has
        none, which the filter would have refused.

        The filter is not asked again: what was dealt stays dealt when filters change.
        """
        return self._find_dealt(values).solution

    def tolerances_of(self, values: Combination) -> Mapping[str, Tolerance]:
        """By ask how far an answer may be off at values that were dealt: as stated, or widened to
        what honest rounding takes; next to zero with the amount that is allowed there.
        """
        return self._find_dealt(values).tolerances

    def round_together(self, draws: Iterable[Combination]) -> None:
        """Bound honest rounding at the values of several papers that are set next, all at once,
        which takes little longer than for one.
        """
        self._rounded.clear()
        known = self._found.keys() | self._set.keys()
        new = [values for values in draws if tuple(values.values()) not in known]
        if new:
            found = self.round_draws(new, self.accuracy.carry)
            for place, values in enumerate(new):
                self._rounded[tuple(values.values())] = take_one(found, place)

    def _find_dealt(self, values: Combination) -> Examined:
        """A combination that was dealt, solved once however often it is asked for in a row."""
        identity = tuple(values.values())
        found = self._found.pop(identity, None) or self._set.pop(identity, None)
        while len(self._set) >= _KEPT:
            del self._set[next(iter(self._set))]
        self._set[identity] = found or self._work_out(values)
        return self._set[identity]

    def _work_out(self, values: Combination) -> Examined:
        """An instance, fit for students or not: what honest rounding would leave is as stated."""
        solution = solve_template(self.template, values, self.asks, self.plan)
        roundings = self._rounded.get(tuple(values.values()))
        if roundings is None:
            roundings = self.find_roundings(values)
        allowed = self.accuracy.allow(solution, roundings)
        stated = self.accuracy.state(solution, roundings)
        return Examined(solution, {name: allowed[name] or stated[name] for name in allowed})

    def find_roundings(self, values: Combination) -> Mapping[str, Rounding[float]]:
        """By ask how rounding to the figures that students carry bears on the answer at values."""
        return take_one(self.round_draws([values], self.accuracy.carry), 0)

    def round_draws(
        self, draws: Sequence[Combination], carry: int
    ) -> Mapping[str, Rounding[Doubles]]:
        """By ask how rounding to `carry` significant figures bears on the answer of each draw;
        nothing where no instance can be worked out.
        """
        if self.plan is None:
            return {}
        from kinegrade.students.comparison import collect_columns
        from kinegrade.students.mistaking.mistakes import convert_parameters
        from kinegrade.students.rounding.bounds import find_roundings

        asks = {name: self.template.asks[name] for name in self.asks}
        arrays = convert_parameters(self.template, collect_columns(draws))
        return find_roundings(self.template, asks, arrays, self.plan, carry)

    def keep(self, values: Combination, found: Examined) -> None:
        """Keep what the filter found until it is asked for, unless there is much."""
        if len(self._found) < _FOUND:
            self._found[tuple(values.values())] = found

    @cached_property
    def _found(self) -> dict[tuple[str, ...], Examined]:
        """What the filter found in this process, by its values: a combination need not be solved
        again when its paper is set.
        """
        return {}

    @cached_property
    def _set(self) -> dict[tuple[str, ...], Examined]:
        """What was dealt and asked for last, the latest at the end."""
        return {}

    @cached_property
    def _rounded(self) -> dict[tuple[str, ...], Mapping[str, Rounding[float]]]:
        """What `round_together` found last, by values."""
        return {}
