"""How far a mechanism has gone since the instant: each rate's coordinate, and the chains of terms
that these carry along.

A rate is the rate of a coordinate: the angle through which a body has turned, the way of a point
along a line, the angle of a point about a centre. So the terms that say how velocities add up say
how positions do, and no joint has to be asked for.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple, assert_never

from kinegrade.mechanics.bases import Base
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.rates import Rate, Rates, make_turning
from kinegrade.mechanics.relations.terms import Chain, Term
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.number import Arithmetic


class MovedChain(NamedTuple):
    """How far the last point of a chain has gone, m, and the terms of its motion where it is."""

    shift: Vector
    chain: Chain


@dataclass(frozen=True, eq=False)
class Displacement:
    """The coordinates of all rates since the instant: rad, or multiples of a term's vector.

    `bases` are those of the instant, `arithmetic` is that of the coordinates.
    """

    coordinates: Rates
    bases: Mapping[str, Base]
    arithmetic: Arithmetic

    @cached_property
    def _directions(self) -> dict[Rate, Vector]:
        """Cosine and sine of every angle."""
        cos, sin = self.arithmetic.cos, self.arithmetic.sin
        return {
            rate: Vector(cos(angle), sin(angle))
            for rate, angle in self.coordinates.items()
            if rate.kind in ("turning", "circling")
        }

    def turn(self, vector: Vector, rate: Rate) -> Vector:
        """A vector turned by the angle of a rate."""
        c, s = self._directions[rate]
        return Vector(c * vector.x - s * vector.y, s * vector.x + c * vector.y)

    def carry(self, body: str, vector: Vector) -> Vector:
        """A vector that is fixed in a body."""
        rate = make_turning(body)
        return self.turn(vector, rate) if rate in self.coordinates else vector

    def move_chain(self, chain: Chain) -> MovedChain:
        """A chain of the instant where it has gone to."""
        shift = Vector(0, 0)
        moved: Chain = ()
        for term in chain:
            vector, gone = self._move_term(term)
            if term.kind != "rotation":
                moved = self.lengthen(moved, term.frame, gone, term.point)
            moved = (*moved, term.put(vector))
            shift = shift + gone
        return MovedChain(shift, moved)

    def _move_term(self, term: Term) -> tuple[Vector, Vector]:
        """Its vector now, and how far it has taken its point within the body that carries it, or
        about the base point of the body.
        """
        match term.kind:
            case "rotation":
                now = self.turn(term.vector, term.rate)
                return now, now - term.vector
            case "sliding":
                now = self.carry(term.frame, term.vector)
                return now, now * self.coordinates[term.rate]
            case "arc":
                carried = self.carry(term.frame, term.vector)
                now = self.turn(carried, term.rate)
                return now, now - carried
            case _:
                assert_never(term.kind)

    def lengthen(self, chain: Chain, frame: str, gone: Vector, point: str) -> Chain:
        """The chain to a place of the body `frame`, once the point that moves in that body is
        `gone` from there: the place is now another one, which turns about the same base point.
        """
        if frame == GROUND:
            return chain
        rate = make_turning(frame)
        if chain and chain[-1].kind == "rotation" and chain[-1].rate == rate:
            return (*chain[:-1], chain[-1].put(chain[-1].vector + gone))
        return (*chain, Term("rotation", rate, gone, point, self.bases[frame].point))
