"""What is taken of the parts of a term by a student who makes a mistake, goes on from a value of
their own, or rounds.
"""

from __future__ import annotations

from collections.abc import Iterable

from kinegrade.mechanics.rates import Rate, Rates
from kinegrade.mechanics.vector import Vector, add_vectors
from kinegrade.numbers.number import Number


class TermReading:
    """What is taken of the parts of a term: here all of them, as they are.

    Vectors in m/s and m/s^2.
    """

    def square(self, rate: Number) -> Number:
        """What is taken for the square of an angular velocity in a normal acceleration,
        (rad/s)^2.
        """
        return rate * rate

    def normal(self, rate: Rate, point: str, base: str, normal: Vector) -> Vector:
        """What is taken of the normal acceleration of `point` about `base`, which has the
        `rate`.
        """
        return normal

    def tangential(self, rate: Rate, point: str, base: str, tangential: Vector) -> Vector:
        """What is taken of the tangential acceleration of `point` about `base`."""
        return tangential

    def frame_rate(self, omega: Number, body: str, rates: Rates) -> Number:
        """What is taken for the angular velocity `omega` of a moving frame, rad/s, in the Coriolis
        acceleration of a point of `body`.
        """
        return omega

    def coriolis(self, point: str, frame: str, coriolis: Vector) -> Vector:
        """What is taken of the Coriolis acceleration of `point` relative to the body `frame`."""
        return coriolis

    def add_terms(self, terms: Iterable[Vector]) -> Vector:
        """The velocity or the acceleration of which these are the terms."""
        return add_vectors(terms)

    def carried(self, rate: Number) -> Number:
        """What is taken of the rate of a body, rad/s or rad/s^2, relative to which another one's
        is asked for.
        """
        return rate

    def pole(self, body: str, rates: Rates, pole: Vector) -> Vector:
        """The point that is taken for the velocity pole of a body, m."""
        return pole


PLAIN_TERMS = TermReading()
