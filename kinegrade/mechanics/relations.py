"""The vector equations that the joints and drivers state, for velocities and accelerations alike.

The motion of each point is written as a chain of terms from the ground outwards, `v_B = v_A + v_BA`
or `v_a = v_e + v_r`, each term a vector times one unknown rate. A joint that closes a loop equates
two chains. The same relations hold for accelerations, with the part of each term that the
velocities decide: centripetal and Coriolis.

A `Reading` says what is taken of the terms by a student who makes a mistake, goes on from a value
of their own, or rounds.

`build_frames` is called by `motion`; `plan` decides in which order the relations determine the
rates.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from typing import Literal, TypeAlias, assert_never

from kinegrade.language.message import Message
from kinegrade.mechanics.element import Element
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.laws import Law, Turning
from kinegrade.mechanics.rates import Rate, Rates, make_turning
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.number import Number

Kind = Literal["rotation", "sliding", "arc"]
Chain: TypeAlias = "tuple[Term, ...]"


class Reading:
    """What is taken of the terms and relations of a motion: here all of them, as they are.

    Vectors in m/s and m/s^2; chains and relations as the joints and drivers state them.
    """

    def chain(self, chain: Chain) -> Chain:
        """The terms that are taken for the motion of a point."""
        return chain

    def velocity_chain(self, chain: Chain, *, whole: bool) -> Chain:
        """The terms, of those taken for the motion of a point, that are taken for its velocity; the
        `whole` one, or one of two of which the difference is taken.
        """
        return chain

    def absolute_chain(self, chain: Chain) -> Chain:
        """The terms, of those taken for the motion of a point, that are taken for its absolute
        motion where that is asked for.
        """
        return chain

    def turning(self, relation: Relation) -> Turning:
        """The rates that turn in a relation, with the factors that are taken."""
        return relation.turning

    def relation(self, relation: Relation) -> Relation:
        """The relation as it is taken."""
        left, right = self.chain(relation.left), self.chain(relation.right)
        return replace(relation, left=left, right=right, turning=self.turning(relation))

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

    def find_relative(self, point: str, frame: str) -> Term | None:
        """The term by which the motion of `point` relative to the body `frame` was solved for; None
        where it is found as a difference.
        """
        return None


PLAIN = Reading()


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
        return self.coefficient() * rates[self.rate]

    def normal(self, rates: Rates, reading: Reading = PLAIN) -> Vector:
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

    def coriolis(self, rates: Rates, reading: Reading = PLAIN) -> Vector:
        """The Coriolis part 2 omega x v_r of the term's acceleration, m/s^2; zero for the rotation
        of a body.
        """
        if self.kind == "rotation" or self.frame == GROUND:
            return Vector(0, 0)
        omega = reading.frame_rate(rates[make_turning(self.frame)], self.rate.body, rates)
        coriolis = compose_coriolis(self.velocity(rates), omega)
        return reading.coriolis(self.point, self.frame, coriolis)

    def remainder(self, rates: Rates, reading: Reading = PLAIN) -> Vector:
        """The whole part of the term's acceleration that the velocities decide."""
        return self.normal(rates, reading) + self.coriolis(rates, reading)

    def tangential(self, changes: Rates, reading: Reading = PLAIN) -> Vector:
        """The part of the term's acceleration along its velocity, m/s^2."""
        tangential = self.coefficient() * changes[self.rate]
        return reading.tangential(self.rate, self.point, self.base, tangential)

    def relative_acceleration(
        self, rates: Rates, changes: Rates, reading: Reading = PLAIN
    ) -> Vector:
        """The term's acceleration relative to `frame`, m/s^2: its normal and tangential parts."""
        return self.normal(rates, reading) + self.tangential(changes, reading)

    def acceleration(self, rates: Rates, changes: Rates, reading: Reading = PLAIN) -> Vector:
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
        return Term(self.kind, self.rate, vector, self.point, self.base, self.frame)

    def map(self, number: Callable[[Number], Number]) -> Term:
        """The term with `number` applied to its vector."""
        return self.put(self.vector.map(number))


@dataclass(frozen=True)
class Relation:
    """left chain = right chain (two equations), or their difference along a vector plus turning
    rates = imposed.

    `element` is the joint or driver that states it, `source` the law by which it holds.
    `frame` is the body relative to which a component is imposed: its rotation adds the Coriolis
    acceleration of the relative motion.
    """

    element: Element
    left: Chain = ()
    right: Chain = ()
    along: Vector | None = None
    turning: Turning = ()
    velocity: Number = 0
    acceleration: Number = 0
    frame: str = GROUND
    source: Law | None = None

    @property
    def origin(self) -> Message:
        """The relation, as messages name it."""
        name = self.element.describe()
        return self.source.describe(name) if self.source else name

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

    def acceleration_side(self, rates: Rates, reading: Reading = PLAIN) -> list[Number]:
        """The right-hand sides of the equations for accelerations: imposed minus what the
        velocities decide.
        """
        decided = add_vectors(term.remainder(rates, reading) for term in self.left)
        decided = decided - add_vectors(term.remainder(rates, reading) for term in self.right)
        if self.is_vector:
            return [-decided.x, -decided.y]
        if self.along is None:
            return [self.acceleration]
        if self.frame != GROUND:
            decided = decided - self._imposed_coriolis(rates, reading)
        return [self.acceleration - self.along.dot(decided)]

    def _imposed_coriolis(self, rates: Rates, reading: Reading) -> Vector:
        """The Coriolis acceleration 2 omega x v_r of the motion relative to `frame`, m/s^2."""
        relative = add_vectors(t.velocity(rates) for t in self.left) - add_vectors(
            t.velocity(rates) for t in self.right
        )
        point = self.left[-1].point if self.left else ""
        coriolis = compose_coriolis(relative, rates[make_turning(self.frame)])
        return reading.coriolis(point, self.frame, coriolis)

    def map(self, number: Callable[[Number], Number]) -> Relation:
        """The relation with `number` applied to all that it states."""
        return Relation(
            self.element,
            map_chain(self.left, number),
            map_chain(self.right, number),
            None if self.along is None else self.along.map(number),
            tuple((rate, number(factor)) for rate, factor in self.turning),
            number(self.velocity),
            number(self.acceleration),
            self.frame,
            self.source.map(number) if self.source else None,
        )


def compose_coriolis(relative: Vector, omega: Number) -> Vector:
    """The Coriolis acceleration 2 omega x v_r, m/s^2."""
    return relative.turned() * (omega * 2)


def map_chain(chain: Chain, number: Callable[[Number], Number]) -> Chain:
    """The terms with `number` applied to their vectors."""
    return tuple(term.map(number) for term in chain)


def add_vectors(vectors: Iterable[Vector]) -> Vector:
    """The sum of vectors, zero if there are none."""
    result = Vector(0, 0)
    for vector in vectors:
        result = result + vector
    return result
