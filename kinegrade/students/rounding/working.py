"""An instance worked out in an arithmetic that writes values down, with all that any student
writes.

Each point is found from those before it by coordinates, each arm is written as a length and an
angle and again by components, and the plan is followed term by term. Whoever works by coordinates
alone, or by lengths and angles alone, writes down less.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from kinegrade.errors import AtInfinity, KinegradeError
from kinegrade.expressions.evaluation import evaluate
from kinegrade.mechanics import plan as plans
from kinegrade.mechanics.frames import build_frames
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.motion import Motion, find_relative_terms, pose_mechanism
from kinegrade.mechanics.plan import Plan
from kinegrade.mechanics.relations.reading import Reading
from kinegrade.mechanics.relations.terms import Chain, Term
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.number import Arithmetic
from kinegrade.problem.assembling.assemble import assemble
from kinegrade.problem.quantities.functions import make_quantities, needs_configurations
from kinegrade.problem.quantities.reader import find_body_names
from kinegrade.problem.template.template import Ask, Template


@dataclass(frozen=True)
class Working:
    """An instance of a template worked out in an arithmetic that writes down what it computes."""

    arithmetic: Arithmetic

    def answer(
        self, template: Template, asks: Mapping[str, Ask], values: Mapping[str, Any], plan: Plan
    ) -> dict[str, Any]:
        """The answers in SI at the parameters `values` (SI), without those that have none and
        without centrodes, which are known in closed form. Raises MechanismError, Singular.
        """
        assembly = assemble(template, values, self.arithmetic)
        motion = self._solve(assembly.mechanism, plan)
        known = {**find_body_names(assembly.mechanism), **assembly.values}
        functions = {**assembly.functions, **make_quantities(motion, self.arithmetic)}
        found = {}
        for name, ask in asks.items():
            if needs_configurations(ask.quantity):
                continue
            try:
                found[name] = evaluate(ask.quantity, known, functions, self.arithmetic)
            except (KinegradeError, AtInfinity):
                continue
        return found

    def _solve(self, mechanism: Mechanism, plan: Plan) -> Motion:
        """The motion by the plan, all of it written down."""
        if not plan.steps:
            return pose_mechanism(mechanism, self.arithmetic)
        frames = build_frames(mechanism, self.arithmetic)
        reading = _WrittenReading(self, find_relative_terms(frames))
        relations = [reading.relation(relation) for relation in frames.relations]
        equations = [relation.equations() for relation in relations]
        sides = [relation.velocity_side() for relation in relations]
        rates = plans.run_steps(plan, equations, sides, self.arithmetic)
        sides = [relation.acceleration_side(rates, reading) for relation in relations]
        changes = plans.run_steps(plan, equations, sides, self.arithmetic)
        return Motion(frames, plan, rates, changes, reading)

    def write_arm(self, arm: Vector) -> Vector:
        """An arm with its length and its acute angle to the x axis written down, and components
        found from these.
        """
        arithmetic = self.arithmetic
        length = arithmetic.magnitude(arm.x, arm.y)
        angle = arithmetic.arctangent(abs(arm.y), abs(arm.x))
        across, up = length * arithmetic.cos(angle), length * arithmetic.sin(angle)
        return Vector(
            arithmetic.choose(arithmetic.sign(arm.x) < 0, -across, across),
            arithmetic.choose(arithmetic.sign(arm.y) < 0, -up, up),
        )


@dataclass(frozen=True)
class _WrittenReading(Reading):
    """The terms with their arms as they are written down.

    `relative` has the relative motions that the plan solves for, which are not found again as
    differences: of a point relative to a body.
    """

    working: Working
    relative: Mapping[tuple[str, str], Term]

    def chain(self, chain: Chain) -> Chain:
        """The terms with their arms written down."""
        return tuple(map(self._write_arm, chain))

    def _write_arm(self, term: Term) -> Term:
        return term.put(self.working.write_arm(term.vector))

    def find_relative(self, point: str, frame: str) -> Term | None:
        """The term of a relative motion that the plan solves for, its arm written down."""
        term = self.relative.get((point, frame))
        return term and self._write_arm(term)
