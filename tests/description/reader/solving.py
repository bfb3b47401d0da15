"""From a description and what is asked to numbers."""

from __future__ import annotations

import math
from collections.abc import Mapping
from functools import cache
from typing import Any

from tests.description.reader.answers import Answers
from tests.description.reader.centrode import AtInfinity, poles_on_the_way
from tests.description.reader.description import read_description
from tests.description.reader.kinematics import Mechanism, State
from tests.description.reader.positions import positions_of
from tests.description.reader.quantity_words import quantity
from tests.description.reader.units import factor_of


class Problem:
    """One description and what is asked."""

    def __init__(self, problem: Mapping[str, Any]) -> None:
        self.problem = problem

    def mechanism(self) -> Mechanism:
        """The bodies at their places."""
        paragraphs, bodies = self.problem["description"], self.problem["bodies"]
        description = read_description(paragraphs, bodies)
        return Mechanism(description, positions_of(description))

    def answers(self) -> dict[str, float | None]:
        """The number for each quantity asked, in its unit."""
        mechanism = self.mechanism()

        @cache
        def states() -> list[State]:
            return mechanism.states()

        found: dict[str, float | None] = {}
        for ask in self.problem["asks"]:
            values = [self.value(mechanism, ask, lambda: states()[0])]
            if needs_motion(ask) and len(states()) > 1:
                values.append(self.value(mechanism, ask, lambda: states()[1]))
            if not agree(values):
                raise ValueError(f"the motion leaves open: {ask['name']}")
            found[ask["name"]] = values[0]
        return found

    def value(self, mechanism: Mechanism, ask: Mapping[str, str], state: Any) -> float | None:
        """One quantity in one motion."""
        words = mechanism.description.words

        def poles(body: str) -> list[complex]:
            return poles_on_the_way(mechanism, body)

        answers = Answers(words, mechanism.points, state, poles)
        try:
            value = float(answers.value(quantity(ask["quantity"])))
        except AtInfinity:
            return None
        return value / factor_of(ask["unit"] or "1")


def needs_motion(ask: Mapping[str, str]) -> bool:
    """Whether the quantity depends on how the bodies move."""
    words = ("velocity", "acceleration", "omega", "alpha", "pole", "coriolis")
    return any(word in ask["quantity"] for word in words)


def agree(values: list[float | None]) -> bool:
    """Whether the quantity is the same in all motions."""
    first, *others = values
    if first is None:
        return all(other is None for other in others)
    return all(
        other is not None and math.isclose(first, other, rel_tol=1e-6, abs_tol=1e-9)
        for other in others
    )


def solve(problem: dict[str, Any]) -> dict[str, float | None]:
    """The answers by their names, in the units asked; None for what is at infinity."""
    return Problem(problem).answers()
