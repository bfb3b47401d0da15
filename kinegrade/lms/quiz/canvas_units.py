"""The units in which Canvas asks: the same for a whole class, fine enough for the four decimals
that it keeps.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace

from kinegrade.exam.quiz_document import QuizAsk
from kinegrade.problem.kept_decimals import RightRange, fitting_factor, units

Place = tuple[str, str]  # the question and the ask


@dataclass(frozen=True)
class ClassUnits:
    """How many times finer than on paper the unit of each ask is, by question and ask."""

    factors: Mapping[Place, int]

    def fitted(self, question: str, ask: QuizAsk) -> QuizAsk | None:
        """The ask in the class's unit; None where its right answer is wrong with four decimals in
        every unit.
        """
        factor = fitting_factor(ask.unit, _right(ask))
        if factor is None:
            return None
        return _finer(ask, max(factor, self.factors.get((question, ask.identifier), 1)))


def class_units(asks: Iterable[tuple[str, QuizAsk]]) -> ClassUnits:
    """The units for a class with these asks: for each the finest that any answer needs."""
    factors: dict[Place, int] = {}
    for question, ask in asks:
        place = question, ask.identifier
        factor = fitting_factor(ask.unit, _right(ask)) or 1
        factors[place] = max(factor, factors.get(place, 1))
    return ClassUnits(factors)


def edges_kept(ask: QuizAsk) -> bool:
    """Whether four decimals are enough for answers at the limits of the tolerance, too."""
    return _right(ask).fits


def _right(ask: QuizAsk) -> RightRange:
    return RightRange(ask.value, ask.low, ask.high)


def _finer(ask: QuizAsk, factor: int) -> QuizAsk:
    """The ask in a unit that is finer by a factor, without the answers of known mistakes."""
    if factor == 1:
        return ask
    unit = next(unit for unit, each in units(ask.unit) if each == factor)
    right = _right(ask).times(factor)
    return replace(ask, unit=unit, value=right.value, low=right.low, high=right.high, mistakes=())
