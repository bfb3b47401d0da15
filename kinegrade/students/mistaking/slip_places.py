"""Where in a mechanism slips are made: which of its terms and rates they concern."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import permutations

from kinegrade.mechanics.frames import Frames
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.laws import find_rolling
from kinegrade.mechanics.plan import Plan
from kinegrade.mechanics.rates import Rate, make_turning
from kinegrade.mechanics.relations.terms import Chain, Term
from kinegrade.students.mistaking.rods import Rod, find_rods

Sign = tuple[Rate, str, str]  # what identifies a term: rate, point, base


@dataclass(frozen=True)
class SlipPlaces:
    """The places of slips in a mechanism.

    - pinned: the rates of the bodies that turn about a fixed pin.
    - centres: the centres of rolling bodies, by their turning rates.
    - still: the rates of the bodies that cannot turn.
    - finding: the terms from whose vector equations the plan finds their rates.
    - rods: the rods, in the order in which the plan finds their rates.
    - transports: the transport motions in the other one of two moving bodies that guide a point, by
      the terms of its relative motions.
    """

    pinned: frozenset[Rate]
    centres: Mapping[Rate, str]
    still: frozenset[Rate]
    finding: frozenset[Sign]
    rods: tuple[Rod, ...]
    transports: Mapping[Sign, Chain]


def find_slip_places(frames: Frames, plan: Plan) -> SlipPlaces:
    """The places of slips in a mechanism that is solved by a plan."""
    return SlipPlaces(
        frozenset(make_turning(name) for name, base in frames.bases.items() if not base.chain),
        _find_rolling_centres(frames),
        frozenset(map(make_turning, frames.mechanism.find_translating())),
        frozenset(_find_finding_terms(frames, plan)),
        tuple(find_rods(frames, plan)),
        dict(_find_other_transports(frames)),
    )


def make_sign(term: Term) -> Sign:
    """What identifies a term."""
    return term.rate, term.point, term.base


def _find_rolling_centres(frames: Frames) -> dict[Rate, str]:
    """For each rolling body the point that is its centre, by the body's turning rate."""
    return {
        make_turning(roll.body): roll.circle.centre
        for relation in frames.relations
        if (roll := find_rolling(relation.source))
    }


def _find_finding_terms(frames: Frames, plan: Plan) -> Iterator[Sign]:
    """The terms in whose vector equations the plan finds their rates."""
    for step in plan.steps:
        for relation in (frames.relations[index] for index in step.relations):
            for term in (*relation.left, *relation.right):
                if relation.is_vector and term.rate in step.unknowns:
                    yield make_sign(term)


def _find_other_transports(frames: Frames) -> Iterator[tuple[Sign, Chain]]:
    """For each motion of a point relative to one of two moving bodies that guide it: the chain of
    its transport motion in the other one.
    """
    for relation in frames.relations:
        for side, other in permutations((relation.left, relation.right)):
            if side and other and GROUND not in (side[-1].frame, other[-1].frame):
                yield make_sign(side[-1]), other[:-1]
