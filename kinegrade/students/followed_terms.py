"""Chains and relations into which a student's values can be substituted: of points, and of Coriolis
and normal parts.

A point's motion is written by the shortest chain that the steps solved before give it: the end B of
a connecting rod, once found, moves along its guide, and a student who has another angular velocity
of the rod still has that motion of B.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, Literal, NamedTuple

from kinegrade.mechanics.frames import Frames
from kinegrade.mechanics.joints import GROUND
from kinegrade.mechanics.plan import Plan
from kinegrade.mechanics.rates import Rate, Rates
from kinegrade.mechanics.relations import Chain, Relation, Term
from kinegrade.mechanics.vector import Vector

Place = tuple[str, str]  # a body and a point of it
# What identifies a term in other chains: rate, point, base, frame
Sign = tuple[Rate, str, str, str]


class Share(NamedTuple):
    """What stands among the rates for the share that is taken of an acceleration of `point`: the
    Coriolis acceleration relative to the body `of`, or the normal one relative to the point `of`.
    """

    part: Literal["coriolis", "normal"]
    point: str
    of: str

    def find(self, rates: Mapping[Any, Any]) -> Any:
        """The share that is taken: all of it unless the student has given a value."""
        return rates.get(self, 1.0)


def make_offsets(place: Place) -> tuple[Rate, Rate]:
    """The rates of the additions to the two components of a point's motion."""
    body, point = place
    return Rate("added-x", body, point), Rate("added-y", body, point)


@dataclass(frozen=True)
class _OwnTerm(Term):
    """A term of whose normal and Coriolis parts only the share given among the rates is taken, if
    there is one.
    """

    def normal(self, rates: Rates) -> Vector:
        """The centripetal part that is taken, m/s^2."""
        taken: Vector = super().normal(rates) * Share("normal", self.point, self.base).find(rates)
        return taken

    def coriolis(self, rates: Rates) -> Vector:
        """The Coriolis part that is taken, m/s^2."""
        taken: Vector = super().coriolis(rates) * Share("coriolis", self.point, self.frame).find(
            rates
        )
        return taken


@dataclass(frozen=True)
class _OwnRelation(Relation):
    """A relation of whose imposed relative motion the share of the Coriolis acceleration is taken
    likewise.
    """

    def imposed_coriolis(self, rates: Rates) -> Vector:
        """The part of the Coriolis acceleration of the imposed relative motion that is taken,
        m/s^2.
        """
        point = self.left[-1].point if self.left else ""
        taken: Vector = super().imposed_coriolis(rates) * Share("coriolis", point, self.frame).find(
            rates
        )
        return taken


@dataclass(frozen=True)
class Shortcut:
    """A chain that a relation, solved in the step of number `step`, states to be equal to a shorter
    one.
    """

    long: tuple[Sign, ...]
    short: Chain
    step: int


@dataclass(frozen=True)
class OwnFrames(Frames):
    """Frames whose chains use the shortcuts and have, at `places`, a term for the additions
    there.
    """

    shortcuts: tuple[Shortcut, ...]
    places: tuple[Place, ...]
    known: dict[Place, Chain] = field(default_factory=dict, compare=False, repr=False)

    def chain(self, body: str, point: str) -> Chain:
        """The terms whose sum is the velocity of `point`, taken as a point of `body`, after all
        shortcuts.
        """
        place = body, point
        if place not in self.known:
            self.known[place] = self.with_additions(
                _shorten(super().chain(body, point), self.shortcuts)
            )
        return self.known[place]

    def with_additions(self, chain: Chain) -> Chain:
        """The terms, each followed by the additions to the motion of the point that it leads to."""
        return tuple(
            part
            for term in chain
            for part in (_open_term(term), *self.additions.get(_make_sign(term), ()))
        )

    @cached_property
    def additions(self) -> dict[Sign, Chain]:
        """The additions at the places, by the last term that leads there."""
        ends = {
            place: _shorten(super(OwnFrames, self).chain(*place), self.shortcuts)
            for place in self.places
        }
        return {
            _make_sign(chain[-1]): tuple(
                Term("sliding", name, axis, place[1])
                for name, axis in zip(
                    make_offsets(place), (Vector(1.0, 0.0), Vector(0.0, 1.0)), strict=True
                )
            )
            for place, chain in ends.items()
            if chain
        }

    @cached_property
    def relative(self) -> dict[tuple[str, str], Term]:
        """The relative motions that the plan solves for: of a point relative to a body."""
        chains = [side for relation in self.relations for side in (relation.left, relation.right)]
        return {
            (term.point, term.frame): _open_term(term)
            for chain in (*chains, *(b.chain for b in self.bases.values()))
            for term in chain
            if term.frame != GROUND
        }


def open_frames(frames: Frames, plan: Plan, places: Sequence[Place]) -> OwnFrames:
    """The frames with shortcuts, and with terms for the additions at `places`."""
    return OwnFrames(
        frames.mechanism,
        frames.bases,
        frames.relations,
        tuple(_find_shortcuts(frames, plan)),
        tuple(places),
    )


def open_relations(frames: OwnFrames, plan: Plan) -> tuple[Relation, ...]:
    """The relations by index, each with the shortcuts that earlier steps give."""
    number = {index: place for place, step in enumerate(plan.steps) for index in step.relations}
    return tuple(
        _open_relation(relation, frames, number[index])
        for index, relation in enumerate(frames.relations)
    )


def _open_relation(relation: Relation, frames: OwnFrames, step: int) -> Relation:
    """A relation as it is written at a step."""
    cuts = [cut for cut in frames.shortcuts if cut.step < step]
    left, right = (
        frames.with_additions(_shorten(side, cuts)) for side in (relation.left, relation.right)
    )
    return _OwnRelation(
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


def _find_shortcuts(frames: Frames, plan: Plan) -> Iterator[Shortcut]:
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
                yield Shortcut(tuple(map(_make_sign, long)), short, number)


def _shorten(chain: Chain, cuts: Sequence[Shortcut]) -> Chain:
    """The chain with shortcuts applied one after the other until none applies."""
    for cut in cuts:
        if cut.long == tuple(map(_make_sign, chain[: len(cut.long)])):
            return _shorten((*cut.short, *chain[len(cut.long) :]), cuts)
    return chain


def _make_sign(term: Term) -> Sign:
    """What identifies a term in other chains."""
    return term.rate, term.point, term.base, term.frame


def _open_term(term: Term) -> _OwnTerm:
    """The term, prepared for shares of its parts."""
    return _OwnTerm(term.kind, term.rate, term.vector, term.point, term.base, term.frame)
