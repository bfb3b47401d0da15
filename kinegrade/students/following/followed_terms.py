"""Chains and relations into which a student's values can be substituted: of points, and of Coriolis
and normal parts.

A point's motion is written by the shortest chain that the steps solved before give it: the end B of
a connecting rod, once found, moves along its guide, and a student who has another angular velocity
of the rod still has that motion of B.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Literal, NamedTuple

from kinegrade.mechanics.frames import Frames
from kinegrade.mechanics.motion import find_relative_terms
from kinegrade.mechanics.plan import Plan
from kinegrade.mechanics.rates import Rate, make_turning
from kinegrade.mechanics.relations.reading import Reading
from kinegrade.mechanics.relations.relation import Relation
from kinegrade.mechanics.relations.terms import Chain, Term
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.number import Number

Place = tuple[str, str]  # a body and a point of it
# What identifies a term in other chains: rate, point, base, frame
Sign = tuple[Rate, str, str, str]


class Share(NamedTuple):
    """Of what acceleration of `point` a student takes a share: the Coriolis acceleration relative
    to the body `of`, or the normal one relative to the point `of`.
    """

    part: Literal["coriolis", "normal"]
    point: str
    of: str


def make_offsets(place: Place) -> tuple[Rate, Rate]:
    """The rates of the additions to the two components of a point's motion."""
    body, point = place
    return Rate("added-x", body, point), Rate("added-y", body, point)


@dataclass(frozen=True)
class Shortcut:
    """A chain that a relation, solved in the step of number `step`, states to be equal to a shorter
    one.
    """

    long: tuple[Sign, ...]
    short: Chain
    step: int


@dataclass(frozen=True)
class FollowedReading(Reading):
    """The terms of a motion into which a student's values can be put.

    Chains use the `shortcuts`, or by whole chain the `detours` about another point of the body.
    `offsets` are the rates of the additions to the motion of a point, by the last term that leads
    there, and `ends` that term by place; `relative` has the relative motions that the plan solves
    for. `shares` are those of Coriolis and normal parts that are taken; 1 where there is none.
    """

    shortcuts: tuple[Shortcut, ...]
    detours: Mapping[tuple[Sign, ...], Chain]
    ends: Mapping[Place, Sign]
    additions: Mapping[Sign, Chain]
    relative: Mapping[tuple[str, str], Term]
    shares: Mapping[Share, Number]

    @property
    def offsets(self) -> tuple[Rate, ...]:
        """The rates of all additions."""
        return tuple(term.rate for chain in self.additions.values() for term in chain)

    def find_offsets(self, place: Place) -> tuple[Rate, ...]:
        """The rates of the additions to the two components of a point's motion; none for a point
        that has no additions.
        """
        end = self.ends.get(place)
        return () if end is None else tuple(term.rate for term in self.additions[end])

    def chain(self, chain: Chain) -> Chain:
        """The terms after all shortcuts or a detour, with the additions."""
        detour = self.detours.get(tuple(map(_make_sign, chain))) if self.detours else None
        return self._add(detour or _shorten(chain, self.shortcuts))

    def _add(self, chain: Chain) -> Chain:
        """The terms, each followed by the additions to the motion of the point that it leads to."""
        if not self.additions:
            return chain
        return tuple(
            part for term in chain for part in (term, *self.additions.get(_make_sign(term), ()))
        )

    def relation_at(self, step: int, relation: Relation) -> Relation:
        """A relation as it is written at a step, with the shortcuts that earlier steps give."""
        cuts = [cut for cut in self.shortcuts if cut.step < step]
        if relation.along is not None:
            return relation  # what is given of a motion is given of its own term
        left, right = (self._add(_shorten(side, cuts)) for side in (relation.left, relation.right))
        if left is relation.left and right is relation.right:
            return relation
        return replace(relation, left=left, right=right)

    def normal(self, rate: Rate, point: str, base: str, normal: Vector) -> Vector:
        """The share of a normal acceleration that is taken."""
        return normal * self.shares.get(Share("normal", point, base), 1.0)

    def coriolis(self, point: str, frame: str, coriolis: Vector) -> Vector:
        """The share of a Coriolis acceleration that is taken."""
        return coriolis * self.shares.get(Share("coriolis", point, frame), 1.0)

    def find_relative(self, point: str, frame: str) -> Term | None:
        """The term of a relative motion that the plan solves for."""
        return self.relative.get((point, frame))


def read_to_follow(frames: Frames, plan: Plan, places: Sequence[Place]) -> FollowedReading:
    """The reading with the shortcuts that the plan gives, and with terms for the additions at
    `places`.
    """
    shortcuts = tuple(_find_shortcuts(frames, plan))
    chains = {place: _shorten(frames.chain(*place), shortcuts) for place in places}
    ends = {place: _make_sign(chain[-1]) for place, chain in chains.items() if chain}
    additions = {sign: _make_additions(place) for place, sign in ends.items()}
    return FollowedReading(shortcuts, {}, ends, additions, find_relative_terms(frames), {})


def write_relations(frames: Frames, plan: Plan, reading: FollowedReading) -> list[Relation]:
    """The relations by index, each as it is written at its step."""
    number = {index: place for place, step in enumerate(plan.steps) for index in step.relations}
    return [
        reading.relation_at(number[index], relation)
        for index, relation in enumerate(frames.relations)
    ]


def _make_additions(place: Place) -> Chain:
    """The terms for the additions to the two components of a point's motion."""
    axes = (Vector(1.0, 0.0), Vector(0.0, 1.0))
    return tuple(
        Term("sliding", rate, axis, place[1])
        for rate, axis in zip(make_offsets(place), axes, strict=True)
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


def find_detours(frames: Frames) -> dict[tuple[Sign, ...], Chain]:
    """The chains of the points of a body by way of another point of it than its base, whose motion
    a relation states once more: a rod's end D by `v_B + omega x BD`, not by `v_A + omega x AD`.
    """
    places = [(body, point) for body in frames.mechanism.bodies for point in body.points]
    chains = {(body.name, point): frames.chain(body.name, point) for body, point in places}
    detours: dict[tuple[Sign, ...], Chain] = {}
    for relation in frames.relations:
        for side, other in ((relation.left, relation.right), (relation.right, relation.left)):
            about = [place for place, chain in chains.items() if chain and chain == side]
            for body, base in about if relation.is_vector else ():
                for point in frames.mechanism.body(body).points:
                    arm = frames.mechanism.points[point] - frames.mechanism.points[base]
                    turn = Term("rotation", make_turning(body), arm, point, base)
                    way = other if point == base else (*other, turn)
                    detours.setdefault(tuple(map(_make_sign, chains[body, point])), way)
    return detours


def _shorten(chain: Chain, cuts: Sequence[Shortcut]) -> Chain:
    """The chain with shortcuts applied one after the other until none applies."""
    if not cuts:
        return chain
    signs = tuple(map(_make_sign, chain))
    for cut in cuts:
        if cut.long == signs[: len(cut.long)]:
            return _shorten((*cut.short, *chain[len(cut.long) :]), cuts)
    return chain


def _make_sign(term: Term) -> Sign:
    """What identifies a term in other chains."""
    return term.rate, term.point, term.base, term.frame
