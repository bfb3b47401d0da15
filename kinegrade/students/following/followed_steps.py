"""What follows for a later step from a student's answers to earlier ones, in a question that has
named steps in place of a mechanism: the steps worked out again from there, in doubles.
"""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass
from math import isfinite, pi

from kinegrade.errors import KinegradeError
from kinegrade.expressions.evaluation import evaluate, make_elementary_functions
from kinegrade.numbers.doubles import Doubles
from kinegrade.problem.template.template import Ask, Template

_SAME = 1e-9  # relative: what is closer is not changed, only rounded
_VANISHING = 1e-3  # of the right answer: what is smaller follows from nothing sensible


@dataclass(frozen=True)
class StepFollower:
    """One instance, to be followed from a student's answers: its parameters in SI as doubles."""

    template: Template
    values: Mapping[str, float]

    def consequences(self, earlier: Mapping[str, float], later: str) -> tuple[float, ...]:
        """What follows for `later`, in its unit, from answers in theirs, all put in at once; empty
        where it does not depend on them, or nothing sensible follows.
        """
        right = self.right(later)
        answers = {name: value for name, value in earlier.items() if value and name != later}
        if right is None or not answers:
            return ()
        if all(_is_same(value, self.right(name)) for name, value in answers.items()):
            return (right,)
        value = self._read(later, answers)
        if value is None or abs(value) <= _VANISHING * abs(right) or _is_same(value, right):
            return ()
        return (value,)

    def right(self, name: str) -> float | None:
        """The right answer of an ask, in its unit; None where there is none."""
        return self._read(name, {})

    def _read(self, name: str, own: Mapping[str, float]) -> float | None:
        """An answer as it follows from a student's own; None where it has no value."""
        with Doubles().context(), suppress(KinegradeError, ArithmeticError):
            value = self._work_out(own)[name] / _count_unit(self.template.asks[name])
            return value if isfinite(value) else None
        return None

    def _work_out(self, own: Mapping[str, float]) -> dict[str, float]:
        """All steps in SI, the student's own values in place of those that were asked for."""
        arithmetic = Doubles()
        functions = make_elementary_functions(arithmetic)
        found: dict[str, float] = {**self.values, "pi": pi}
        for name, tree in self.template.scheme.steps.items():
            if name in own:
                found[name] = own[name] * _count_unit(self.template.asks[name])
            else:
                found[name] = float(evaluate(tree, found, functions, arithmetic))
        return found


def _count_unit(ask: Ask) -> float:
    """The unit of an ask in SI, in radians."""
    return pi / 180 if ask.unit.degrees else Doubles().scale(ask.unit.scale)


def _is_same(value: float, right: float | None) -> bool:
    """Whether a value is the right one, but for rounding."""
    return right is not None and abs(value - right) <= _SAME * abs(right)
