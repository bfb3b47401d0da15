"""The relations of a mechanism as a student reads them who makes slips.

The terms are taken with the shares of `slips`, each at the places that `slip_places` finds;
`mistaken` runs the plan with them.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from kinegrade.mechanics.frames import Frames
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.laws import Turning
from kinegrade.mechanics.plan import Plan
from kinegrade.mechanics.rates import Rate, Rates, make_turning
from kinegrade.mechanics.relations.reading import Reading
from kinegrade.mechanics.relations.relation import Relation
from kinegrade.mechanics.relations.terms import Chain, Term
from kinegrade.mechanics.vector import Vector, add_vectors
from kinegrade.numbers.number import Arithmetic, Number
from kinegrade.students.mistaking.rods import MisjudgedRod
from kinegrade.students.mistaking.scalar_sum import ScalarSum
from kinegrade.students.mistaking.slip_places import SlipPlaces, find_slip_places, make_sign
from kinegrade.students.mistaking.slips import Share, Slips, is_right

# (centre carried, centre of the circle it runs about): share of the distance
Arms = Mapping[tuple[str, str], Share]


@dataclass(frozen=True)
class MistakenReading(Reading):
    """The terms as a student takes them who makes the slips at their places.

    `arms` are the shares of the arms that carry wheels.
    """

    slips: Slips
    arms: Arms
    places: SlipPlaces
    arithmetic: Arithmetic

    def chain(self, chain: Chain) -> Chain:
        """The terms with the shares of their arms."""
        return tuple(
            term.put(term.vector * self.arms[term.point, term.base])
            if (term.point, term.base) in self.arms
            else term
            for term in chain
        )

    def absolute_chain(self, chain: Chain) -> Chain:
        """The terms with the share of the transport motion, the rest being the one in the other of
        two moving bodies.
        """
        other = self.places.transports.get(make_sign(chain[-1])) if chain else None
        share = self.slips.own_transport
        if other is None or is_right(share):
            return chain
        return (*_mix(chain[:-1], other, share), chain[-1])

    def velocity_chain(self, chain: Chain, *, whole: bool) -> Chain:
        """The terms of which a velocity is taken to consist: of a point of a rolling body without
        the velocity of the centre; of a `whole` one without relative motions: the velocity of the
        coincident point of the moving body.
        """
        last = chain[-1] if chain else None
        about_centre = last is not None and len(chain) > 1 and self._turns_about_centre(last)
        terms = []
        for term in chain:
            share = self.slips.centre if about_centre and term is not last else 1
            if whole and term.frame != GROUND:
                share = share * self.slips.relative
            terms.append(term if is_right(share) else term.put(term.vector * share))
        return self._meet(tuple(terms)) if whole else tuple(terms)

    def _meet(self, chain: Chain) -> Chain:
        """The terms of which a velocity consists: of the end of a rod whose rates are not found as
        they should be, the motion of what it is joined to.
        """
        share = self.slips.share_rods()
        met = None if is_right(share) else self._find_met(chain)
        if met is None:
            return chain
        return _mix(chain, met, share)

    def _find_met(self, chain: Chain) -> Chain | None:
        """The chain of what the end of a rod is joined to, to which a chain leads."""
        last = make_sign(chain[-1]) if chain else None
        return next((rod.met for rod in self.places.rods if make_sign(rod.rotation) == last), None)

    def pole(self, body: str, rates: Rates, pole: Vector) -> Vector:
        """The point that is taken for the pole of a rod."""
        for rod in self.places.rods:
            if rod.rotation.rate == make_turning(body):
                misjudged = MisjudgedRod(rod, rates, self.arithmetic)
                if not is_right(self.slips.far_end):
                    pole = self._choose(self.slips.far_end, rod.far, pole)
                if not is_right(self.slips.far_pivot) and rod.pivot is not None:
                    pole = self._choose(self.slips.far_pivot, rod.pivot, pole)
                if not is_right(self.slips.across):
                    pole = self._choose(self.slips.across, misjudged.meeting, pole)
        return pole

    def _choose(self, share: Share, mistaken: Vector, right: Vector) -> Vector:
        """The mistaken point where nothing of the right one remains."""
        return Vector(
            *(
                self.arithmetic.choose(share == 0, wrong, true)
                for wrong, true in zip(mistaken, right, strict=True)
            )
        )

    def _turns_about_centre(self, term: Term) -> bool:
        """Whether a term is the rotation of a rolling body about its centre."""
        return term.kind == "rotation" and self.places.centres.get(term.rate) == term.base

    def turning(self, relation: Relation) -> Turning:
        """The rates that turn, with the slips made in their factors."""
        if relation.source is None:
            return relation.turning
        return relation.source.list_factors(self.slips.select_shares())

    def write_for_changes(self, relation: Relation, unknowns: Sequence[Rate]) -> Relation:
        """A relation as accelerations are added up in it, to find the changes of these rates: with
        the share of what those of known rates add. One term that equals another is no sum.
        """
        if is_right(self.slips.tangential) or len(relation.left) == len(relation.right) == 1:
            return relation
        left, right = (
            tuple(
                term
                if term.kind == "sliding" or term.rate in unknowns
                else term.put(term.vector * self.slips.tangential)
                for term in side
            )
            for side in (relation.left, relation.right)
        )
        return replace(relation, left=left, right=right)

    def square(self, rate: Number) -> Number:
        """The share of the square of an angular velocity, the rest being the angular velocity."""
        share = self.slips.square
        return rate * rate if is_right(share) else rate * rate * share + abs(rate) * (1 - share)

    def tangential(self, rate: Rate, point: str, base: str, tangential: Vector) -> Vector:
        """The share of a tangential acceleration, unless the angular acceleration is found by
        it.
        """
        if (
            is_right(self.slips.tangential)
            or not base
            or (rate, point, base) in self.places.finding
        ):
            return tangential
        return tangential * self.slips.tangential

    def frame_rate(self, omega: Number, body: str, rates: Rates) -> Number:
        """The share of a moving frame's angular velocity, the rest being that of the body that
        moves in it, if it turns.
        """
        share, own = self.slips.frame_rate, make_turning(body)
        if is_right(share) or own not in rates or own in self.places.still:
            return omega
        return omega * share + rates[own] * (1 - share)

    def normal(self, rate: Rate, point: str, base: str, normal: Vector) -> Vector:
        """The share of a normal acceleration, on a path or relative to a base point."""
        on_path = rate.kind != "turning" or rate in self.places.pinned
        return normal * (self.slips.path_normal if on_path else self.slips.relative_normal)

    def coriolis(self, point: str, frame: str, coriolis: Vector) -> Vector:
        """The share of a Coriolis acceleration."""
        return coriolis * self.slips.coriolis

    def add_terms(self, terms: Iterable[Vector]) -> Vector:
        """The sum of vectors; its magnitude may be taken for the sum of theirs."""
        if is_right(self.slips.vector_sum):
            return add_vectors(terms)
        return ScalarSum.make(tuple(terms), self.slips.vector_sum)

    def carried(self, rate: Number) -> Number:
        """The share of the rate of a body relative to which another one's is asked for."""
        return rate * self.slips.asked_relative


def read_with_slips(
    frames: Frames, slips: Slips, plan: Plan, arithmetic: Arithmetic
) -> MistakenReading:
    """The reading of a mechanism's terms in which the slips are made."""
    arms = dict(_find_carried_arms(frames, slips))
    return MistakenReading(slips, arms, find_slip_places(frames, plan), arithmetic)


def _find_carried_arms(frames: Frames, slips: Slips) -> Iterator[tuple[tuple[str, str], Share]]:
    """For each wheel that runs on a circle the share taken of the distance of the two centres."""
    for relation in frames.relations:
        if relation.source is not None:
            for point, base, share in relation.source.list_arms(slips.select_shares()):
                yield (point, base), share


def _mix(chain: Chain, other: Chain, share: Share) -> Chain:
    """What is taken of two chains: the share of the first, the rest of the other one."""
    return (
        *(term.put(term.vector * share) for term in chain),
        *(term.put(term.vector * (1 - share)) for term in other),
    )
