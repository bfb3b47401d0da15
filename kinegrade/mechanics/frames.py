"""From joints to relations: the chain of terms that leads from the ground to each body, and the
loops that remain.

Each body gets a base point whose motion is written first: a fixed pin, a driven or guided point, a
pin on a body that has been reached. Every joint that this does not use up closes a loop and states
a relation.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, assert_never

from kinegrade.errors import MechanismError
from kinegrade.language.message import Fault, Message, list_all
from kinegrade.mechanics.drivers import Circulation, Component, Driver, Rotation
from kinegrade.mechanics.geometry import foot
from kinegrade.mechanics.joints import (
    GROUND,
    Arc,
    Circle,
    Contact,
    Joint,
    Line,
    Mesh,
    Parallel,
    Pin,
    Roll,
    Sleeve,
    Slide,
)
from kinegrade.mechanics.mechanism import Body, Mechanism
from kinegrade.mechanics.rates import Rate, make_turning
from kinegrade.mechanics.relations import Chain, Relation, Term
from kinegrade.mechanics.vector import Vector


@dataclass(frozen=True)
class Guided:
    """A joint as a guide: `point` of `body` moves along one direction or arc in the body `of`."""

    joint: Joint
    point: str
    body: str
    of: str
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
    """The chains of a mechanism's points and the relations that determine its rates."""

    mechanism: Mechanism
    bases: Mapping[str, Base]
    relations: tuple[Relation, ...]

    def chain(self, body: str, point: str) -> Chain:
        """The terms whose sum is the velocity of `point`, taken as a point of `body`."""
        return build_chain(self.mechanism, self.bases, body, point)


def build_frames(mechanism: Mechanism, arithmetic: Any) -> Frames:
    """The chains and relations of a mechanism. Raises MechanismError for a joint of unknown bodies
    or points.
    """
    guides = _find_guides(mechanism)
    bases = _find_bases(mechanism, guides)
    relations = [
        relation
        for joint, guide in zip(mechanism.joints, guides, strict=True)
        for relation in _state_joint(mechanism, bases, joint, guide)
    ]
    relations += [
        _state_driver(mechanism, bases, driver, arithmetic) for driver in mechanism.drivers
    ]
    return Frames(mechanism, bases, tuple(relations))


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


def _find_guides(mechanism: Mechanism) -> tuple[Guided | None, ...]:
    """For each joint the guided point that it states; where one point is guided twice the rates get
    different names.
    """
    guides: list[Guided | None] = []
    taken: set[Rate] = set()
    for joint in mechanism.joints:
        guide = find_guided(mechanism, joint)
        if guide and guide.term.rate in taken:
            term = replace(guide.term, rate=guide.term.rate._replace(number=len(guides)))
            guide = replace(guide, term=term)
        if guide:
            taken.add(guide.term.rate)
        guides.append(guide)
    return tuple(guides)


def find_guided(mechanism: Mechanism, joint: Joint) -> Guided | None:
    """The guided point that a joint states, or None for joints that guide no point."""
    track: Line | Circle
    match joint:
        case Slide(point=point, line=track) | Arc(point=point, circle=track):
            pass
        case Sleeve(line=track):
            point = _choose_sleeve_point(mechanism, joint)
        case Contact(circle=circle, on=track) | Roll(circle=circle, on=track):
            point = circle.centre
        case Pin() | Mesh() | Parallel():
            return None
        case _:
            assert_never(joint)
    body, of = joint.body, joint.of
    return Guided(joint, point, body, of, _make_track_term(mechanism, point, body, track, of))


def _make_track_term(
    mechanism: Mechanism, point: str, body: str, track: Line | Circle, of: str
) -> Term:
    """`point` of `body` moves along a line, or about the centre of a circle, relative to `of`."""
    match track:
        case Line(direction=direction):
            return Term("sliding", Rate("sliding", body, point, of), direction, point, frame=of)
        case Circle(centre=centre):
            arm = mechanism.points[point] - mechanism.points[centre]
            return Term("arc", Rate("circling", body, point, of), arm, point, centre, of)
        case _:
            assert_never(track)


def _choose_sleeve_point(mechanism: Mechanism, sleeve: Sleeve) -> str:
    """The point of the sliding body whose relative motion is used: one that is pinned to another
    body.
    """
    points = mechanism.body(sleeve.body).points
    pinned = [
        joint.point
        for joint in mechanism.joints
        if isinstance(joint, Pin) and sleeve.body in joint.bodies
    ]
    return next((point for point in pinned if point in points), points[0])


def _find_bases(mechanism: Mechanism, guides: Sequence[Guided | None]) -> dict[str, Base]:
    """A base for every body, the best candidates first, from the ground outwards."""
    bases: dict[str, Base] = {}
    waiting = {body.name: body for body in mechanism.bodies}
    while waiting:
        candidates = [
            (rank, order, name, base)
            for order, (name, body) in enumerate(waiting.items())
            for rank, base in _list_base_candidates(mechanism, bases, guides, body)
        ]
        _, _, name, base = min(candidates, key=lambda candidate: candidate[:2])
        bases[name] = base
        del waiting[name]
    return bases


def _list_base_candidates(
    mechanism: Mechanism, bases: Mapping[str, Base], guides: Sequence[Guided | None], body: Body
) -> Iterator[tuple[int, Base]]:
    """Possible bases of a body with their rank: fixed pin 0, driven guide 1, translating guide 2,
    pin on a reached body 3, other guide 4, slot of a reached body 5, free point 6.
    """
    for joint in mechanism.joints:
        if isinstance(joint, Pin) and body.name in joint.bodies:
            for other in joint.bodies:
                if other == GROUND:
                    yield 0, Base(joint.point, (), joint)
                elif other in bases:
                    yield (
                        3,
                        Base(joint.point, build_chain(mechanism, bases, other, joint.point), joint),
                    )
    for guide in guides:
        if guide and guide.body == body.name and guide.of == GROUND:
            yield _rank_ground(mechanism, guide), Base(guide.point, (guide.term,), guide.joint)
        elif guide and guide.body == body.name and guide.of in bases:
            yield (
                5,
                Base(
                    guide.point,
                    (*build_chain(mechanism, bases, guide.of, guide.point), guide.term),
                    guide.joint,
                ),
            )
    yield 6, Base(body.points[0], _make_free_terms(body.points[0], body.name), None)


def _rank_ground(mechanism: Mechanism, guide: Guided) -> int:
    """1 for a guided point that is driven, 2 for one of a translating body, 4 for others."""
    driven = any(
        isinstance(driver, Component | Circulation)
        and (driver.point, driver.body) == (guide.point, guide.body)
        for driver in mechanism.drivers
    )
    if driven:
        return 1
    return 2 if Parallel(guide.body, GROUND) in mechanism.joints else 4


def _make_free_terms(point: str, body: str) -> Chain:
    """The two components of a free point's velocity."""
    return (
        Term("sliding", Rate("free-x", body, point), Vector(1, 0), point),
        Term("sliding", Rate("free-y", body, point), Vector(0, 1), point),
    )


def _state_joint(
    mechanism: Mechanism, bases: Mapping[str, Base], joint: Joint, guide: Guided | None
) -> Iterator[Relation]:
    """What a joint states beyond what the bases have used of it."""
    if guide and not any(base.joint is joint for base in bases.values()):
        right = (*build_chain(mechanism, bases, guide.of, guide.point), guide.term)
        yield Relation(
            name_element(joint),
            build_chain(mechanism, bases, guide.body, guide.point),
            right,
            source=joint,
        )
    match joint:
        case Pin():
            yield from _state_pin(mechanism, bases, joint)
        case Parallel() | Sleeve():
            yield Relation(
                Message("mechanics.equal-rotation", body=joint.body, of=joint.of),
                turning=_list_turning_factors(joint.body, joint.of, 1),
                source=joint,
            )
        case Roll():
            if guide:
                yield _state_rolling(mechanism, joint, guide)
        case Mesh():
            yield _state_meshing(joint)
        case Slide() | Arc() | Contact():
            pass  # they state nothing but what they guide
        case _:
            assert_never(joint)


def _state_pin(mechanism: Mechanism, bases: Mapping[str, Base], pin: Pin) -> Iterator[Relation]:
    """The pinned bodies share the motion of the pin; bodies whose base is this pin do so
    already.
    """
    unused = [name for name in pin.bodies if name == GROUND or bases[name].joint is not pin]
    first = GROUND if GROUND in unused else unused[0]
    for name in unused:
        if name != first:
            yield Relation(
                name_element(pin),
                build_chain(mechanism, bases, name, pin.point),
                build_chain(mechanism, bases, first, pin.point),
                source=pin,
            )


def _list_turning_factors(body: str, of: str, factor: Any) -> tuple[tuple[Rate, Any], ...]:
    """factor*(omega of body - omega of the other); the ground does not turn."""
    parts = [(name, part) for name, part in ((body, factor), (of, -factor)) if name != GROUND]
    return tuple((make_turning(name), part) for name, part in parts)


def _state_rolling(mechanism: Mechanism, roll: Roll, guide: Guided) -> Relation:
    """No slip at the contact: the centre's motion along the track plus the relative rotation about
    it is zero.

    On a line: s u.u + omega_r u.(k x CF) = 0; on a circle of radius R: rate of the centre plus
    omega_r times -r/(R + r) outside, r/(R - r) inside (F the contact, C the centre of the rolling
    circle, r its radius).
    """
    match roll.on:
        case Line(direction=along):
            centre = mechanism.points[roll.circle.centre]
            slip = along.dot((foot(centre, roll.on) - centre).turned()) / along.squared()
        case Circle(radius=other):
            radius = roll.circle.radius
            slip = radius / (other - radius) if roll.inside else -radius / (other + radius)
        case _:
            assert_never(roll.on)
    relative = ((guide.term.rate, 1), *_list_turning_factors(roll.body, roll.of, slip))
    origin = Message("mechanics.no-slip", rolling=name_element(roll))
    return Relation(origin, turning=relative, source=roll)


def _state_meshing(mesh: Mesh) -> Relation:
    """Equal pitch speeds relative to the carrier: r1 omega_1r = -r2 omega_2r, with + for a ring
    gear.
    """
    sense = -1 if mesh.inside else 1
    radius, other = mesh.circle.radius, mesh.on.radius * sense
    rates: dict[Rate, Any] = {}
    for rate, factor in (
        *_list_turning_factors(mesh.body, mesh.carrier, radius),
        *_list_turning_factors(mesh.of, mesh.carrier, other),
    ):
        rates[rate] = rates[rate] + factor if rate in rates else factor
    return Relation(name_element(mesh), turning=tuple(rates.items()), source=mesh)


def _state_driver(
    mechanism: Mechanism, bases: Mapping[str, Base], driver: Driver, arithmetic: Any
) -> Relation:
    """What a driver imposes."""
    imposed = {"velocity": driver.velocity, "acceleration": driver.acceleration, "source": driver}
    match driver:
        case Rotation():
            return Relation(
                name_element(driver),
                turning=_list_turning_factors(driver.body, driver.of, 1),
                **imposed,
            )
        case Component(point=point, direction=along, of=of):
            left = build_chain(mechanism, bases, driver.body, point)
            right = build_chain(mechanism, bases, of, point)
            return Relation(name_element(driver), left, right, along, frame=of, **imposed)
        case Circulation():
            left = build_chain(mechanism, bases, driver.body, driver.point)
            along = _find_path_direction(mechanism, driver, arithmetic)
            return Relation(name_element(driver), left, (), along, **imposed)
        case _:
            assert_never(driver)


def _find_path_direction(mechanism: Mechanism, driver: Circulation, arithmetic: Any) -> Vector:
    """The unit vector along a circular path, counter-clockwise. Raises MechanismError at its
    centre.
    """
    arm = mechanism.points[driver.point] - mechanism.points[driver.centre]
    if arithmetic.is_zero(arm.squared()):
        what = Message("mechanics.at-centre", point=driver.point)
        raise MechanismError(Fault(name_element(driver), what))
    tangent: Vector = arm.turned() / arithmetic.sqrt(arm.squared())
    return tangent


def name_element(part: Joint | Driver) -> Message:
    """A joint or driver, as error messages name it."""
    match part:
        case Pin(point=point, bodies=bodies):
            return Message("mechanics.pin", point=point, bodies=list_all(bodies))
        case Slide(point=point, body=body, of=of):
            return Message("mechanics.slide", point=point, body=body, of=of)
        case Sleeve(body=body, of=of):
            return Message("mechanics.sleeve", body=body, of=of)
        case Arc(point=point, body=body, circle=Circle(centre=centre), of=of):
            return Message("mechanics.arc", point=point, body=body, centre=centre, of=of)
        case Contact(body=body, of=of):
            return Message("mechanics.contact", body=body, of=of)
        case Roll(body=body, of=of):
            return Message("mechanics.roll", body=body, of=of)
        case Mesh(body=body, of=of):
            return Message("mechanics.mesh", body=body, of=of)
        case Parallel(body=body, of=of):
            return Message("mechanics.parallel", body=body, of=of)
        case Rotation() | Component() | Circulation():
            return _name_driver(part)
        case _:
            assert_never(part)


def _name_driver(driver: Driver) -> Message:
    match driver:
        case Rotation(body=body, of=of):
            if of == GROUND:
                return Message("mechanics.rotation", body=body)
            return Message("mechanics.relative-rotation", body=body, of=of)
        case Component(point=point, body=body):
            return Message("mechanics.component", point=point, body=body)
        case Circulation(point=point, body=body, centre=centre):
            return Message("mechanics.circulation", point=point, body=body, centre=centre)
        case _:
            assert_never(driver)
