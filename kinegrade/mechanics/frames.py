"""From joints to relations: the chain of terms that leads from the ground to each body, and the
loops that remain.

Each body gets a base point whose motion is written first: a fixed pin, a driven or guided point, a
pin on a body that has been reached. Every joint that this does not use up closes a loop and states
a relation.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from typing import assert_never

from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.joints import Joint
from kinegrade.mechanics.laws import (
    Condition,
    EqualRotation,
    GuidedBody,
    GuidedPoint,
    SharedPoint,
)
from kinegrade.mechanics.mechanism import Body, Mechanism, select_shared
from kinegrade.mechanics.rates import Rate, make_turning
from kinegrade.mechanics.relations import Chain, Relation, Term
from kinegrade.mechanics.shapes import Circle, Line
from kinegrade.mechanics.shares import RIGHT
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.number import Arithmetic


@dataclass(frozen=True)
class Guide:
    """What a joint says of the point that it guides, and the term of that point's motion."""

    joint: Joint
    law: GuidedPoint
    term: Term


@dataclass(frozen=True)
class Base:
    """The base point of a body, the chain of its motion, and the joint that it uses up (or
    None).
    """

    point: str
    chain: Chain
    joint: Joint | None


@dataclass(frozen=True)
class Frames:
    """The chains of a mechanism's points and the relations that determine its rates.

    `guiding` are the numbers of the joints that guide points, by the rate of each point's motion.
    """

    mechanism: Mechanism
    bases: Mapping[str, Base]
    relations: tuple[Relation, ...]
    guiding: Mapping[Rate, int]
    chains: dict[tuple[str, str], Chain] = field(
        default_factory=dict, init=False, repr=False, compare=False
    )

    def chain(self, body: str, point: str) -> Chain:
        """The terms whose sum is the velocity of `point`, taken as a point of `body`."""
        place = body, point
        if place not in self.chains:
            self.chains[place] = build_chain(self.mechanism, self.bases, body, point)
        return self.chains[place]


def build_frames(mechanism: Mechanism, arithmetic: Arithmetic) -> Frames:
    """The chains and relations of a mechanism. Raises MechanismError for a joint of unknown bodies
    or points.
    """
    mechanism = mechanism.join_resting_to_ground()
    guides = _find_guides(mechanism)
    bases = _find_bases(mechanism, guides)
    relations = [
        relation
        for number, (joint, guide) in enumerate(zip(mechanism.joints, guides, strict=True))
        for relation in _state_joint(mechanism, bases, number, joint, guide)
    ]
    find_chain = partial(build_chain, mechanism, bases)
    relations += [
        driver.state(number, find_chain, mechanism.points, arithmetic)
        for number, driver in enumerate(mechanism.drivers)
    ]
    guiding = {guide.term.rate: number for number, guide in enumerate(guides) if guide}
    return Frames(mechanism, bases, tuple(relations), guiding)


def build_chain(mechanism: Mechanism, bases: Mapping[str, Base], body: str, point: str) -> Chain:
    """The terms from the ground to `point` of `body`: the base point's, then the rotation about
    it.
    """
    if body == GROUND:
        return ()
    base = bases[body]
    if point == base.point or mechanism.body(body).particle:
        return base.chain
    arm = mechanism.points[point] - mechanism.points[base.point]
    return (*base.chain, Term("rotation", make_turning(body), arm, point, base.point))


def _find_guides(mechanism: Mechanism) -> tuple[Guide | None, ...]:
    """For each joint the point that it guides; where one point is guided twice the rates get
    different names.
    """
    guides: list[Guide | None] = []
    taken: set[Rate] = set()
    for joint in mechanism.joints:
        guide = _find_guide(mechanism, joint)
        if guide and guide.term.rate in taken:
            rate = guide.term.rate._replace(number=len(guides))
            guide = replace(guide, term=replace(guide.term, rate=rate))
        if guide:
            taken.add(guide.term.rate)
        guides.append(guide)
    return tuple(guides)


def _find_guide(mechanism: Mechanism, joint: Joint) -> Guide | None:
    """The point that a joint guides, None where it guides none."""
    for condition in joint.conditions:
        match condition:
            case GuidedPoint():
                return Guide(joint, condition, _make_track_term(mechanism, condition))
            case GuidedBody(body=body, of=of, line=line):
                law = GuidedPoint(_choose_guided_point(mechanism, body), body, of, line)
                return Guide(joint, law, _make_track_term(mechanism, law))
            case SharedPoint() | EqualRotation():
                pass  # no point moves within a body
            case _:
                assert_never(condition)
    return None


def _make_track_term(mechanism: Mechanism, law: GuidedPoint) -> Term:
    """The point moves along a line, or about the centre of a circle, of another body."""
    point, body, of = law.point, law.body, law.of
    match law.track:
        case Line(direction=direction):
            return Term("sliding", Rate("sliding", body, point, of), direction, point, frame=of)
        case Circle(centre=centre):
            arm = mechanism.points[point] - mechanism.points[centre]
            return Term("arc", Rate("circling", body, point, of), arm, point, centre, of)
        case _:
            assert_never(law.track)


def _choose_guided_point(mechanism: Mechanism, body: str) -> str:
    """The point of a sliding body whose relative motion is used: one that is pinned to another
    body.
    """
    points = mechanism.body(body).points
    pinned = [shared.point for shared in mechanism.shared_points if body in shared.bodies]
    return next((point for point in pinned if point in points), points[0])


def _find_bases(mechanism: Mechanism, guides: Sequence[Guide | None]) -> dict[str, Base]:
    """A base for every body, the best candidates first, from the ground outwards."""
    bases: dict[str, Base] = {}
    waiting = {body.name: body for body in mechanism.bodies}
    while waiting:
        candidates = [
            (rank, order, name, base)
            for order, (name, body) in enumerate(waiting.items())
            for rank, base in _list_base_candidates(mechanism, bases, guides, body)
        ]
        if candidates:
            _, _, name, base = min(candidates, key=lambda candidate: candidate[:2])
        else:
            name, body = next(iter(waiting.items()))
            base = Base(body.points[0], _make_free_terms(body.points[0], name), None)
        bases[name] = base
        del waiting[name]
    return bases


def _list_base_candidates(
    mechanism: Mechanism, bases: Mapping[str, Base], guides: Sequence[Guide | None], body: Body
) -> Iterator[tuple[int, Base]]:
    """Possible bases of a body with their rank: fixed pin 0, driven guide 1, translating guide or
    wheel on a straight track 2, pin on a reached body 3, other guide 4, slot of a reached body 5;
    none for a free body.
    """
    for joint in mechanism.joints:
        for shared in select_shared(joint.conditions):
            if body.name in shared.bodies:
                yield from _list_pinned_bases(mechanism, bases, joint, shared)
    for guide in guides:
        if guide and guide.law.body == body.name and guide.law.of == GROUND:
            yield _rank_ground(mechanism, guide), Base(guide.law.point, (guide.term,), guide.joint)
        elif guide and guide.law.body == body.name and guide.law.of in bases:
            transport = build_chain(mechanism, bases, guide.law.of, guide.law.point)
            yield 5, Base(guide.law.point, (*transport, guide.term), guide.joint)


def _list_pinned_bases(
    mechanism: Mechanism, bases: Mapping[str, Base], joint: Joint, shared: SharedPoint
) -> Iterator[tuple[int, Base]]:
    """A shared point as a base: of the ground, or of a body that has been reached."""
    for other in shared.bodies:
        if other == GROUND:
            yield 0, Base(shared.point, (), joint)
        elif other in bases:
            chain = build_chain(mechanism, bases, other, shared.point)
            yield 3, Base(shared.point, chain, joint)


def _rank_ground(mechanism: Mechanism, guide: Guide) -> int:
    """1 for a guided point that is driven; 2 for one of a translating body, or the centre of a
    wheel on a straight track, which gives the rotation as well; 4 for others.
    """
    law = guide.law
    if any(driver.find_driven_point() == (law.point, law.body) for driver in mechanism.drivers):
        return 1
    rolls = guide.joint.relate_rates(0, mechanism.points, guide.term.rate) is not None
    straight = isinstance(law.track, Line)
    return 2 if law.body in mechanism.held_parallel or (rolls and straight) else 4


def _make_free_terms(point: str, body: str) -> Chain:
    """The two components of a free point's velocity."""
    return (
        Term("sliding", Rate("free-x", body, point), Vector(1, 0), point),
        Term("sliding", Rate("free-y", body, point), Vector(0, 1), point),
    )


def _state_joint(
    mechanism: Mechanism,
    bases: Mapping[str, Base],
    number: int,
    joint: Joint,
    guide: Guide | None,
) -> Iterator[Relation]:
    """What a joint states beyond what the bases have used of it."""
    for condition in joint.conditions:
        yield from _state_condition(mechanism, bases, joint, condition, guide)
    law = joint.relate_rates(number, mechanism.points, guide.term.rate if guide else None)
    if law:
        yield Relation(joint, turning=law.list_factors(RIGHT), source=law)


def _state_condition(
    mechanism: Mechanism,
    bases: Mapping[str, Base],
    joint: Joint,
    condition: Condition,
    guide: Guide | None,
) -> Iterator[Relation]:
    """One condition of a joint as relations."""
    match condition:
        case SharedPoint():
            yield from _state_shared_point(mechanism, bases, joint, condition)
        case GuidedPoint() | GuidedBody():
            if guide and not any(base.joint is joint for base in bases.values()):
                yield _state_guide(mechanism, bases, guide)
        case EqualRotation():
            yield Relation(joint, turning=condition.list_factors(RIGHT), source=condition)
        case _:
            assert_never(condition)


def _state_guide(mechanism: Mechanism, bases: Mapping[str, Base], guide: Guide) -> Relation:
    """The guided point moves with the body that guides it, and along its track there."""
    law = guide.law
    left = build_chain(mechanism, bases, law.body, law.point)
    right = (*build_chain(mechanism, bases, law.of, law.point), guide.term)
    return Relation(guide.joint, left, right, source=law)


def _state_shared_point(
    mechanism: Mechanism, bases: Mapping[str, Base], joint: Joint, shared: SharedPoint
) -> Iterator[Relation]:
    """The bodies share the motion of the point; those whose base is this joint do so already."""
    unused = [name for name in shared.bodies if name == GROUND or bases[name].joint is not joint]
    first = GROUND if GROUND in unused else unused[0]
    for name in unused:
        if name != first:
            left = build_chain(mechanism, bases, name, shared.point)
            right = build_chain(mechanism, bases, first, shared.point)
            yield Relation(joint, left, right, source=shared)
