"""What mistakes give in place of the results of a step of the plan, where they concern magnitudes
and are not linear.

A fixed pivot is taken for the velocity pole, the transport velocity for the absolute one, and the
rates of a rod for what `rods` says.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from kinegrade.mechanics import plan as plans
from kinegrade.mechanics.frames import Frames
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.plan import Step
from kinegrade.mechanics.rates import Rate, Rates, make_turning
from kinegrade.mechanics.relations.relation import Relation
from kinegrade.mechanics.vector import Vector, add_vectors
from kinegrade.numbers.number import Arithmetic, Number
from kinegrade.students.mistaking.mistaken_reading import MistakenReading
from kinegrade.students.mistaking.rods import MisjudgedRod, Replacements
from kinegrade.students.mistaking.slips import Share, is_right


@dataclass(frozen=True)
class Stage:
    """A step of the plan just solved: the equations of all relations, and the rates known with this
    step.
    """

    step: Step
    equations: plans.Equations
    rates: Rates

    def sought(self, index: int) -> set[Rate]:
        """The rates in a relation that this step finds."""
        return set(self.equations[index][0]) & set(self.step.unknowns)

    def coefficient(self, index: int, rate: Rate) -> Vector:
        """The vector that a rate multiplies in a vector relation."""
        return Vector(self.equations[index][0][rate], self.equations[index][1][rate])


@dataclass(frozen=True)
class Misjudging:
    """Replaces a step's results by what a mistake gives."""

    frames: Frames
    relations: Sequence[Relation]
    reading: MistakenReading
    arithmetic: Arithmetic

    def replace(self, stage: Stage) -> dict[Rate, Number]:
        """The rates that are taken in place of those that the step finds."""
        result: dict[Rate, Number] = {}
        for share, replacements in self._list_replacements(stage):
            if not is_right(share):
                for rate, value in replacements:
                    result[rate] = self.arithmetic.choose(
                        share == 0, value, result.get(rate, stage.rates[rate])
                    )
        return result

    def _list_replacements(self, stage: Stage) -> Iterator[tuple[Share, Replacements]]:
        """For each slip what it gives, worked out as it is read."""
        slips = self.reading.slips
        yield slips.relative, self._without_relative(stage)
        yield slips.pole, self._about_pivot(stage)
        for rod in self.reading.places.rods:
            if rod.rotation.rate in stage.step.unknowns:
                judged = MisjudgedRod(rod, stage.rates, self.arithmetic)
                yield slips.neighbour, judged.turn_with_neighbour()
                yield slips.far_end, judged.turn_about_end()
                yield slips.far_pivot, judged.turn_about_pivot()
                yield slips.rotation, judged.translate()
                yield slips.across, judged.turn_on_velocities()

    def _without_relative(self, stage: Stage) -> Replacements:
        """|unknown velocity| = |known velocity|, as if nothing moved within the moving
        body.
        """
        for index in stage.step.relations:
            relation = self.relations[index]
            relative = {
                term.rate for term in (*relation.left, *relation.right) if term.frame != GROUND
            }
            others = stage.sought(index) - relative
            if relation.is_vector and len(relative & stage.sought(index)) == 1 and len(others) == 1:
                known = [
                    rate for rate in stage.equations[index][0] if rate not in stage.step.unknowns
                ]
                speed = add_vectors(
                    stage.coefficient(index, rate) * stage.rates[rate] for rate in known
                )
                rate = others.pop()
                yield rate, self._size(speed, stage.coefficient(index, rate), stage.rates[rate])

    def _about_pivot(self, stage: Stage) -> Replacements:
        """A body in plane motion turns about the fixed pivot of a body that it is pinned to,
        together with that body.
        """
        for body, neighbours in _find_pivots(self.frames.mechanism).items():
            reached = [name for name in neighbours if make_turning(name) in stage.rates]
            if make_turning(body) not in stage.step.unknowns or not reached:
                continue
            neighbour = min(reached, key=lambda name: make_turning(name) in stage.step.unknowns)
            turning = self._common_rate(stage, body, neighbour, neighbours[neighbour])
            if turning is not None:
                pair = {make_turning(body), make_turning(neighbour)}
                yield from ((rate, turning) for rate in stage.step.unknowns if rate in pair)
                yield from self._ends(stage, pair, neighbours[neighbour], turning)

    def _common_rate(self, stage: Stage, body: str, neighbour: str, pivot: Vector) -> Number | None:
        """The rate with which both turn about the pivot: the neighbour's, or the speed of a known
        point divided by its distance; None where neither is known.
        """
        if make_turning(neighbour) not in stage.step.unknowns:
            return stage.rates[make_turning(neighbour)]
        base = self.frames.bases[body]
        if any(
            term.rate in stage.step.unknowns or term.rate not in stage.rates for term in base.chain
        ):
            return None
        speed = add_vectors(term.velocity(stage.rates) for term in base.chain)
        return self._size(
            speed,
            self.frames.mechanism.points[base.point] - pivot,
            stage.rates[make_turning(neighbour)],
        )

    def _ends(self, stage: Stage, pair: set[Rate], pivot: Vector, turning: Number) -> Replacements:
        """The rates of the ends that the same step finds: the angular velocity times the distance
        to the pivot.
        """
        for index in stage.step.relations:
            relation = self.relations[index]
            others = stage.sought(index) - pair
            ends = [term for term in (*relation.left, *relation.right) if term.rate in others]
            if pair & set(stage.equations[index][0]) and len(ends) == 1 and len(others) == 1:
                speed = (self.frames.mechanism.points[ends[0].point] - pivot) * turning
                yield (
                    ends[0].rate,
                    self._size(speed, ends[0].coefficient(), stage.rates[ends[0].rate]),
                )

    def _size(self, speed: Vector, coefficient: Vector, like: Number) -> Number:
        """|speed| over |coefficient|, in the sense of `like`."""
        size = self.arithmetic.sqrt(speed.squared() / coefficient.squared())
        sense: Number = self.arithmetic.sign(like)
        return size * sense


def _find_pivots(mechanism: Mechanism) -> dict[str, dict[str, Vector]]:
    """For each body in plane motion the bodies that it is pinned to, with their fixed pivots."""
    pins, held = mechanism.shared_points, mechanism.held_parallel
    fixed = {
        name: mechanism.points[pin.point]
        for pin in pins
        if GROUND in pin.bodies
        for name in pin.bodies
    }
    plane = [
        body.name
        for body in mechanism.bodies
        if body.name not in fixed and not body.particle and body.name not in held
    ]
    return {
        body: {
            other: fixed[other]
            for pin in pins
            if body in pin.bodies
            for other in pin.bodies
            if other in fixed
        }
        for body in plane
    }
