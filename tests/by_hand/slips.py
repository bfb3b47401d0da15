"""Slips that happen in any exercise: each turns a textbook method into a student who makes one.

A student with a slip works with all figures, so that nothing but the slip is wrong.
"""

from __future__ import annotations

from collections.abc import Callable

from tests.by_hand.pad import Answers, Givens, Mistake, Pad

Steps = Callable[..., Answers]  # givens, a pad, and what is slipped in

_DEGREES = 57.29577951308232  # in a radian


def slip(steps: Steps, **slipped: float) -> Mistake:
    """A method with one of its terms taken otherwise, by the names that the method has for it."""
    return lambda givens: steps(givens, Pad.exact(), **slipped)


def misread(steps: Steps, reading: Callable[[float], float], *names: str) -> Mistake:
    """A method after these givens were read, or entered, otherwise."""

    def work(givens: Givens) -> Answers:
        read = {name: reading(givens[name]) for name in names}
        return steps({**givens, **read}, Pad.exact())

    return work


def sine_for_cosine(steps: Steps, *angles: str) -> Mistake:
    """Sine and cosine exchanged: those of what is missing to a right angle."""
    return misread(steps, lambda angle: 90 - angle, *angles)


def degrees_for_radians(steps: Steps, *angles: str) -> Mistake:
    """A calculator set to radians takes 30 degrees for 30 radians."""
    return misread(steps, lambda angle: angle * _DEGREES, *angles)


def supplementary_angle(steps: Steps, *angles: str) -> Mistake:
    """Angles counted from the other direction of the line."""
    return misread(steps, lambda angle: 180 - angle, *angles)


def diameter_for_radius(steps: Steps, *radii: str) -> Mistake:
    """Radii taken twice."""
    return misread(steps, lambda radius: 2 * radius, *radii)
