"""A relation that a joint or driver states between two chains of terms or between turning rates:
its equations, for velocities and accelerations.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from kinegrade.language.message import Message
from kinegrade.mechanics.element import Element
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.laws import Law, Turning
from kinegrade.mechanics.rates import Rate, Rates, make_turning
from kinegrade.mechanics.relations.term_reading import PLAIN_TERMS, TermReading
from kinegrade.mechanics.relations.terms import Chain, compose_coriolis, map_chain
from kinegrade.mechanics.vector import Vector, add_vectors
from kinegrade.numbers.number import Number


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

    def acceleration_side(self, rates: Rates, reading: TermReading = PLAIN_TERMS) -> list[Number]:
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

    def _imposed_coriolis(self, rates: Rates, reading: TermReading) -> Vector:
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
