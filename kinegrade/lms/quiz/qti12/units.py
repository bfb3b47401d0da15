"""The units in which Canvas asks: the same for a whole class, fine enough for the four decimals
that it keeps.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace

from kinegrade.exam.quiz.document import QuizAsk
from kinegrade.students.rounding.kept_decimals import (
    RightRange,
    find_fitting_factor,
    list_finer_units,
)

Place = tuple[str, str]  # the question and the ask


@dataclass(frozen=True)
class ClassUnits:
    """How many times finer than on paper the unit of each ask is, by question and ask."""

    factors: Mapping[Place, int]

    def fitted(self, question: str, ask: QuizAsk) -> QuizAsk | None:
        """The ask in the class's unit; None where its right answer is wrong with four decimals in
        every unit.
        """
        factor = find_fitting_factor(ask.row.unit, _find_right_range(ask))
        if factor is None:
            return None
        return _refine(ask, max(factor, self.factors.get((question, ask.identifier), 1)))


def choose_class_units(asks: Iterable[tuple[str, QuizAsk]]) -> ClassUnits:
    """The units for a class with these asks: for each the finest that any answer needs."""
    factors: dict[Place, int] = {}
    for question, ask in asks:
        place = question, ask.identifier
        factor = find_fitting_factor(ask.row.unit, _find_right_range(ask)) or 1
        factors[place] = max(factor, factors.get(place, 1))
    return ClassUnits(factors)


def keeps_edges(ask: QuizAsk) -> bool:
    """Whether four decimals are enough for answers at the limits of the tolerance, too."""
    return _find_right_range(ask).fits


def _find_right_range(ask: QuizAsk) -> RightRange:
    return RightRange(ask.value, ask.low, ask.high)


def _refine(ask: QuizAsk, factor: int) -> QuizAsk:
    """The ask in a unit that is finer by a factor, without the answers of known mistakes."""
    if factor == 1:
        return ask
    unit = next(unit for unit, each in list_finer_units(ask.row.unit) if each == factor)
    right = _find_right_range(ask).times(factor)
    row = replace(ask.row, unit=unit)
    return replace(ask, row=row, value=right.value, low=right.low, high=right.high, mistakes=())
