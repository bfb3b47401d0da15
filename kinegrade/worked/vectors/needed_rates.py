"""Which rates the answers of a question need, and so which steps of the plan its solution takes."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from kinegrade.errors import MechanismError
from kinegrade.expressions.tree import Call, Expression, Name
from kinegrade.language.message import Fault, Message, list_plainly
from kinegrade.mechanics.joints import GROUND
from kinegrade.mechanics.motion import Motion
from kinegrade.mechanics.plan import Step
from kinegrade.mechanics.rates import Rate, make_turning
from kinegrade.mechanics.relations import Chain
from kinegrade.problem.quantities.functions import find_motion_calls
from kinegrade.problem.quantities.motion_function import References
from kinegrade.problem.quantities.motion_functions import MOTION_FUNCTIONS
from kinegrade.problem.quantities.reader import MotionReader


@dataclass(frozen=True)
class Needs:
    """The rates whose values, and whose changes, are needed."""

    rates: frozenset[Rate]
    changes: frozenset[Rate]

    def __or__(self, other: Needs) -> Needs:
        return Needs(self.rates | other.rates, self.changes | other.changes)


NOTHING = Needs(frozenset(), frozenset())


def find_references(call: Call, reader: MotionReader) -> References:
    """What of the motion a call refers to."""
    names = [argument.name for argument in call.arguments if isinstance(argument, Name)]
    return MOTION_FUNCTIONS[call.function].refer(names, reader)


def find_needs(tree: Expression, reader: MotionReader) -> Needs:
    """What the quantity of an ask needs."""
    needs, motion = NOTHING, reader.motion
    for call in find_motion_calls(tree):
        references = find_references(call, reader)
        rates = {
            term.rate
            for body, point in references.points
            for term in motion.frames.chain(body, point)
        }
        rates |= {make_turning(body) for body in references.turning if body != GROUND}
        rates &= set(motion.rates)
        changes = rates if MOTION_FUNCTIONS[call.function].by_changes else set()
        needs |= Needs(frozenset(rates), frozenset(changes))
    return needs


def are_places(trees: Iterable[Expression]) -> bool:
    """Whether quantities are about poles alone: places, which no speed changes."""
    calls = [call for tree in trees for call in find_motion_calls(tree)]
    derivations = {MOTION_FUNCTIONS[call.function].derivation for call in calls}
    return bool(derivations) and derivations <= {"pole", "centrode"}


def select_steps(motion: Motion, needs: Needs) -> tuple[tuple[Step, ...], tuple[Step, ...]]:
    """The steps of the plan for velocities and for accelerations that the needs ask for, in the
    plan's order.
    """
    changes = _follow_back(motion, set(needs.changes))
    rates = set(needs.rates)
    for step in changes:
        rates |= set(step.unknowns) | {
            rate for index in step.relations for rate in _find_rates(motion, index)
        }
    return _follow_back(motion, rates), changes


def _follow_back(motion: Motion, wanted: set[Rate]) -> tuple[Step, ...]:
    """The steps that lead to the wanted rates, traced from the last to the first and returned in
    order.

    Raises MechanismError for a rate that no step of the plan gives.
    """
    chosen = []
    for step in reversed(motion.plan.steps):
        if wanted & set(step.unknowns):
            chosen.append(step)
            wanted |= {
                rate
                for index in step.relations
                for rate in motion.frames.relations[index].unknowns()
            }
    missing = wanted - {rate for step in chosen for rate in step.unknowns}
    if missing:
        names = sorted({rate.point or rate.body for rate in missing})
        what = Message("mechanics.rates-not-planned", rates=list_plainly(names))
        raise MechanismError(Fault("", what, do=Message("mechanics.solve-again")))
    return tuple(reversed(chosen))


def _find_rates(motion: Motion, index: int) -> Iterable[Rate]:
    """The rates on which a relation's accelerations depend: those of the relation itself, and of
    its reference frames.
    """
    relation = motion.frames.relations[index]
    chains: list[Chain] = [relation.left, relation.right]
    frames = {term.frame for chain in chains for term in chain} | {relation.frame}
    return {*relation.unknowns(), *(make_turning(frame) for frame in frames - {GROUND})}
