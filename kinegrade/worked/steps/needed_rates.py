"""Which rates the answers of a question need, and so which steps of the plan its solution takes."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from kinegrade.errors import MechanismError
from kinegrade.expressions.expression import Call, Expression, Name, walk
from kinegrade.language.message import Fault, Message, list_plainly
from kinegrade.mechanics.joints import GROUND
from kinegrade.mechanics.motion import Motion
from kinegrade.mechanics.plan import Step
from kinegrade.mechanics.rates import Rate, make_turning
from kinegrade.mechanics.relations import Chain
from kinegrade.problem.quantities import Quantities

_RELATIVE = ("relative_velocity", "relative_acceleration", "coriolis")
_ACCELERATIONS = frozenset(
    {"acceleration", "relative_acceleration", "alpha", "tangential_acceleration"}
)


@dataclass(frozen=True)
class Needs:
    """The rates whose values, and whose changes, are needed."""

    rates: frozenset[Rate]
    changes: frozenset[Rate]

    def __or__(self, other: Needs) -> Needs:
        return Needs(self.rates | other.rates, self.changes | other.changes)


NOTHING = Needs(frozenset(), frozenset())


def find_calls(tree: Expression) -> Iterator[Call]:
    """All calls within an expression, outer ones first."""
    return (part for part in walk(tree) if isinstance(part, Call))


def find_chains(call: Call, motion: Motion, quantities: Quantities) -> list[tuple[str, str]]:
    """The (body, point) pairs whose motion a call refers to."""
    names = [argument.name for argument in call.arguments if isinstance(argument, Name)]
    match call.function:
        case "velocity" | "acceleration":
            return [(_find_body(names, quantities, motion), names[0])]
        case "relative_velocity" | "relative_acceleration" | "coriolis":
            return [(names[1], names[0]), (names[2], names[0])]
        case "pole" | "circle_of_poles":
            return [(names[0], motion.frames.bases[names[0]].point)]
        case _:
            return []  # a function of numbers, positions or rotations


def _find_body(names: list[str], quantities: Quantities, motion: Motion) -> str:
    """The body that a point belongs to."""
    return names[1] if len(names) > 1 else quantities.owner(names[0], None)


def _find_turning_bodies(call: Call) -> list[str]:
    """The bodies whose rotation a call refers to."""
    names = [argument.name for argument in call.arguments if isinstance(argument, Name)]
    match call.function:
        case "omega" | "alpha":
            return names
        case (
            "normal_acceleration" | "tangential_acceleration" | "coriolis" | "relative_acceleration"
        ):
            return names[2:3]
        case "pole" | "circle_of_poles":
            return names[:1]
        case _:
            return []  # a function of numbers, positions or velocities


def find_needs(tree: Expression, motion: Motion, quantities: Quantities) -> Needs:
    """What the quantity of an ask needs."""
    needs = NOTHING
    for call in find_calls(tree):
        rates = {
            term.rate
            for body, point in find_chains(call, motion, quantities)
            for term in motion.frames.chain(body, point)
        }
        rates |= {make_turning(body) for body in _find_turning_bodies(call) if body != GROUND}
        rates &= set(motion.rates)
        changes = rates if call.function in _ACCELERATIONS else set()
        needs |= Needs(frozenset(rates), frozenset(changes))
    return needs


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
