"""Chains and relations into which own values can be put: of points, and of Coriolis and normal
parts.

A point's motion is written by the shortest chain that the steps solved before give it: the end B of
a connecting rod, once found, moves along its guide, and whoever has another angular velocity of the
rod still has that motion of B.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import cached_property

from kinegrade.mechanics.frames import Frames
from kinegrade.mechanics.joints import GROUND
from kinegrade.mechanics.plan import Plan
from kinegrade.mechanics.relations import Chain, Rates, Relation, Term
from kinegrade.mechanics.vector import Vector

Place = tuple[str, str]  # a body and a point of it
# By what a term is known in other chains: rate, point, base, frame
Sign = tuple[str, str, str, str]


def coriolis_share(point: str, frame: str) -> str:
    """The name, among the rates, of what is taken of the Coriolis acceleration of `point` seen from
    `frame`.
    """
    return f"coriolis {point}/{frame}"


def normal_share(point: str, base: str) -> str:
    """The name, among the rates, of what is taken of the normal acceleration of `point` relative to
    `base`.
    """
    return f"normal {point}/{base}"


def offsets(place: Place) -> tuple[str, str]:
    """The names, among the rates, of what is added to the two components of a point's motion."""
    body, point = place
    return f"own {point} {body} x", f"own {point} {body} y"


@dataclass(frozen=True)
class OwnTerm(Term):
    """A term of whose normal and Coriolis parts the share is taken that stands among the rates, if
    one does.
    """

    def normal(self, rates: Rates) -> Vector:
        """What is taken of the centripetal part, m/s^2."""
        taken: Vector = super().normal(rates) * rates.get(normal_share(self.point, self.base), 1.0)
        return taken

    def coriolis(self, rates: Rates) -> Vector:
        """What is taken of the Coriolis part, m/s^2."""
        taken: Vector = super().coriolis(rates) * rates.get(
            coriolis_share(self.point, self.frame), 1.0
        )
        return taken


@dataclass(frozen=True)
class OwnRelation(Relation):
    """A relation of whose own Coriolis acceleration, of an imposed relative motion, the share is
    taken likewise.
    """

    def imposed_coriolis(self, rates: Rates) -> Vector:
        """What is taken of the Coriolis acceleration of the imposed relative motion, m/s^2."""
        point = self.left[-1].point if self.left else ""
        taken: Vector = super().imposed_coriolis(rates) * rates.get(
            coriolis_share(point, self.frame), 1.0
        )
        return taken


@dataclass(frozen=True)
class Shortcut:
    """A chain that a relation, solved in the step of number `step`, says to be equal to a shorter
    one.
    """

    long: tuple[Sign, ...]
    short: Chain
    step: int


@dataclass(frozen=True)
class OwnFrames(Frames):
    """Frames whose chains take the shortcuts and have, at `places`, a term for what is added
    there.
    """

    shortcuts: tuple[Shortcut, ...]
    places: tuple[Place, ...]
    known: dict[Place, Chain] = field(default_factory=dict, compare=False, repr=False)

    def chain(self, body: str, point: str) -> Chain:
        """The terms whose sum is the velocity of `point`, taken as a point of `body`, as they stand
        in the end.
        """
        place = body, point
        if place not in self.known:
            self.known[place] = self.with_own(shortened(super().chain(body, point), self.shortcuts))
        return self.known[place]

    def with_own(self, chain: Chain) -> Chain:
        """The terms, each followed by what is added to the motion of the point that it leads to."""
        return tuple(
            part for term in chain for part in (own(term), *self.additions.get(sign(term), ()))
        )

    @cached_property
    def additions(self) -> dict[Sign, Chain]:
        """What is added at the places, by the last term that leads there."""
        ends = {
            place: shortened(super(OwnFrames, self).chain(*place), self.shortcuts)
            for place in self.places
        }
        return {
            sign(chain[-1]): tuple(
                Term("sliding", name, axis, place[1])
                for name, axis in zip(
                    offsets(place), (Vector(1.0, 0.0), Vector(0.0, 1.0)), strict=True
                )
            )
            for place, chain in ends.items()
            if chain
        }

    @cached_property
    def relative(self) -> dict[tuple[str, str], Term]:
        """The relative motions that the plan solves for: of a point, seen from a body."""
        chains = [side for relation in self.relations for side in (relation.left, relation.right)]
        return {
            (term.point, term.frame): own(term)
            for chain in (*chains, *(b.chain for b in self.bases.values()))
            for term in chain
            if term.frame != GROUND
        }


def own_frames(frames: Frames, plan: Plan, places: Sequence[Place]) -> OwnFrames:
    """The frames with shortcuts, and with terms for what is added at `places`."""
    return OwnFrames(
        frames.mechanism,
        frames.bases,
        frames.relations,
        tuple(shortcuts(frames, plan)),
        tuple(places),
    )


def own_relations(frames: OwnFrames, plan: Plan) -> tuple[Relation, ...]:
    """The relations by index, each with the shortcuts that earlier steps give."""
    number = {index: place for place, step in enumerate(plan.steps) for index in step.relations}
    return tuple(
        own_relation(relation, frames, number[index])
        for index, relation in enumerate(frames.relations)
    )


def own_relation(relation: Relation, frames: OwnFrames, step: int) -> Relation:
    """A relation as it stands at a step."""
    cuts = [cut for cut in frames.shortcuts if cut.step < step]
    left, right = (
        frames.with_own(shortened(side, cuts)) for side in (relation.left, relation.right)
    )
    return OwnRelation(
        relation.origin,
        left,
        right,
        relation.along,
        relation.turning,
        relation.velocity,
        relation.acceleration,
        relation.frame,
        relation.source,
    )


def shortcuts(frames: Frames, plan: Plan) -> Iterator[Shortcut]:
    """The vector relations of the plan's steps of which one side is shorter, and known no later
    than the other.
    """
    found = {rate: number for number, step in enumerate(plan.steps) for rate in step.unknowns}
    for number, step in enumerate(plan.steps):
        for relation in (frames.relations[index] for index in step.relations if step.unknowns):
            short, long = sorted((relation.left, relation.right), key=len)
            last, latest = (
                max((found[term.rate] for term in side), default=-1) for side in (short, long)
            )
            if relation.is_vector and len(short) < len(long) and last <= latest:
                yield Shortcut(tuple(map(sign, long)), short, number)


def shortened(chain: Chain, cuts: Sequence[Shortcut]) -> Chain:
    """The chain with the shortcuts taken, one after the other, as long as there is one."""
    for cut in cuts:
        if cut.long == tuple(map(sign, chain[: len(cut.long)])):
            return shortened((*cut.short, *chain[len(cut.long) :]), cuts)
    return chain


def sign(term: Term) -> Sign:
    """By what a term is known in other chains."""
    return term.rate, term.point, term.base, term.frame


def own(term: Term) -> OwnTerm:
    """The term, open to own shares."""
    return OwnTerm(term.kind, term.rate, term.vector, term.point, term.base, term.frame)
