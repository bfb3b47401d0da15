"""A solution whose answers say what known mistakes lead to."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING

from kinegrade.problem.solution import Solution

if TYPE_CHECKING:
    from kinegrade.students.mistaking.mistakes import Mistakes


@dataclass(frozen=True)
class _Consequences:
    """What known mistakes lead to at one instance; worked out, for all asks at once, when it is
    first asked for.
    """

    solution: Solution

    @cached_property
    def mistakes(self) -> Mistakes:
        """The mistakes of this instance."""
        # Arrays take long to load
        from kinegrade.students.mistaking.mistakes import Mistakes  # noqa: PLC0415

        solution = self.solution
        asks = {name: solution.template.asks[name] for name in solution.answers}
        values = solution.assembly.values
        return Mistakes(solution.template, asks, values, solution.motion.plan)

    def __call__(self, ask: str, right: float) -> Mapping[str, float]:
        """The values that differ from the right one, by the mistakes' identifiers."""
        return self.mistakes.of(ask, right)


def attach_mistakes(solution: Solution) -> Solution:
    """The solution with answers of which `mistakes` has what known ones lead to."""
    consequences = _Consequences(solution)
    answers = {
        name: replace(answer, consequences=consequences)
        for name, answer in solution.answers.items()
    }
    return replace(solution, answers=answers)
