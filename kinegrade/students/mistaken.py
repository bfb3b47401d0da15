"""The motion that slips lead to: the plan runs on with mistaken terms, in any arithmetic.

A student who makes a mistake does not notice it: surplus equations are not checked, and where there
are more equations than unknowns, the vectors are projected. Two mistakes concern magnitudes and are
not linear: a fixed pivot taken for the velocity pole, and the transport velocity taken for the
absolute one. They replace the results of a step of the plan.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from kinegrade.mechanics import plan as plans
from kinegrade.mechanics.frames import Frames, build_frames
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.motion import Motion
from kinegrade.mechanics.plan import Plan, Step
from kinegrade.mechanics.rates import Rate, Rates, make_turning
from kinegrade.mechanics.relations import Relation, add_vectors
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.number import Arithmetic, Number
from kinegrade.students.slips import MistakenReading, Slips, is_right, read_with_slips
from kinegrade.students.unsuspecting import Unsuspecting


def make_mistaken_motion(
    mechanism: Mechanism,
    arithmetic: Arithmetic,
    plan: Plan,
    slips: Slips,
    *,
    perturbed: bool = False,
) -> Motion:
    """The motion with the slips made. Raises Singular where a step determines nothing,
    MechanismError.

    `perturbed` uses other velocities for the accelerations, none of which vanishes by chance: to
    see whether a term matters, or is merely zero here.
    """
    frames = build_frames(mechanism, arithmetic)
    reading = read_with_slips(frames, slips, plan)
    relations = [reading.relation(relation) for relation in frames.relations]
    rates = _Velocities(frames, relations, reading, arithmetic).run(plan)
    if perturbed:
        rates = dict(_perturb_rates(mechanism, rates))
    sought = {index: step.unknowns for step in plan.steps for index in step.relations}
    changes = plans.run_steps(
        plan,
        [
            reading.write_for_changes(relation, sought[index]).equations()
            for index, relation in enumerate(relations)
        ],
        [relation.acceleration_side(rates, reading) for relation in relations],
        Unsuspecting(arithmetic),
    )
    return Motion(frames, plan, rates, changes, reading)


def _perturb_rates(mechanism: Mechanism, rates: Rates) -> Iterator[tuple[Rate, Number]]:
    """Perturbed rates: those of translating bodies are zero, and no others."""
    still = {make_turning(body) for body in mechanism.held_parallel}
    for place, (name, rate) in enumerate(rates.items()):
        yield name, rate if name in still else rate * 2 + place + 1


@dataclass(frozen=True)
class _Stage:
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


_Replacements = Iterator[tuple[Rate, Number]]


@dataclass(frozen=True)
class _Velocities:
    """The run of a plan for velocities, in which a step's results may be replaced by what a mistake
    gives.
    """

    frames: Frames
    relations: Sequence[Relation]
    reading: MistakenReading
    arithmetic: Arithmetic

    def run(self, plan: Plan) -> dict[Rate, Number]:
        """The rates, rad/s and m/s, step by step."""
        relations = [self._write_for_velocities(relation) for relation in self.relations]
        equations = [relation.equations() for relation in relations]
        sides = [relation.velocity_side() for relation in relations]
        solver = Unsuspecting(self.arithmetic)
        rates: dict[Rate, Number] = {}
        for step in plan.steps:
            if step.unknowns:
                rates.update(plans.solve_step(step, equations, sides, rates, solver))
                rates.update(self._replaced(_Stage(step, equations, rates)))
        return rates

    def _write_for_velocities(self, relation: Relation) -> Relation:
        """A relation as it is written for velocities."""
        left, right = (
            self.reading.velocity_chain(side, whole=False)
            for side in (relation.left, relation.right)
        )
        return replace(relation, left=left, right=right)

    def _replaced(self, stage: _Stage) -> dict[Rate, Number]:
        """The rates that result from a transport velocity in place of the absolute one, and from a
        fixed pivot in place of the pole.
        """
        result: dict[Rate, Number] = {}
        for share, find in (
            (self.reading.slips.relative, self._without_relative),
            (self.reading.slips.pole, self._about_pivot),
        ):
            if not is_right(share):
                for rate, value in find(stage):
                    result[rate] = self.arithmetic.choose(
                        share == 0, value, result.get(rate, stage.rates[rate])
                    )
        return result

    def _without_relative(self, stage: _Stage) -> _Replacements:
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

    def _about_pivot(self, stage: _Stage) -> _Replacements:
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

    def _common_rate(
        self, stage: _Stage, body: str, neighbour: str, pivot: Vector
    ) -> Number | None:
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

    def _ends(
        self, stage: _Stage, pair: set[Rate], pivot: Vector, turning: Number
    ) -> _Replacements:
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
