"""A motion worked out by hand: the plan is followed, and each term and each solved rate is written
down rounded.

The contribution of a term is found from rounded arms and rates and rounded again, as it stands in
the table of a vector equation: the arm, the velocity, the normal, tangential and Coriolis parts of
the acceleration.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from kinegrade.mechanics import plan as plans
from kinegrade.mechanics.motion import Motion, find_relative_terms
from kinegrade.mechanics.relations import Chain, Reading, Term
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.rounding import Rounded


@dataclass(frozen=True)
class WrittenReading(Reading):
    """The terms as they are written down: arms, velocities and the parts of accelerations.

    `relative` has the relative motions that the plan solves for, which are not found again as
    differences: of a point relative to a body.
    """

    rounded: Rounded
    relative: Mapping[tuple[str, str], Term]

    def chain(self, chain: Chain) -> Chain:
        """The terms with their arms written down."""
        return tuple(map(self._write_arm, chain))

    def _write_arm(self, term: Term) -> Term:
        return term.put(self.write(term.vector))

    def write(self, vector: Vector) -> Vector:
        """The vector as it is written down."""
        return write_down(vector, self.rounded)

    def add_parts(self, normal: Vector, tangential: Vector, coriolis: Vector) -> Vector:
        """The parts added up one after the other, as they are written down."""
        return normal + tangential + coriolis

    def find_relative(self, point: str, frame: str) -> Term | None:
        """The term of a relative motion that the plan solves for, its arm written down."""
        term = self.relative.get((point, frame))
        return term and self._write_arm(term)


def solve_by_hand(motion: Motion, rounded: Rounded) -> Motion:
    """The motion again, from the same relations and by the same plan, with rounded intermediate
    values; in doubles.

    Raises Singular where rounding leaves a step undetermined.
    """
    if not motion.plan.steps:
        return motion
    reading = WrittenReading(rounded, find_relative_terms(motion.frames))
    relations = [reading.relation(relation) for relation in motion.frames.relations]
    equations = [relation.equations() for relation in relations]
    sides = [relation.velocity_side() for relation in relations]
    rates = plans.run_steps(motion.plan, equations, sides, rounded)
    sides = [relation.acceleration_side(rates, reading) for relation in relations]
    changes = plans.run_steps(motion.plan, equations, sides, rounded)
    return Motion(motion.frames, motion.plan, rates, changes, reading)


def write_down(vector: Vector, rounded: Rounded) -> Vector:
    """A vector or a point with its components as they are written down."""
    return Vector(rounded.noted(vector.x), rounded.noted(vector.y))
