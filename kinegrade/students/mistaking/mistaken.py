"""The motion that slips lead to: the plan runs on with mistaken terms, in any arithmetic.

A student who makes a mistake does not notice it: surplus equations are not checked, and where there
are more equations than unknowns, the vectors are projected. What is taken for the results of a step
of the plan, by mistakes that concern magnitudes, is in `misjudged_steps`.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from kinegrade.mechanics import plan as plans
from kinegrade.mechanics.frames import Frames, build_frames
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.motion import Motion
from kinegrade.mechanics.plan import Plan
from kinegrade.mechanics.rates import Rate, Rates, make_turning
from kinegrade.mechanics.relations.relation import Relation
from kinegrade.numbers.number import Arithmetic, Number
from kinegrade.students.mistaking.misjudged_steps import Misjudging, Stage
from kinegrade.students.mistaking.mistaken_reading import MistakenReading, read_with_slips
from kinegrade.students.mistaking.slips import Slips
from kinegrade.students.mistaking.unsuspecting import Unsuspecting


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
    reading = read_with_slips(frames, slips, plan, arithmetic)
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
        judge = Misjudging(self.frames, relations, self.reading, self.arithmetic)
        rates: dict[Rate, Number] = {}
        for step in plan.steps:
            if step.unknowns:
                rates.update(plans.solve_step(step, equations, sides, rates, solver))
                rates.update(judge.replace(Stage(step, equations, rates)))
        return rates

    def _write_for_velocities(self, relation: Relation) -> Relation:
        """A relation as it is written for velocities."""
        left, right = (
            self.reading.velocity_chain(side, whole=False)
            for side in (relation.left, relation.right)
        )
        return replace(relation, left=left, right=right)
