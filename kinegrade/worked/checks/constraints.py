"""Checks by differentiating where points are: a coordinate, the direction of a slot about the axis
of its body, the length of a rod. The rotations count by the coordinates of their points, so that no
angle, no triangle of vectors and no projection is used again.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import assert_never

from kinegrade.language.message import Message
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.relations.terms import Term
from kinegrade.mechanics.vector import AxisName, Vector
from kinegrade.worked.checks.amounts import (
    Amount,
    Multiplier,
    point_along,
)
from kinegrade.worked.checks.arms import find_path_normal, point_from_base
from kinegrade.worked.checks.check import Check
from kinegrade.worked.checks.forms import Told
from kinegrade.worked.checks.multiplied import Multiplied, TermSide
from kinegrade.worked.checks.positions.conditions import (
    Condition,
    differentiate_coordinate,
    differentiate_direction,
    differentiate_distance,
    differentiate_length,
)
from kinegrade.worked.checks.relative_shares import find_speed
from kinegrade.worked.checks.shares import Shares
from kinegrade.worked.formulas.atoms import AXES, TWO
from kinegrade.worked.formulas.measures import double, find_sign, is_zero, length
from kinegrade.worked.formulas.numbers import measure
from kinegrade.worked.formulas.symbols import join_letters
from kinegrade.worked.vectors.arms import name_length
from kinegrade.worked.vectors.stage import Stage
from kinegrade.worked.vectors.vectors import UNITS


def list_constraint_checks(stage: Stage, told: Told) -> Iterator[Check]:
    """The checks of the equations of a step, the last one first, without what is told."""
    for equation in reversed(stage.equations):
        one = _Differentiated(equation, Shares(equation, stage.case), stage.case, told)
        yield from one.list_directions()
        yield from one.list_coordinates()
        yield from one.list_offsets()
        yield from one.list_lengths()


@dataclass(frozen=True)
class _Differentiated(Multiplied):
    """Two chains to one point, whose place is differentiated."""

    def list_coordinates(self) -> Iterator[Check]:
        """A coordinate of the point at the end of both chains."""
        checks = [check for axis in AXES for check in self._check_coordinate(axis)]
        yield from sorted(checks, key=lambda check: check.is_one_sided)

    def _check_coordinate(self, axis: AxisName) -> Iterator[Check]:
        left, right = self.chains
        if left and right:
            place = differentiate_coordinate(axis, self._ways, self.equation.level, self.case)
            sides = TermSide(left), TermSide(right)
            yield from self._differentiate(place, *sides, point_along(axis))

    @property
    def _ways(self) -> tuple[tuple[Term, ...], tuple[Term, ...]]:
        """The chains, of one that has been found as a whole its end alone."""
        left, right = (one[-1:] if self.find_components(one) else one for one in self.chains)
        return left, right

    def _differentiate(
        self, condition: Condition, one: TermSide, other: TermSide, by: Multiplier
    ) -> Iterator[Check]:
        """The check of two sides, with the formulas of what is differentiated."""
        for check in self.compare(condition.way, one, other, by):
            yield replace(check, conditions=condition.formulas)

    def list_directions(self) -> Iterator[Check]:
        """The direction of a line through the axis of a body, along which a point slides; where it
        is that of an axis, a coordinate says the same.
        """
        for before, other in (self.chains, self.chains[::-1]):
            for turn, slide in pairwise(before):
                if other and 0 in map(double, slide.vector):
                    continue
                if not self.tells(turn.vector.turned()):
                    continue
                own = self._state_turning(turn, slide) if _turns_slot(turn, slide) else None
                if own is not None:
                    by = point_from_base(turn, self.case).turned()
                    rest = tuple(one for one in before if one not in (turn, slide))
                    moment = self.shares.measure((turn, slide), by)
                    sides = TermSide((), tuple(own), moment), TermSide(other, without=rest)
                    yield from self._differentiate(self._name_across(turn), *sides, by)

    def list_offsets(self) -> Iterator[Check]:
        """The distance of the axis of a body from a line of it along which a point slides."""
        for before, other in (self.chains, self.chains[::-1]):
            for turn, slide in pairwise(before):
                if not _is_own(turn, slide) or not double(turn.vector.cross(slide.vector)):
                    continue
                by, ends = find_path_normal(turn, slide, self.case)
                if by is not None:
                    level = self.equation.level
                    fixed = differentiate_distance(by, turn, slide, level, self.case)
                    sides = TermSide(other), TermSide(before)
                    for check in self._differentiate(fixed, *sides, by):
                        yield check.with_length(ends, self.case) if ends else check

    def _state_turning(self, turn: Term, slide: Term) -> list[Amount] | None:
        """OA^2 omega, or OA^2 alpha + 2 OA v_r omega."""
        level, case = self.equation.level, self.case
        rate, omega = case.rates(level)[turn.rate], case.motion.rates[turn.rate]
        if case.findings.spares(turn.rate, level):
            return None
        arm = name_length(turn.base, turn.point, case)
        far = measure(length(turn.vector, case.arithmetic), "m")
        found: list[Amount] = []
        if double(rate):
            letters = case.naming.turning(turn.rate.body, level)
            numbers = measure(rate, UNITS[level, True])
            found.append(Amount(arm, far).squared().times(Amount(letters, numbers)))
        away = slide.velocity(case.motion.rates)
        if level == "acceleration" and double(omega) and not is_zero(away):
            speed, positive = find_speed(slide, case)
            turning = self._name_turning(turn.rate.body)
            twice = Amount(TWO * arm, TWO.dot(far))
            sense = find_sign(positive.dot(turn.vector))
            found.append(twice.times(speed).times(turning).signed(sense))
        return found

    def list_lengths(self) -> Iterator[Check]:
        """The distance of two points of a body, or of a point from the centre of the circle on
        which it moves in a body, of which only velocities have to be known.
        """
        for before, other in (self.chains, self.chains[::-1]):
            if not before or not _keeps_distance(before[-1]) or not self.tells(before[-1].vector):
                continue
            *rest, own = before
            by, shares = point_from_base(own, self.case), self._list_normal(own)
            held = own.remainder(self.case.motion.rates) if shares else Vector(0, 0)
            value = double(by.vector.dot(held))
            sides = TermSide(other), TermSide(tuple(rest), tuple(shares), value)
            yield from self._differentiate(self._name_distance(own), *sides, by)

    def _name_distance(self, own: Term) -> Condition:
        """What is differentiated; the centre of a circle in a moving frame moves with the frame, so
        the motions of the point itself are composed.
        """
        match own.kind:
            case "arc":
                point, centre = map(self.case.naming.point, (own.point, own.base))
                kind = f"solution.composed-arc-{self.equation.level}"
                return Condition(Message(kind, point=point, centre=centre))
            case "rotation" | "sliding":
                far = name_length(own.base, own.point, self.case)
                arm = point_from_base(own, self.case)
                return differentiate_length(arm, far, self.equation.level, self.case)
            case _:
                assert_never(own.kind)

    def _list_normal(self, own: Term) -> list[Amount]:
        """What velocities leave of accelerations along a distance that does not change."""
        match self.equation.level:
            case "velocity":
                return []
            case "acceleration":
                moves = double(self.case.motion.rates[own.rate])
                return list(self._list_centripetal(own)) if moves else []
            case _:
                assert_never(self.equation.level)

    def _list_centripetal(self, own: Term) -> Iterator[Amount]:
        """-omega^2 AB^2, or -v_r^2 + 2 AB v_r omega_e of a relative motion."""
        case = self.case
        far = measure(length(own.vector, case.arithmetic), "m")
        arm = Amount(name_length(own.base, own.point, case), far)
        match own.kind:
            case "rotation":
                yield self._name_turning(own.rate.body).squared().times(arm.squared()).signed(-1)
            case "arc":
                speed, positive = find_speed(own, case)
                yield speed.squared().signed(-1)
                if double(case.motion.omega(own.frame)):
                    twice = Amount(TWO * arm.letters, TWO.dot(arm.numbers)).times(speed)
                    sense = find_sign(positive.turned().dot(own.vector))
                    yield twice.times(self._name_turning(own.frame)).signed(sense)
            case "sliding":
                return
            case _:
                assert_never(own.kind)

    def _name_turning(self, body: str) -> Amount:
        """The angular velocity of a body."""
        omega = measure(self.case.motion.omega(body), "rad/s")
        return Amount(self.case.naming.omega(body), omega)

    def _name_across(self, turn: Term) -> Condition:
        """What stands there: the angle of an arm; where that lies along an axis, and of
        accelerations, the motion of a point across its arm, times the arm.
        """
        arm, level = point_from_base(turn, self.case), self.equation.level
        if level == "velocity" and len(arm.pair) == len(AXES):
            return differentiate_direction(arm, turn, level, self.case)
        first, second = self._find_ends(turn)
        point = self.case.naming.point(turn.point)
        kind = f"solution.derivative-direction-{level}"
        return Condition(Message(kind, point=point, first=first, second=second))

    def _find_ends(self, term: Term) -> tuple[str, str]:
        """The letters of the line of a rotation, in the order in which its length has them."""
        ends = (term.base, term.point)
        letters = join_letters(map(self.case.naming.letter, reversed(ends)))
        named = name_length(*ends, self.case) == letters
        first, second = map(self.case.naming.point, reversed(ends) if named else ends)
        return first, second


def _turns_slot(turn: Term, slide: Term) -> bool:
    """Whether a point slides along a line through the axis of the body that turns."""
    return _is_own(turn, slide) and not double(turn.vector.cross(slide.vector))


def _is_own(turn: Term, slide: Term) -> bool:
    """Whether a point slides along a line of the body that turns."""
    return turn.kind == "rotation" and slide.kind == "sliding" and slide.frame == turn.rate.body


def _keeps_distance(term: Term) -> bool:
    """Whether a point keeps its distance from another point of its body, or from the centre of a
    circle that moves.
    """
    return term.kind == "rotation" or (term.kind == "arc" and term.frame != GROUND)
