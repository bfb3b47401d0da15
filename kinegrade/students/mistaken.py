"""The motion that slips lead to: the plan runs on with mistaken terms, in any arithmetic.

A student who makes a mistake does not notice it: surplus equations are not checked, and where there
are more equations than unknowns, the vectors are projected. Two mistakes concern magnitudes and are
not linear: a fixed pivot taken for the velocity pole, and the transport velocity taken for the
absolute one. They replace the results of a step of the plan.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

from kinegrade.mechanics import plan as plans
from kinegrade.mechanics.frames import build_frames
from kinegrade.mechanics.joints import GROUND, Parallel, Pin
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.motion import Motion
from kinegrade.mechanics.plan import Plan, Row, Step
from kinegrade.mechanics.rates import Rate, make_turning
from kinegrade.mechanics.relations import Chain, Relation, add_vectors
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.elimination import Singular
from kinegrade.numbers.number import Arithmetic
from kinegrade.students.slips import (
    MistakenFrames,
    Slips,
    find_rolling_centres,
    find_velocity_chain,
    slip_in_frames,
)


@dataclass(frozen=True)
class MistakenMotion(Motion):
    """A motion worked out with slips; quantities are read off it with the same slips."""

    slips: Slips

    @cached_property
    def centres(self) -> Mapping[Rate, str]:
        """The centres of rolling bodies, by their turning rates."""
        return find_rolling_centres(self.frames)

    def omega(self, body: str, of: str = GROUND) -> Any:
        """Angular velocity, rad/s; relative to `of` with the assumed share of its rotation."""
        omega = super().omega(body)
        return omega if of == GROUND else omega - super().omega(of) * self.slips.asked_relative

    def alpha(self, body: str, of: str = GROUND) -> Any:
        """Angular acceleration, rad/s^2; relative to `of` with the assumed share of its
        rotation.
        """
        alpha = super().alpha(body)
        return alpha if of == GROUND else alpha - super().alpha(of) * self.slips.asked_relative

    def velocity(self, point: str, body: str) -> Vector:
        """What is taken for the velocity of a point, m/s."""
        return self.summed(
            find_velocity_chain(
                self.frames.chain(body, point), self.slips, self.centres, whole=True
            )
        )

    def summed(self, chain: Chain) -> Vector:
        """The velocity that a chain of terms adds up to, m/s."""
        return add_vectors(term.velocity(self.rates) for term in chain)

    def relative_velocity(self, point: str, body: str, frame: str) -> Vector:
        """What is taken for the velocity of `point` of `body` relative to `frame`, m/s."""
        absolute, carried = (
            self.summed(
                find_velocity_chain(self.frames.chain(name, point), self.slips, self.centres)
            )
            for name in (body, frame)
        )
        difference: Vector = absolute - carried
        return difference

    def coriolis(self, point: str, body: str, frame: str) -> Vector:
        """What is taken for the Coriolis acceleration, m/s^2."""
        coriolis: Vector = super().coriolis(point, body, frame) * self.slips.coriolis
        return coriolis


@dataclass(frozen=True)
class Unsuspecting:
    """An arithmetic that solves as a student does who does not notice that equations contradict
    each other.
    """

    arithmetic: Arithmetic

    def solve(self, rows: list[list[Any]], right: list[Any]) -> list[Any]:
        """The unknowns; surplus equations are projected on them. Raises Singular."""
        if len(rows[0]) == 1:
            return [
                self.over(
                    _sum_products([row[0] for row in rows], right),
                    _sum_products(*([row[0] for row in rows],) * 2),
                )
            ]
        if len(rows) > len(rows[0]):
            columns = list(zip(*rows, strict=True))
            rows, right = (
                [[_sum_products(one, other) for other in columns] for one in columns],
                [_sum_products(one, right) for one in columns],
            )
        return (
            self.pair(rows, right) if len(rows) == 2 else list(self.arithmetic.solve(rows, right))
        )

    def pair(self, rows: list[list[Any]], right: list[Any]) -> list[Any]:
        """Two unknowns from two equations."""
        (a, b), (c, d) = rows
        area = a * d - b * c
        return [
            self.over(right[0] * d - b * right[1], area),
            self.over(a * right[1] - right[0] * c, area),
        ]

    def over(self, number: Any, divisor: Any) -> Any:
        """A quotient; Singular, or not a number in some instances, over zero."""
        if self.arithmetic.is_zero(divisor):
            raise Singular
        return number / (self.arithmetic.number(divisor) if isinstance(divisor, int) else divisor)

    def require_zero(self, number: Any) -> None:
        """Nothing: surplus equations are not checked."""


def _sum_products(left: Sequence[Any], right: Sequence[Any]) -> Any:
    """The sum of the products."""
    return sum((a * b for a, b in zip(left, right, strict=True)), 0)


def make_mistaken_motion(
    mechanism: Mechanism,
    arithmetic: Arithmetic,
    plan: Plan,
    slips: Slips,
    *,
    perturbed: bool = False,
) -> MistakenMotion:
    """The motion with the slips made. Raises Singular where a step determines nothing,
    MechanismError.

    `perturbed` uses other velocities for the accelerations, none of which vanishes by chance: to
    see whether a term matters, or is merely zero here.
    """
    frames = slip_in_frames(build_frames(mechanism, arithmetic), slips)
    rates = _Velocities(frames, slips, arithmetic).run(plan)
    if perturbed:
        rates = dict(_perturb_rates(mechanism, rates))
    equations = [relation.equations() for relation in frames.relations]
    changes = plans.run_steps(
        plan,
        equations,
        lambda index: frames.relations[index].acceleration_side(rates),
        Unsuspecting(arithmetic),
    )
    return MistakenMotion(frames, plan, rates, changes, slips)


def _perturb_rates(mechanism: Mechanism, rates: Mapping[Rate, Any]) -> Iterator[tuple[Rate, Any]]:
    """Perturbed rates: those of translating bodies are zero, and no others."""
    still = {
        make_turning(joint.body)
        for joint in mechanism.joints
        if isinstance(joint, Parallel) and joint.of == GROUND
    }
    for place, (name, rate) in enumerate(rates.items()):
        yield name, rate if name in still else rate * 2 + place + 1


@dataclass(frozen=True)
class _Stage:
    """A step of the plan just solved: the equations of all relations, and the rates known with this
    step.
    """

    step: Step
    equations: plans.Equations
    rates: Mapping[Rate, Any]

    def sought(self, index: int) -> set[Rate]:
        """The rates in a relation that this step finds."""
        return set(self.equations[index][0]) & set(self.step.unknowns)

    def coefficient(self, index: int, rate: Rate) -> Vector:
        """The vector that a rate multiplies in a vector relation."""
        return Vector(self.equations[index][0][rate], self.equations[index][1][rate])


_Replacements = Iterator[tuple[Rate, Any]]


@dataclass(frozen=True)
class _Velocities:
    """The run of a plan for velocities, in which a step's results may be replaced by what a mistake
    gives.
    """

    frames: MistakenFrames
    slips: Slips
    arithmetic: Arithmetic

    def run(self, plan: Plan) -> dict[Rate, Any]:
        """The rates, rad/s and m/s, step by step."""
        centres = find_rolling_centres(self.frames)
        relations = [self.relation(relation, centres) for relation in self.frames.relations]
        equations = [relation.equations() for relation in relations]
        rates: dict[Rate, Any] = {}
        for step in plan.steps:
            if step.unknowns:
                sides = {
                    index: _find_remaining_sides(relations[index], equations[index], rates)
                    for index in step.relations
                }
                rates.update(
                    plans.run_steps(
                        Plan((step,)), equations, sides.__getitem__, Unsuspecting(self.arithmetic)
                    )
                )
                rates.update(self._replaced(_Stage(step, equations, rates)))
        return rates

    def relation(self, relation: Relation, centres: Mapping[Rate, str]) -> Relation:
        """A relation as it is written for velocities."""
        left, right = (
            find_velocity_chain(side, self.slips, centres)
            for side in (relation.left, relation.right)
        )
        return replace(relation, left=left, right=right)

    def _replaced(self, stage: _Stage) -> dict[Rate, Any]:
        """The rates that result from a transport velocity in place of the absolute one, and from a
        fixed pivot in place of the pole.
        """
        result: dict[Rate, Any] = {}
        for share, find in (
            (self.slips.relative, self._without_relative),
            (self.slips.pole, self._about_pivot),
        ):
            if not isinstance(share, int) or share != 1:
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
            relation = self.frames.relations[index]
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
                yield rate, self.sized(speed, stage.coefficient(index, rate), stage.rates[rate])

    def _about_pivot(self, stage: _Stage) -> _Replacements:
        """A body in plane motion turns about the fixed pivot of a body that it is pinned to,
        together with that body.
        """
        for body, neighbours in _find_pivots(self.frames).items():
            reached = [name for name in neighbours if make_turning(name) in stage.rates]
            if make_turning(body) not in stage.step.unknowns or not reached:
                continue
            neighbour = min(reached, key=lambda name: make_turning(name) in stage.step.unknowns)
            turning = self._common_rate(stage, body, neighbour, neighbours[neighbour])
            if turning is not None:
                pair = {make_turning(body), make_turning(neighbour)}
                yield from ((rate, turning) for rate in stage.step.unknowns if rate in pair)
                yield from self._ends(stage, pair, neighbours[neighbour], turning)

    def _common_rate(self, stage: _Stage, body: str, neighbour: str, pivot: Vector) -> Any:
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
        return self.sized(
            speed,
            self.frames.mechanism.points[base.point] - pivot,
            stage.rates[make_turning(neighbour)],
        )

    def _ends(self, stage: _Stage, pair: set[Rate], pivot: Vector, turning: Any) -> _Replacements:
        """The rates of the ends that the same step finds: the angular velocity times the distance
        to the pivot.
        """
        for index in stage.step.relations:
            relation = self.frames.relations[index]
            others = stage.sought(index) - pair
            ends = [term for term in (*relation.left, *relation.right) if term.rate in others]
            if pair & set(stage.equations[index][0]) and len(ends) == 1 and len(others) == 1:
                speed = (self.frames.mechanism.points[ends[0].point] - pivot) * turning
                yield (
                    ends[0].rate,
                    self.sized(speed, ends[0].coefficient(), stage.rates[ends[0].rate]),
                )

    def sized(self, speed: Vector, coefficient: Vector, like: Any) -> Any:
        """|speed| over |coefficient|, in the sense of `like`."""
        size = self.arithmetic.sqrt(speed.squared() / coefficient.squared())
        return size * self.arithmetic.sign(like)


def _find_remaining_sides(
    relation: Relation, equations: Sequence[Row], rates: Mapping[Rate, Any]
) -> list[Any]:
    """A relation's right-hand sides for velocities, minus what is already known."""
    return [
        side - sum((row[rate] * rates[rate] for rate in row if rate in rates), 0)
        for row, side in zip(equations, relation.velocity_side(), strict=True)
    ]


def _find_pivots(frames: MistakenFrames) -> dict[str, dict[str, Vector]]:
    """For each body in plane motion the bodies that it is pinned to, with their fixed pivots."""
    mechanism = frames.mechanism
    pins = [joint for joint in mechanism.joints if isinstance(joint, Pin)]
    fixed = {
        name: mechanism.points[pin.point]
        for pin in pins
        if GROUND in pin.bodies
        for name in pin.bodies
    }
    plane = [
        body.name
        for body in mechanism.bodies
        if body.name not in fixed
        and not body.particle
        and Parallel(body.name, GROUND) not in mechanism.joints
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
