"""Slips that happen when a right answer is typed, for students of any template."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from math import pi

from tests.by_hand.pad import Answers, Givens, Mistake


def slips_in_writing(right: Mistake, signed: Collection[str]) -> Mapping[str, Mistake]:
    """By identifier what is typed in place of the right answers: the decimal point slipped, the
    sign of what has one turned round.
    """

    def changed(factor: float, asks: Callable[[str], bool]) -> Mistake:
        def answers(given: Givens) -> Answers:
            return {ask: factor * value for ask, value in right(given).items() if asks(ask)}

        return answers

    return {
        "power-of-ten-up": changed(10, lambda _: True),
        "power-of-ten-down": changed(0.1, lambda _: True),
        "two-powers-of-ten-up": changed(100, lambda _: True),
        "two-powers-of-ten-down": changed(0.01, lambda _: True),
        "three-powers-of-ten-up": changed(1000, lambda _: True),
        "three-powers-of-ten-down": changed(0.001, lambda _: True),
        "degrees-per-second": changed(180 / pi, is_rate),
        "rpm-typed": changed(30 / pi, is_angular_velocity),
        "sense-reversed": changed(-1, lambda ask: ask in signed),
        "minus-in-magnitude": changed(-1, lambda ask: ask not in signed),
    }


def is_angular_velocity(ask: str) -> bool:
    """Whether an ask counts radians per second."""
    return ask.startswith("omega")


def is_rate(ask: str) -> bool:
    """Whether an ask counts radians per second or per second squared."""
    return ask.startswith(("omega", "alpha"))
