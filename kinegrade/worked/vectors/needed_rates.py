"""Which rates the answers of a question need, and so which steps of the plan its solution takes."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from kinegrade.errors import MechanismError
from kinegrade.expressions.tree import Call, Expression, Name
from kinegrade.language.message import Fault, Message, list_plainly
from kinegrade.mechanics.joints import GROUND
from kinegrade.mechanics.motion import Motion
from kinegrade.mechanics.plan import Step
from kinegrade.mechanics.rates import Rate, make_turning
from kinegrade.mechanics.relations.terms import Chain, Term
from kinegrade.mechanics.vector_equation import Level
from kinegrade.problem.quantities.functions import find_motion_calls
from kinegrade.problem.quantities.motion_function import References
from kinegrade.problem.quantities.motion_functions import MOTION_FUNCTIONS
from kinegrade.problem.quantities.reader import MotionReader
from kinegrade.worked.findings import Ways
from kinegrade.worked.formulas.measures import double
from kinegrade.worked.vectors.known_vectors import list_ways
from kinegrade.worked.vectors.relatives import find_relative


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


def find_needs(
    tree: Expression, reader: MotionReader, paths: Mapping[Ways, Chain] | None = None
) -> Needs:
    """What the quantity of an ask needs; by the path of a point where `paths` has that for what
    leads to it.
    """
    needs, motion, shorter = NOTHING, reader.motion, paths or {}
    for call in find_motion_calls(tree):
        references = find_references(call, reader)
        rates = {
            term.rate
            for body, point in references.points
            for term in _shorten(motion.frames.chain(body, point), shorter)
        }
        rates |= {make_turning(body) for body in references.turning if body != GROUND}
        rates |= {term.rate for term in _list_guided(call, motion)}
        rates &= set(motion.rates)
        changes = rates if MOTION_FUNCTIONS[call.function].by_changes else set()
        needs |= Needs(frozenset(rates), frozenset(changes))
    return needs


def _list_guided(call: Call, motion: Motion) -> Iterator[Term]:
    """The terms along whose track a relative motion goes that a call is about."""
    if MOTION_FUNCTIONS[call.function].derivation in ("relative", "coriolis"):
        for relation in motion.frames.relations:
            for term in (*relation.left, *relation.right):
                if term.rate.is_guided and find_relative(term).names == call.arguments:
                    yield term


def _shorten(chain: Chain, paths: Mapping[Ways, Chain]) -> Chain:
    return paths.get(list_ways(chain), chain)


def find_paths(motion: Motion) -> dict[Ways, Chain]:
    """The chains of bodies that lead to a point whose path is known, with that path: an equation of
    both gives the point's motion at once.
    """
    both = ((one.left, one.right) for one in motion.frames.relations if one.is_vector)
    sides = (pair for first, second in both for pair in ((first, second), (second, first)))
    return {list_ways(long): path for long, path in sides if len(path) == 1 < len(long)}


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


def find_spared(
    motion: Motion, velocities: Sequence[Step], accelerations: Sequence[Step], needs: Needs
) -> dict[Level, frozenset[Rate]]:
    """The rates that selected steps find beside those that answers and later steps need."""
    factors = {
        rate
        for step in accelerations
        for index in step.relations
        for rate in _find_factors(motion, index)
    }
    return {
        "velocity": _list_spared(motion, {*needs.rates, *factors}, velocities),
        "acceleration": _list_spared(motion, set(needs.changes), accelerations),
    }


def _list_spared(motion: Motion, wanted: set[Rate], steps: Sequence[Step]) -> frozenset[Rate]:
    """What steps find that neither is wanted nor stands in a later step."""
    spared = set[Rate]()
    for step in reversed(steps):
        spared |= set(step.unknowns) - wanted
        wanted |= {
            rate for index in step.relations for rate in motion.frames.relations[index].unknowns()
        }
    return frozenset(spared)


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


def _find_factors(motion: Motion, index: int) -> Iterator[Rate]:
    """The rates that stand in a relation's accelerations: not those of points that move straight in
    a frame which does not turn, nor those in a sum of rates.
    """
    relation = motion.frames.relations[index]
    if relation.along is not None:
        yield from _find_rates(motion, index)
        return
    for term in (*relation.left, *relation.right):
        turns = term.frame != GROUND and bool(double(motion.omega(term.frame)))
        if turns:
            yield make_turning(term.frame)
        if turns or term.kind != "sliding":
            yield term.rate


def _find_rates(motion: Motion, index: int) -> Iterable[Rate]:
    """The rates on which a relation's accelerations depend: those of the relation itself, and of
    its reference frames.
    """
    relation = motion.frames.relations[index]
    chains: list[Chain] = [relation.left, relation.right]
    frames = {term.frame for chain in chains for term in chain} | {relation.frame}
    return {*relation.unknowns(), *(make_turning(frame) for frame in frames - {GROUND})}
