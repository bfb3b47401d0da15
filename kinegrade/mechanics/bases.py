"""The base point of each body, whose motion is written first: a fixed pin, a driven or guided
point, a pin on a body that has been reached; from it the chain of terms of any point.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import assert_never

from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.joints import Joint
from kinegrade.mechanics.laws import (
    EqualRotation,
    GuidedBody,
    GuidedPoint,
    SharedPoint,
)
from kinegrade.mechanics.mechanism import Body, Mechanism, select_shared
from kinegrade.mechanics.rates import Rate, make_turning
from kinegrade.mechanics.relations.terms import Chain, Term
from kinegrade.mechanics.shapes import Circle, Line
from kinegrade.mechanics.vector import Vector


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


def find_guides(mechanism: Mechanism) -> tuple[Guide | None, ...]:
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


def find_bases(mechanism: Mechanism, guides: Sequence[Guide | None]) -> dict[str, Base]:
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
    """Possible bases of a body with their rank: fixed pin 0, driven guide or point driven along two
    directions 1, translating guide or wheel on a straight track 2, pin on a reached body 3, other
    guide 4, slot of a reached body 5; none for a free body.
    """
    for point in body.points:
        if _is_driven_freely(mechanism, body, point):
            yield 1, Base(point, _make_free_terms(point, body.name), None)
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


def _is_driven_freely(mechanism: Mechanism, body: Body, point: str) -> bool:
    """Whether drivers move a point of a body along two directions, seen from the ground."""
    components = [
        driver
        for driver in mechanism.drivers
        if driver.find_driven_point() == (point, body.name) and driver.find_frame() == GROUND
    ]
    return len(components) > 1


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
