"""The vector equations that the joints and drivers state, for velocities and accelerations alike.

The motion of each point is written as a chain of terms from the ground outwards, `v_B = v_A + v_BA`
or `v_a = v_e + v_r`, each term a vector times one unknown rate. A joint that closes a loop equates
two chains. The same relations hold for accelerations, with the part of each term that the
velocities decide: centripetal and Coriolis.

`build_frames` is called by `motion`; `plan` decides in which order the relations determine the
rates.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Literal, assert_never

from kinegrade.language.message import Message
from kinegrade.mechanics.drivers import Driver
from kinegrade.mechanics.joints import GROUND, Joint
from kinegrade.mechanics.rates import Rate, Rates, make_turning
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.number import Number

Kind = Literal["rotation", "sliding", "arc"]


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
    """

    kind: Kind
    rate: Rate
    vector: Vector
    point: str
    base: str = ""
    frame: str = GROUND

    def coefficient(self) -> Vector:
        """The vector by which the unknown rate is multiplied."""
        match self.kind:
            case "sliding":
                return self.vector
            case "rotation" | "arc":
                return self.vector.turned()
            case _:
                assert_never(self.kind)

    def velocity(self, rates: Rates) -> Vector:
        """The term's velocity, m/s."""
        velocity: Vector = self.coefficient() * rates[self.rate]
        return velocity

    def normal(self, rates: Rates) -> Vector:
        """The centripetal part of the term's acceleration, m/s^2: towards the base point or the
        centre.
        """
        match self.kind:
            case "sliding":
                return Vector(0, 0)
            case "rotation" | "arc":
                centripetal: Vector = self.vector * (-rates[self.rate] * rates[self.rate])
                return centripetal
            case _:
                assert_never(self.kind)

    def coriolis(self, rates: Rates) -> Vector:
        """The Coriolis part 2 omega x v_r of the term's acceleration, m/s^2; zero for the rotation
        of a body.
        """
        if self.kind == "rotation" or self.frame == GROUND:
            return Vector(0, 0)
        coriolis: Vector = self.velocity(rates).turned() * (rates[make_turning(self.frame)] * 2)
        return coriolis

    def remainder(self, rates: Rates) -> Vector:
        """The whole part of the term's acceleration that the velocities decide."""
        return self.normal(rates) + self.coriolis(rates)

    def acceleration(self, rates: Rates, changes: Rates) -> Vector:
        """The term's acceleration, m/s^2, from the rates and their changes."""
        tangential: Vector = self.coefficient() * changes[self.rate]
        return tangential + self.remainder(rates)

    def map(self, number: Callable[[Number], Number]) -> Term:
        """The term with `number` applied to its vector."""
        vector = self.vector.map(number)
        return Term(self.kind, self.rate, vector, self.point, self.base, self.frame)


Chain = tuple[Term, ...]


@dataclass(frozen=True)
class Relation:
    """left chain = right chain (two equations), or their difference along a vector plus turning
    rates = imposed.

    `origin` names the joint or driver that states it, in messages; `source` is that joint or
    driver.
    `frame` is the body relative to which a component is imposed: its rotation adds the Coriolis
    acceleration of the relative motion.
    """

    origin: Message
    left: Chain = ()
    right: Chain = ()
    along: Vector | None = None
    turning: tuple[tuple[Rate, Number], ...] = ()
    velocity: Number = 0
    acceleration: Number = 0
    frame: str = GROUND
    source: Joint | Driver | None = None

    @property
    def is_vector(self) -> bool:
        """Whether the relation is a vector equation, that is, two equations."""
        return self.along is None and not self.turning

    def unknowns(self) -> tuple[Rate, ...]:
        """The rates that occur, in order of occurrence."""
        rates = [term.rate for term in (*self.left, *self.right)] + [
            rate for rate, _ in self.turning
        ]
        return tuple(dict.fromkeys(rates))

    def equations(self) -> list[dict[Rate, Number]]:
        """The coefficients of the rates, one dict for each scalar equation."""
        vectors: dict[Rate, Vector] = {}
        for side, chain in ((1, self.left), (-1, self.right)):
            for term in chain:
                vector = term.coefficient() * side
                vectors[term.rate] = vectors[term.rate] + vector if term.rate in vectors else vector
        if self.is_vector:
            return [
                {rate: v.x for rate, v in vectors.items()},
                {rate: v.y for rate, v in vectors.items()},
            ]
        row = (
            {rate: self.along.dot(v) for rate, v in vectors.items()}
            if self.along is not None
            else {}
        )
        for rate, factor in self.turning:
            row[rate] = row[rate] + factor if rate in row else factor
        return [row]

    def velocity_side(self) -> list[Number]:
        """The right-hand sides of the equations for velocities."""
        return [0, 0] if self.is_vector else [self.velocity]

    def acceleration_side(self, rates: Rates) -> list[Number]:
        """The right-hand sides of the equations for accelerations: imposed minus what the
        velocities decide.
        """
        decided = add_vectors(term.remainder(rates) for term in self.left)
        decided = decided - add_vectors(term.remainder(rates) for term in self.right)
        if self.is_vector:
            return [-decided.x, -decided.y]
        if self.along is None:
            return [self.acceleration]
        if self.frame != GROUND:
            decided = decided - self.imposed_coriolis(rates)
        return [self.acceleration - self.along.dot(decided)]

    def imposed_coriolis(self, rates: Rates) -> Vector:
        """The Coriolis acceleration 2 omega x v_r of the motion relative to `frame`, m/s^2."""
        relative = add_vectors(t.velocity(rates) for t in self.left) - add_vectors(
            t.velocity(rates) for t in self.right
        )
        coriolis: Vector = relative.turned() * (rates[make_turning(self.frame)] * 2)
        return coriolis

    def map(self, number: Callable[[Number], Number]) -> Relation:
        """The relation with `number` applied to all that it states; its source stays as it is."""
        return Relation(
            self.origin,
            map_chain(self.left, number),
            map_chain(self.right, number),
            None if self.along is None else self.along.map(number),
            tuple((rate, number(factor)) for rate, factor in self.turning),
            number(self.velocity),
            number(self.acceleration),
            self.frame,
            self.source,
        )


def map_chain(chain: Chain, number: Callable[[Number], Number]) -> Chain:
    """The terms with `number` applied to their vectors."""
    return tuple(term.map(number) for term in chain)


def add_vectors(vectors: Iterable[Vector]) -> Vector:
    """The sum of vectors, zero if there are none."""
    result = Vector(0, 0)
    for vector in vectors:
        result = result + vector
    return result
