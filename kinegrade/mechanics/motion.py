"""The motion: velocity and acceleration of everything, absolute and relative, at the instant.

`solve_motion` is the entry point: it states the relations, follows the plan twice, and gives a
`Motion` that gives the motion of every point and body. Vectors are in the common frame (x right, y
up), counter-clockwise positive.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace

from kinegrade.errors import AtInfinity, MechanismError
from kinegrade.language.message import Fault, Message
from kinegrade.mechanics import plan as plans
from kinegrade.mechanics.bases import Base
from kinegrade.mechanics.configuration import require_assembled
from kinegrade.mechanics.frames import Frames, build_frames
from kinegrade.mechanics.joints import GROUND
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.plan import Plan
from kinegrade.mechanics.rates import Rate, Rates, make_turning
from kinegrade.mechanics.refusal import describe_looseness, explain_refusal, find_unrelated
from kinegrade.mechanics.relations.reading import PLAIN, Reading
from kinegrade.mechanics.relations.terms import Chain, Term, compose_coriolis, map_chain
from kinegrade.mechanics.vector import Vector, add_vectors
from kinegrade.numbers.elimination import Contradiction, Singular
from kinegrade.numbers.number import Arithmetic, Number


@dataclass(frozen=True, eq=False)
class Motion:
    """All rates (rad/s, m/s) and their changes (rad/s^2, m/s^2), and what follows from them.

    Compared by identity, so that results found for a motion can be cached.
    """

    frames: Frames
    plan: Plan
    rates: Rates
    changes: Rates
    reading: Reading = PLAIN

    @property
    def points(self) -> Mapping[str, Vector]:
        """Positions, m."""
        return self.frames.mechanism.points

    def omega(self, body: str, of: str = GROUND) -> Number:
        """Angular velocity of a body, rad/s, counter-clockwise positive; relative to the body
        `of`.
        """
        return self._difference(self.rates, body, of)

    def alpha(self, body: str, of: str = GROUND) -> Number:
        """Angular acceleration of a body, rad/s^2, counter-clockwise positive; relative to the body
        `of`.
        """
        return self._difference(self.changes, body, of)

    def _difference(self, rates: Rates, body: str, of: str) -> Number:
        """How fast a body turns relative to another one."""
        rate = _find_turning_rate(rates, body)
        return rate if of == GROUND else rate - self.reading.carried(_find_turning_rate(rates, of))

    def chain(self, body: str, point: str) -> Chain:
        """The terms that are taken for the motion of `point` as a point of `body`."""
        return self.reading.chain(self.frames.chain(body, point))

    def velocity(self, point: str, body: str) -> Vector:
        """Velocity of the point of `body` that is at `point`, m/s (transport velocity, if another
        passes there).
        """
        chain = self.reading.absolute_chain(self.chain(body, point))
        return self.reading.add_terms(self._list_velocities(chain, whole=True))

    def _list_velocities(self, chain: Chain, *, whole: bool) -> Iterator[Vector]:
        """The terms that are taken for a velocity."""
        taken = self.reading.velocity_chain(chain, whole=whole)
        return (term.velocity(self.rates) for term in taken)

    def acceleration(self, point: str, body: str) -> Vector:
        """Acceleration of the point of `body` that is at `point`, m/s^2."""
        chain = self.reading.absolute_chain(self.chain(body, point))
        return self.reading.add_terms(self._list_accelerations(chain))

    def _list_accelerations(self, chain: Chain) -> Iterator[Vector]:
        """The terms that are taken for an acceleration."""
        return (term.acceleration(self.rates, self.changes, self.reading) for term in chain)

    def relative_velocity(self, point: str, body: str, frame: str) -> Vector:
        """Velocity of `point` of `body` relative to the moving body `frame`: v_r = v_a - v_e."""
        term = self.reading.find_relative(point, frame)
        if term:
            return term.velocity(self.rates)
        absolute, transport = (
            add_vectors(self._list_velocities(self.chain(name, point), whole=False))
            for name in (body, frame)
        )
        return absolute - transport

    def coriolis(self, point: str, body: str, frame: str) -> Vector:
        """Coriolis acceleration 2 omega_e x v_r of `point` of `body` relative to `frame`, m/s^2."""
        relative = self.relative_velocity(point, body, frame)
        omega = self.reading.frame_rate(self.omega(frame), body, self.rates)
        return self.reading.coriolis(point, frame, compose_coriolis(relative, omega))

    def relative_acceleration(self, point: str, body: str, frame: str) -> Vector:
        """Acceleration of `point` of `body` relative to `frame`: a_r = a_a - a_e - a_Cor."""
        term = self.reading.find_relative(point, frame)
        if term:
            return term.relative_acceleration(self.rates, self.changes, self.reading)
        absolute, transport = (
            add_vectors(self._list_accelerations(self.chain(name, point))) for name in (body, frame)
        )
        return absolute - (transport + self.coriolis(point, body, frame))

    def pole(self, body: str, arithmetic: Arithmetic) -> Vector:
        """Velocity pole of a body, m. Raises AtInfinity when the body does not turn."""
        base = self.frames.bases[body].point
        rate = self.omega(body)
        if arithmetic.is_zero(rate):
            raise AtInfinity(Message("mechanics.pole-at-infinity", body=body))
        pole = self.points[base] + self.velocity(base, body).turned() / rate
        return self.reading.pole(body, self.rates, pole)

    def map(self, number: Callable[[Number], Number]) -> Motion:
        """The motion with `number` applied to every number of its points, chains, relations and
        rates: in another arithmetic. Joints and drivers keep their numbers, as the relations
        contain everything that they state.
        """
        frames = _map_frames(self.frames, number)
        if not self.plan.steps:  # a pose, of which no rate is known
            return replace(self, frames=frames)
        rates, changes = (
            {name: number(rate) for name, rate in found.items()}
            for found in (self.rates, self.changes)
        )
        return replace(self, frames=frames, rates=rates, changes=changes)


def find_relative_terms(frames: Frames) -> dict[tuple[str, str], Term]:
    """The terms of relative motions that relations and chains contain, each by its point and the
    body relative to which it moves.
    """
    sides = [side for relation in frames.relations for side in (relation.left, relation.right)]
    chains = (*sides, *(base.chain for base in frames.bases.values()))
    return {
        (term.point, term.frame): term for chain in chains for term in chain if term.frame != GROUND
    }


def _map_frames(frames: Frames, number: Callable[[Number], Number]) -> Frames:
    """The frames with `number` applied to their points, chains and relations."""
    points = {name: point.map(number) for name, point in frames.mechanism.points.items()}
    bases = {
        name: Base(base.point, map_chain(base.chain, number), base.joint)
        for name, base in frames.bases.items()
    }
    relations = tuple(relation.map(number) for relation in frames.relations)
    return Frames(replace(frames.mechanism, points=points), bases, relations, frames.guiding)


class _Undriven(dict[Rate, Number]):
    """The rates of a mechanism without a driver: none is known, and reading one is an error."""

    def __missing__(self, rate: Rate) -> Number:
        what, do = Message("mechanics.undriven"), Message("mechanics.give-input")
        raise MechanismError(Fault("", what, do=do))


def pose_mechanism(mechanism: Mechanism, arithmetic: Arithmetic) -> Motion:
    """A mechanism whose positions alone are wanted. Raises MechanismError when it does not fit
    together.
    """
    if arithmetic.certified:
        require_assembled(mechanism, arithmetic)
    return Motion(build_frames(mechanism, arithmetic), Plan(()), _Undriven(), _Undriven())


def solve_motion(mechanism: Mechanism, arithmetic: Arithmetic, plan: Plan | None = None) -> Motion:
    """The motion of a mechanism; a given `plan` saves the search for one, and is replaced where it
    does not fit.

    Raises MechanismError: the configuration does not fit a joint, a body is loose, joints or
    drivers contradict each other, or the mechanism stands at a dead point.
    """
    if arithmetic.certified:
        require_assembled(mechanism, arithmetic)
    frames = build_frames(mechanism, arithmetic)
    _require_all_related(frames)
    equations = [relation.equations() for relation in frames.relations]
    if plan is not None:
        try:
            return _run_plan(plan, frames, equations, arithmetic)
        except (Singular, Contradiction):
            pass
    try:
        return _run_plan(
            plans.find_plan(frames.relations, equations, arithmetic), frames, equations, arithmetic
        )
    except (Singular, Contradiction):
        sides = [relation.velocity_side() for relation in frames.relations]
        raise explain_refusal(frames, equations, sides, arithmetic) from None


def _run_plan(
    plan: Plan, frames: Frames, equations: plans.Equations, arithmetic: Arithmetic
) -> Motion:
    """Run the plan for velocities, then for accelerations."""
    sides = [relation.velocity_side() for relation in frames.relations]
    rates = plans.run_steps(plan, equations, sides, arithmetic)
    sides = [relation.acceleration_side(rates) for relation in frames.relations]
    try:
        changes = plans.run_steps(plan, equations, sides, arithmetic)
    except Contradiction:
        raise explain_refusal(frames, equations, sides, arithmetic) from None
    return Motion(frames, plan, rates, changes)


def _require_all_related(frames: Frames) -> None:
    """Refuse motions that no joint and no driver determines."""
    if find_unrelated(frames):
        raise MechanismError(describe_looseness(frames, []))


def _find_turning_rate(rates: Rates, body: str) -> Number:
    """The angular rate of a body among `rates`; the ground has none, and for a particle it is an
    error.
    """
    if body == GROUND:
        return 0
    turning = make_turning(body)
    if turning not in rates:
        what = Message("mechanics.no-turning-particle", body=body)
        raise MechanismError(Fault("", what, do=Message("mechanics.ask-for-point")))
    return rates[turning]
