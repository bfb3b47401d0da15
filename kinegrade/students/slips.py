"""Slips: the relations of a mechanism as a student reads them who makes a known mistake.

A slip is a transformation of terms: each number of a `Slips` is the share that remains of
something, 1 if correct and 0 if forgotten. Shares may be arrays, one entry for each way to go
wrong, so that one run of the plan gives the results of many mistakes. `mistaken` runs the plan with
them.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any, assert_never

from kinegrade.mechanics.drivers import Circulation, Component, Rotation
from kinegrade.mechanics.frames import Frames
from kinegrade.mechanics.joints import (
    GROUND,
    Arc,
    Circle,
    Contact,
    Line,
    Mesh,
    Parallel,
    Pin,
    Roll,
    Sleeve,
    Slide,
)
from kinegrade.mechanics.rates import Rate, Rates, make_turning
from kinegrade.mechanics.relations import Chain, Relation, Term
from kinegrade.mechanics.vector import Vector

# (centre carried, centre of the circle it runs about): share of the distance
Arms = Mapping[tuple[str, str], Any]


@dataclass(frozen=True)
class Slips:
    """What remains of a mechanism's terms: 1 is right, 0 forgotten, -1 reversed.

    - coriolis: each Coriolis acceleration.
    - relative_normal: the normal part of the acceleration of a point relative to a base point.
    - path_normal: the normal part on a circular path, about a fixed pin or along an arc.
    - meshing: the sense of a meshing or rolling on a circle: -1 takes inside for outside.
    - carried: the carrier's turning within a relative angular velocity; 0 takes relative for
      absolute.
    - asked_relative: the second body's turning where a relative angular velocity is asked for.
    - arm: the radius of the carried wheel within the arm r1 + r2.
    - pole: 0 takes a fixed pivot for the velocity pole.
    - centre: the centre's velocity within that of other points of a rolling body.
    - relative: the relative velocity within an absolute one; 0 takes the transport velocity for
      it.
    """

    coriolis: Any = 1
    relative_normal: Any = 1
    path_normal: Any = 1
    meshing: Any = 1
    carried: Any = 1
    asked_relative: Any = 1
    arm: Any = 1
    pole: Any = 1
    centre: Any = 1
    relative: Any = 1


@dataclass(frozen=True)
class _MistakenTerm(Term):
    """A term of whose acceleration only a share of the normal and of the Coriolis part is taken."""

    normal_share: Any = 1
    coriolis_share: Any = 1

    def normal(self, rates: Rates) -> Vector:
        """The centripetal part that is taken, m/s^2."""
        taken: Vector = super().normal(rates) * self.normal_share
        return taken

    def coriolis(self, rates: Rates) -> Vector:
        """The Coriolis part that is taken, m/s^2."""
        taken: Vector = super().coriolis(rates) * self.coriolis_share
        return taken


@dataclass(frozen=True)
class _MistakenRelation(Relation):
    """A relation that imposes a relative motion, of whose Coriolis acceleration only a share is
    taken.
    """

    coriolis_share: Any = 1

    def imposed_coriolis(self, rates: Rates) -> Vector:
        """The part of the Coriolis acceleration of the imposed relative motion that is taken,
        m/s^2.
        """
        taken: Vector = super().imposed_coriolis(rates) * self.coriolis_share
        return taken


@dataclass(frozen=True)
class MistakenFrames(Frames):
    """The chains and relations of a student who makes the slips."""

    slips: Slips
    arms: Arms

    def chain(self, body: str, point: str) -> Chain:
        """The terms of a point's motion, with the slips made."""
        return _slip_in_chain(super().chain(body, point), self.slips, self.arms)


def slip_in_frames(frames: Frames, slips: Slips) -> MistakenFrames:
    """The frames with the slips made in every term and every relation."""
    arms = dict(_find_carried_arms(frames, slips))
    relations = tuple(_slip_in_relation(relation, slips, arms) for relation in frames.relations)
    return MistakenFrames(frames.mechanism, frames.bases, relations, slips, arms)


def _slip_in_chain(chain: Chain, slips: Slips, arms: Arms) -> Chain:
    """The terms with the slips made; the first rotation of a chain is about a fixed pin."""
    return tuple(
        _slip_in_term(
            term,
            slips,
            slips.relative_normal if place and term.kind == "rotation" else slips.path_normal,
            arms,
        )
        for place, term in enumerate(chain)
    )


def _slip_in_term(term: Term, slips: Slips, normal_share: Any, arms: Arms) -> Term:
    """A term with the slips made."""
    share = arms.get((term.point, term.base))
    vector = term.vector if share is None else term.vector * share
    return _MistakenTerm(
        term.kind,
        term.rate,
        vector,
        term.point,
        term.base,
        term.frame,
        normal_share,
        slips.coriolis,
    )


def _find_carried_arms(frames: Frames, slips: Slips) -> Iterator[tuple[tuple[str, str], Any]]:
    """For each wheel that runs on a circle the share taken of the distance of the two centres: of
    r1 in r1 + r2.
    """
    for joint in frames.mechanism.joints:
        if isinstance(joint, (Roll, Mesh)) and isinstance(joint.on, Circle):
            radius = -joint.circle.radius if joint.inside else joint.circle.radius
            share = (joint.on.radius + slips.arm * radius) / (joint.on.radius + radius)
            yield (joint.circle.centre, joint.on.centre), share


def _slip_in_relation(relation: Relation, slips: Slips, arms: Arms) -> Relation:
    """A relation with the slips made in its chains and in its turning rates."""
    return _MistakenRelation(
        relation.origin,
        _slip_in_chain(relation.left, slips, arms),
        _slip_in_chain(relation.right, slips, arms),
        relation.along,
        _slip_in_turning(relation, slips),
        relation.velocity,
        relation.acceleration,
        relation.frame,
        relation.source,
        slips.coriolis,
    )


def _slip_in_turning(relation: Relation, slips: Slips) -> tuple[tuple[Rate, Any], ...]:
    """The factors of the turning rates with the slips made."""
    match relation.source:
        case Roll(on=on):
            match on:
                case Line():
                    return _slip_in_carrying(relation, relation.source.of, slips)
                case Circle():
                    return tuple(_slip_in_rolling(relation, relation.source, slips))
                case _:
                    assert_never(on)
        case Rotation(of=of):
            return _slip_in_carrying(relation, of, slips)
        case Mesh():
            return _slip_in_meshing(relation.source, slips)
        case Pin() | Slide() | Sleeve() | Arc() | Contact() | Parallel():
            return relation.turning
        case Component() | Circulation() | None:
            return relation.turning
        case _:
            assert_never(relation.source)


def _slip_in_carrying(relation: Relation, of: str, slips: Slips) -> tuple[tuple[Rate, Any], ...]:
    """The factors of the turning rates where only part of the rotation of the body `of` is taken
    into account.
    """
    if of == GROUND:
        return relation.turning
    return tuple(
        (rate, factor * slips.carried if rate == make_turning(of) else factor)
        for rate, factor in relation.turning
    )


def _slip_in_rolling(relation: Relation, roll: Roll, slips: Slips) -> Iterator[tuple[Rate, Any]]:
    """The centre's rate and the slip at the contact: -r/(R + r), with -r inside; a forgotten r
    leaves -r/R.
    """
    sense = -slips.meshing if roll.inside else slips.meshing
    radius = roll.circle.radius * sense
    slip = -radius / (roll.on.radius + slips.arm * slips.carried * radius)  # type: ignore[union-attr]
    for rate, factor in relation.turning:
        yield rate, {make_turning(roll.body): slip, make_turning(roll.of): -slip}.get(rate, factor)


def _slip_in_meshing(mesh: Mesh, slips: Slips) -> tuple[tuple[Rate, Any], ...]:
    """r1 (omega_1 - c omega_c) + r2 (omega_2 - omega_c), c the share of the carrier's rotation that
    is taken into account.
    """
    sense = -slips.meshing if mesh.inside else slips.meshing
    radius, other = mesh.circle.radius, mesh.on.radius * sense
    thought = (slips.carried, 1) if mesh.body != GROUND else (1, slips.carried)
    factors = [
        (mesh.body, radius),
        (mesh.of, other),
        (mesh.carrier, -radius * thought[0] - other * thought[1]),
    ]
    rates: dict[Rate, Any] = {}
    for body, factor in factors:
        if body != GROUND:
            rates[make_turning(body)] = (
                rates[make_turning(body)] + factor if make_turning(body) in rates else factor
            )
    return tuple(rates.items())


def find_velocity_chain(
    chain: Chain, slips: Slips, rolling: Mapping[Rate, str], whole: bool = False
) -> Chain:
    """The terms that are taken for a velocity: of a rolling body (its centre by its rate) without
    the velocity of the centre.

    `whole` leaves out relative motions as well: the velocity of the coincident point of the moving
    body.
    """
    last = chain[-1] if chain else None
    about_centre = (
        last is not None
        and len(chain) > 1
        and last.kind == "rotation"
        and rolling.get(last.rate) == last.base
    )
    terms = []
    for term in chain:
        share = slips.centre if about_centre and term is not last else 1
        if whole and term.frame != GROUND:
            share = share * slips.relative
        terms.append(
            term
            if isinstance(share, int) and share == 1
            else replace(term, vector=term.vector * share)
        )
    return tuple(terms)


def find_rolling_centres(frames: Frames) -> dict[Rate, str]:
    """For each rolling body the point that is its centre, by the body's turning rate."""
    return {
        make_turning(joint.body): joint.circle.centre
        for joint in frames.mechanism.joints
        if isinstance(joint, Roll)
    }
