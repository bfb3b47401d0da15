"""From joints to relations: the chain of terms that leads from the ground to each body, and the
loops that remain.

Every joint that no base point uses up (`bases`) closes a loop and states a relation.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import partial
from typing import assert_never

from kinegrade.mechanics.bases import Base, Guide, build_chain, find_bases, find_guides
from kinegrade.mechanics.drivers import Driver
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.joints import Joint
from kinegrade.mechanics.laws import (
    Condition,
    EqualBeltSpeed,
    EqualPitchSpeed,
    EqualRotation,
    GuidedBody,
    GuidedPoint,
    ImposedCircling,
    ImposedComponent,
    ImposedMotion,
    ImposedRotation,
    Law,
    NoSlip,
    SharedPoint,
)
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.rates import Rate
from kinegrade.mechanics.relations.relation import Relation
from kinegrade.mechanics.relations.terms import Chain, Term
from kinegrade.mechanics.shares import RIGHT
from kinegrade.mechanics.vector import AxisName
from kinegrade.numbers.number import Arithmetic


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
    guides = find_guides(mechanism)
    bases = find_bases(mechanism, guides)
    relations = [
        relation
        for number, (joint, guide) in enumerate(zip(mechanism.joints, guides, strict=True))
        for relation in _state_joint(mechanism, bases, number, joint, guide)
    ]
    find_chain = partial(build_chain, mechanism, bases)
    for number, driver in enumerate(mechanism.drivers):
        imposed = driver.state(number, find_chain, mechanism.points, arithmetic)
        track = _find_driven_term(mechanism, guides, driver, imposed, arithmetic)
        relations.append(_impose_term(imposed, track) if track else imposed)
    guiding = {guide.term.rate: number for number, guide in enumerate(guides) if guide}
    return Frames(mechanism, bases, tuple(relations), guiding)


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


def _find_driven_term(
    mechanism: Mechanism,
    guides: Iterable[Guide | None],
    driver: Driver,
    imposed: Relation,
    arithmetic: Arithmetic,
) -> Term | None:
    """The motion whose rate alone a driver imposes: that along the straight track which guides the
    driven point in the body relative to which it is driven, as the rod of a hydraulic cylinder
    comes out of that, or a component of a point that is driven along both axes.

    Taken as the difference of the chains of both bodies, it would have their unknown rotations too.
    """
    driven, along = driver.find_driven_point(), imposed.along
    if driven is None or along is None:
        return None
    point, body = driven
    tracks = [
        guide.term
        for guide in filter(None, guides)
        if (guide.law.point, guide.law.of) == (point, imposed.frame)
        and mechanism.holds(SharedPoint(point, (guide.law.body, body)))
    ]
    for term in (*tracks, *_list_free_terms(imposed)):
        if term.kind == "sliding" and arithmetic.is_zero(along.cross(term.vector)):
            return term
    return None


def _impose_term(imposed: Relation, term: Term) -> Relation:
    """A driver's relation where it imposes the rate of one term alone."""
    match term.rate.kind:
        case "free-x":
            source = _impose_component(imposed.source, "x")
        case "free-y":
            source = _impose_component(imposed.source, "y")
        case "turning" | "sliding" | "circling" | "added-x" | "added-y":
            source = imposed.source
        case _:
            assert_never(term.rate.kind)
    return replace(imposed, left=(term,), right=(), source=source)


def _impose_component(law: Law | None, axis: AxisName) -> Law | None:
    """The law of a driver of a free point, which imposes a component of its motion where it does
    not move it about a centre.
    """
    match law:
        case ImposedMotion(driver=driver, point=point, direction=direction):
            return ImposedComponent(driver, point, axis, direction)
        case ImposedCircling() | ImposedComponent() | ImposedRotation() | None:
            return law
        case SharedPoint() | GuidedPoint() | EqualRotation():
            return law
        case NoSlip() | EqualPitchSpeed() | EqualBeltSpeed():
            return law
        case _:
            assert_never(law)


def _list_free_terms(imposed: Relation) -> Chain:
    """The components of a driven point that nothing guides, as seen from the ground; none where
    other terms have a share in its motion.
    """
    free = all(term.rate.kind in ("free-x", "free-y") for term in imposed.left)
    return imposed.left if free and imposed.frame == GROUND else ()


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
