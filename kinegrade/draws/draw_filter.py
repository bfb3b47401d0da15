"""Filtering a question's deck: which of its combinations are good enough for students, and why the
others are not.

A part of the order can be filtered alone, in any process: what is found depends on the question,
the secret and the positions only. Many combinations are looked at together, because that costs
little more than looking at one.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, fields
from functools import cached_property
from typing import assert_never

from kinegrade.draws.deck import Combination, Deck
from kinegrade.draws.examining import (
    Reason,
    Refused,
    examine_together,
    find_too_fine,
    solve_sensible,
)
from kinegrade.mechanics.plan import Plan
from kinegrade.numbers.tolerance import Tolerance
from kinegrade.problem.solution import Solution
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.template import Template
from kinegrade.students.separation import Separation, collect_columns, find_separation

# Combinations from which it is judged which mistakes can be kept apart from the truth
_SAMPLE = 400
# Solutions that a process keeps for a question
_KEPT = 50

Verdict = Reason | None  # why a combination is refused; None for a good one


@dataclass(frozen=True)
class DrawFilter:
    """The filter of one question: `tolerances` holds for the asks it names, 1 % for the others.

    With `four_decimals` every right answer is still right when given to four decimals.
    """

    template: Template
    asks: tuple[str, ...]
    deck: Deck
    tolerances: Mapping[str, Tolerance]
    four_decimals: bool = False

    def __getstate__(self) -> dict[str, object]:
        """What another process receives; it works out the rest itself."""
        return {each.name: getattr(self, each.name) for each in fields(self)}

    def verdicts(self, part: range) -> tuple[Verdict, ...]:
        """The verdict on the combination at each position of a part of the order."""
        combinations = [self.deck.combination(position) for position in part]
        verdicts: list[Verdict] = [
            "mistake" if one else None for one in self.confused(combinations)
        ]
        left = [place for place, verdict in enumerate(verdicts) if verdict is None]
        found = examine_together(
            self.template,
            [combinations[place] for place in left],
            self.asks,
            self.plan,
            self.tolerances,
        )
        for place, one in zip(left, found, strict=True):
            verdicts[place] = self._verdict(one)
            self._keep(combinations[place], one)
        return tuple(verdicts)

    def solved(self, values: Combination) -> Solution:
        """The solution of a combination. Raises MechanismError for one that has none, which the
        filter would have refused.

        The filter is not asked again: what was dealt stays dealt when filters change.
        """
        found = self._solutions.pop(tuple(values.values()), None)
        return found or solve_template(self.template, values, self.asks, self.plan)

    def confused(self, combinations: Sequence[Combination]) -> list[bool]:
        """For each combination, whether a known mistake leads to an answer within tolerance."""
        if self.separation is None or not combinations:
            return [False] * len(combinations)
        flags: list[bool] = self.separation.confuses(collect_columns(combinations)).tolist()
        return flags

    @cached_property
    def separation(self) -> Separation | None:
        """Which mistakes are kept apart from the truth; None if nothing is asked, as with a
        template whose asks are all on request, or if no instance of the sample can be asked.
        """
        if self.plan is None or not self.asks:
            return None
        asks = {name: self.template.asks[name] for name in self.asks}
        sample = collect_columns(self._sample)
        return find_separation(self.template, asks, self.tolerances, self.plan, sample)

    @cached_property
    def plan(self) -> Plan | None:
        """The plan by which every instance is solved: that of the first sensible one of the sample,
        None where there is none.
        """
        for values in self._sample:
            with suppress(Refused):
                return solve_sensible(self.template, values, self.asks, None).motion.plan
        return None

    def _keep(self, values: Combination, found: Solution | Refused) -> None:
        """Keep a solution until it is asked for, unless there are many."""
        if isinstance(found, Solution) and len(self._solutions) < _KEPT:
            self._solutions[tuple(values.values())] = found

    @cached_property
    def _solutions(self) -> dict[tuple[str, ...], Solution]:
        """Solutions found by the filter in this process, by their values: a combination need not be
        solved again when its paper is set.
        """
        return {}

    @cached_property
    def _sample(self) -> list[Combination]:
        """Combinations that do not depend on the secret."""
        return Deck(self.deck.domains, "sample", self.template.name).first(_SAMPLE)

    def _verdict(self, found: Solution | Refused) -> Verdict:
        """The verdict on an instance in which no mistake is taken for the truth."""
        match found:
            case Refused(reason=reason):
                return reason
            case Solution():
                fine = self.four_decimals and find_too_fine(found, self.tolerances)
                return "decimals" if fine else None
            case _:
                assert_never(found)
