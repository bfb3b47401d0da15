"""The conditions on positions that the relations of rates are the derivatives of, each as far as it
is missed, and the relations where the mechanism is.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

from kinegrade.mechanics.frames import Frames
from kinegrade.mechanics.relations.relation import Relation
from kinegrade.mechanics.vector import Vector
from kinegrade.motion.displacement import Displacement
from kinegrade.numbers.number import Number


class Placed(NamedTuple):
    """A relation where the mechanism is, and by how much its positions miss what it says: two
    numbers for an equation of vectors, else one; in m, rad, or m times rad over m.
    """

    relation: Relation
    missed: tuple[Any, ...]


@dataclass(frozen=True)
class Conditions:
    """What the positions of a mechanism have to meet; `frames` of the instant, in doubles."""

    frames: Frames

    def place(self, at: Displacement, imposed: tuple[Number, ...]) -> tuple[Placed, ...]:
        """All relations at a displacement; `imposed` is how far each driver's coordinate has gone,
        0 for the joints' relations.
        """
        return tuple(
            self._place_relation(relation, at, gone)
            for relation, gone in zip(self.frames.relations, imposed, strict=True)
        )

    def _place_relation(self, relation: Relation, at: Displacement, gone: Number) -> Placed:
        """One relation."""
        left, right = at.move_chain(relation.left), at.move_chain(relation.right)
        apart = left.shift - right.shift
        now = replace(relation, left=left.chain, right=right.chain)
        circle = relation.source.find_imposed_circle() if relation.source else None
        if circle:
            centre = self.frames.mechanism.points[circle[1]]
            start = self.frames.mechanism.points[circle[0]] - centre
            return _place_circling(now, start, start + apart, gone, at)
        if relation.along is not None:
            return _place_component(now, relation.along, apart, gone, at)
        if relation.is_vector:
            return Placed(now, (apart.x, apart.y))
        return Placed(now, (_add_turns(relation, at) - gone,))


def _add_turns(relation: Relation, at: Displacement) -> Any:
    """The coordinates that a relation adds up, by its factors, which stay the same in every
    position.
    """
    return sum(at.coordinates[rate] * factor for rate, factor in relation.turning)


def _place_component(
    relation: Relation, along: Vector, apart: Vector, gone: Number, at: Displacement
) -> Placed:
    """A driven way along a direction of the body `frame`; the place of that body at which the
    driven point is now is another one than at the instant.
    """
    carried = at.carry(relation.frame, along)
    point = relation.left[-1].point if relation.left else ""
    right = at.lengthen(relation.right, relation.frame, apart, point)
    return Placed(replace(relation, along=carried, right=right), (carried.dot(apart) - gone,))


def _place_circling(
    relation: Relation, start: Vector, arm: Vector, gone: Number, at: Displacement
) -> Placed:
    """A driven way about a fixed centre: the radius times the angle that the arm has swept, whole
    turns apart.
    """
    radius = math.hypot(start.x, start.y)
    c, s = at.arithmetic.cos(-gone / radius), at.arithmetic.sin(-gone / radius)
    behind = Vector(c * arm.x - s * arm.y, s * arm.x + c * arm.y)
    missed = at.arithmetic.arctangent(start.cross(behind), start.dot(behind)) * radius
    along = arm.turned() * (radius / arm.squared())
    return Placed(replace(relation, along=along), (missed,))
