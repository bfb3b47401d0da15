"""The terms of a vector equation, for velocities and accelerations alike: each a vector times one
unknown rate, and for accelerations the part that the velocities decide, centripetal and Coriolis.

The motion of each point is written as a chain of terms from the ground outwards, `v_B = v_A + v_BA`
or `v_a = v_e + v_r`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal, TypeAlias, assert_never

from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.rates import Rate, Rates, make_turning
from kinegrade.mechanics.relations.term_reading import PLAIN_TERMS, TermReading
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.number import Number

Kind = Literal["rotation", "sliding", "arc"]
Chain: TypeAlias = "tuple[Term, ...]"


@dataclass(frozen=True)
class Term:
    """One term of a vector equation.

    - rotation: the point turns about a base point of its body; `vector` goes from base to point,
      the rate is omega.
    - sliding: the point moves along `vector` relative to the body `frame`; the rate is in units of
      `vector`.
    - arc: the point turns about a centre fixed in `frame`; `vector` goes from centre to point, the
      rate is omega.

    `point` is the point that moves so, `base` the base point or the centre, "" for a sliding point.
    `clockwise` is whether the rate of a turning point counts in this sense.
    """

    kind: Kind
    rate: Rate
    vector: Vector
    point: str
    base: str = ""
    frame: str = GROUND
    clockwise: bool = False

    def coefficient(self) -> Vector:
        """The vector by which the unknown rate is multiplied."""
        match self.kind:
            case "sliding":
                return self.vector
            case "rotation" | "arc":
                return -self.vector.turned() if self.clockwise else self.vector.turned()
            case _:
                assert_never(self.kind)

    def velocity(self, rates: Rates) -> Vector:
        """The term's velocity, m/s."""
        return self.coefficient() * rates[self.rate]

    def normal(self, rates: Rates, reading: TermReading = PLAIN_TERMS) -> Vector:
        """The centripetal part of the term's acceleration, m/s^2: towards the base point or the
        centre.
        """
        match self.kind:
            case "sliding":
                return Vector(0, 0)
            case "rotation" | "arc":
                centripetal = self.vector * -reading.square(rates[self.rate])
                return reading.normal(self.rate, self.point, self.base, centripetal)
            case _:
                assert_never(self.kind)

    def coriolis(self, rates: Rates, reading: TermReading = PLAIN_TERMS) -> Vector:
        """The Coriolis part 2 omega x v_r of the term's acceleration, m/s^2; zero for the rotation
        of a body.
        """
        if self.kind == "rotation" or self.frame == GROUND:
            return Vector(0, 0)
        omega = reading.frame_rate(rates[make_turning(self.frame)], self.rate.body, rates)
        coriolis = compose_coriolis(self.velocity(rates), omega)
        return reading.coriolis(self.point, self.frame, coriolis)

    def remainder(self, rates: Rates, reading: TermReading = PLAIN_TERMS) -> Vector:
        """The whole part of the term's acceleration that the velocities decide."""
        return self.normal(rates, reading) + self.coriolis(rates, reading)

    def tangential(self, changes: Rates, reading: TermReading = PLAIN_TERMS) -> Vector:
        """The part of the term's acceleration along its velocity, m/s^2."""
        tangential = self.coefficient() * changes[self.rate]
        return reading.tangential(self.rate, self.point, self.base, tangential)

    def relative_acceleration(
        self, rates: Rates, changes: Rates, reading: TermReading = PLAIN_TERMS
    ) -> Vector:
        """The term's acceleration relative to `frame`, m/s^2: its normal and tangential parts."""
        return self.normal(rates, reading) + self.tangential(changes, reading)

    def acceleration(
        self, rates: Rates, changes: Rates, reading: TermReading = PLAIN_TERMS
    ) -> Vector:
        """The term's acceleration, m/s^2, from the rates and their changes."""
        return reading.add_terms(
            (
                self.tangential(changes, reading),
                self.normal(rates, reading),
                self.coriolis(rates, reading),
            )
        )

    def put(self, vector: Vector) -> Term:
        """The term with another vector."""
        place = self.point, self.base, self.frame
        return Term(self.kind, self.rate, vector, *place, self.clockwise)

    def map(self, number: Callable[[Number], Number]) -> Term:
        """The term with `number` applied to its vector."""
        return self.put(self.vector.map(number))


def compose_coriolis(relative: Vector, omega: Number) -> Vector:
    """The Coriolis acceleration 2 omega x v_r, m/s^2."""
    return relative.turned() * (omega * 2)


def map_chain(chain: Chain, number: Callable[[Number], Number]) -> Chain:
    """The terms with `number` applied to their vectors."""
    return tuple(term.map(number) for term in chain)
