"""Checks by differentiating where points are: a coordinate, the direction of a slot about the axis
of its body, the length of a rod. The rotations count by the coordinates of their points, so that no
angle, no triangle of vectors and no projection is used again.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise
from typing import Any, assert_never

from kinegrade.language.message import Message
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.relations import Term
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import VectorEquation
from kinegrade.worked.case import Case
from kinegrade.worked.checks.check import Check, Side, compare
from kinegrade.worked.checks.shares import (
    Amount,
    Multiplier,
    Shares,
    add_letters,
    add_numbers,
    point_along,
    point_from_base,
)
from kinegrade.worked.formulas.atoms import AXES, TWO, AxisName
from kinegrade.worked.formulas.measures import double, is_zero, length, size
from kinegrade.worked.formulas.numbers import measure
from kinegrade.worked.formulas.symbols import join_letters
from kinegrade.worked.vectors.arms import name_length
from kinegrade.worked.vectors.known_vectors import find_positive_sense
from kinegrade.worked.vectors.relatives import find_relative, index_relative
from kinegrade.worked.vectors.stage import Stage
from kinegrade.worked.vectors.vectors import UNITS, name_by_role


def list_constraint_checks(stage: Stage) -> Iterator[Check]:
    """The checks of the equations of a step, the last one first."""
    for equation in reversed(stage.equations):
        one = _Differentiated(equation, Shares(equation, stage.case), stage.case)
        yield from one.list_directions()
        yield from one.list_coordinates()
        yield from one.list_lengths()


@dataclass(frozen=True)
class _Differentiated:
    """The two chains of a vector equation, whose ends are one point."""

    equation: VectorEquation
    shares: Shares
    case: Case

    @property
    def _chains(self) -> tuple[tuple[Term, ...], tuple[Term, ...]]:
        relation = self.equation.relation
        return tuple(relation.left), tuple(relation.right)

    def list_coordinates(self) -> Iterator[Check]:
        """A coordinate of the point at the end of both chains."""
        checks = [check for axis in AXES for check in self._check_coordinate(axis)]
        yield from sorted(checks, key=lambda check: check.is_one_sided)

    def _check_coordinate(self, axis: AxisName) -> Iterator[Check]:
        left, right = self._chains
        if left and right:
            point = self.case.naming.point(left[-1].point)
            kind = f"solution.coordinate-derivative-{self.equation.level}"
            way = Message(kind, axis=axis, point=point)
            yield from self._compare(way, _Side(left), _Side(right), point_along(axis))

    def list_directions(self) -> Iterator[Check]:
        """The direction of a line through the axis of a body, along which a point slides."""
        for before, other in (self._chains, self._chains[::-1]):
            for turn, slide in pairwise(before):
                own = self._state_turning(turn, slide) if _turns_slot(turn, slide) else None
                if own is not None:
                    by = point_from_base(turn, self.case).turned()
                    rest = tuple(one for one in before if one not in (turn, slide))
                    moment = self.shares.measure((turn, slide), by)
                    sides = _Side((), tuple(own), moment), _Side(other, without=rest)
                    yield from self._compare(self._name("direction", turn), *sides, by)

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
            speed, positive = self._find_speed(slide)
            turning = self._name_turning(turn.rate.body)
            twice = Amount(TWO * arm, TWO.dot(far))
            sense = _find_sign(positive.dot(turn.vector))
            found.append(twice.times(speed).times(turning).signed(sense))
        return found

    def _find_speed(self, term: Term) -> tuple[Amount, Vector]:
        """A relative velocity as it has been stated, and its positive sense."""
        positive = find_positive_sense(term, self.case, "velocity")
        away = term.velocity(self.case.motion.rates)
        number = index_relative(find_relative(term), self.case)
        stated = length(away, self.case.arithmetic) * _find_sign(away.dot(positive))
        return Amount(name_by_role("r", "velocity", number), measure(stated, "m/s")), positive

    def list_lengths(self) -> Iterator[Check]:
        """The distance of two points of a body, or of a point from the centre of the circle on
        which it moves in a body, of which only velocities have to be known.
        """
        for before, other in (self._chains, self._chains[::-1]):
            if not before or not _keeps_distance(before[-1]):
                continue
            *rest, own = before
            by, shares = point_from_base(own, self.case), self._list_normal(own)
            held = own.remainder(self.case.motion.rates) if shares else Vector(0, 0)
            value = double(by.vector.dot(held))
            sides = _Side(other), _Side(tuple(rest), tuple(shares), value)
            yield from self._compare(self._name("length", own), *sides, by)

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
                speed, positive = self._find_speed(own)
                yield speed.squared().signed(-1)
                if double(case.motion.omega(own.frame)):
                    twice = Amount(TWO * arm.letters, TWO.dot(arm.numbers)).times(speed)
                    sense = _find_sign(positive.turned().dot(own.vector))
                    yield twice.times(self._name_turning(own.frame)).signed(sense)
            case "sliding":
                return
            case _:
                assert_never(own.kind)

    def _name_turning(self, body: str) -> Amount:
        """The angular velocity of a body."""
        omega = measure(self.case.motion.omega(body), "rad/s")
        return Amount(self.case.naming.omega(body), omega)

    def _name(self, kind: str, term: Term) -> Message:
        """The quantity that is differentiated, by the line of a rotation."""
        ends = (term.base, term.point)
        letters = join_letters(map(self.case.naming.letter, reversed(ends)))
        named = name_length(*ends, self.case) == letters
        first, second = map(self.case.naming.point, reversed(ends) if named else ends)
        return Message(
            f"solution.derivative-{kind}-{self.equation.level}", first=first, second=second
        )

    def _compare(self, way: Message, one: _Side, other: _Side, by: Multiplier) -> Iterator[Check]:
        """The check of two sides, where every share of both is on the page and a rotation counts
        on one of them.
        """
        left, right = (self._state(side, by) for side in (one, other))
        if left is None or right is None or not (left.letters or right.letters):
            return
        terms = (*one.terms, *other.terms, *other.without)
        largest = size(by.vector) * max(size(self.shares.find_vector(term)) for term in terms)
        yield compare(way, left, right, by.name_unit(self.equation.level), largest)

    def _state(self, side: _Side, by: Multiplier) -> Side | None:
        added, taken = (self.shares.list_of(terms, by) for terms in (side.terms, side.without))
        if added is None or taken is None:
            return None
        every = (*side.own, *added, *(one.signed(-1) for one in taken))
        value = self.shares.measure(side.terms, by) - self.shares.measure(side.without, by)
        letters = add_letters(every) if every else None
        return Side(add_numbers(every), value + side.value, letters)


@dataclass(frozen=True)
class _Side:
    """The terms of a side, what stands there besides, with its value, and terms taken from it."""

    terms: tuple[Term, ...]
    own: tuple[Amount, ...] = ()
    value: float = 0.0
    without: tuple[Term, ...] = ()


def _turns_slot(turn: Term, slide: Term) -> bool:
    """Whether a point slides along a line through the axis of the body that turns."""
    body = turn.kind == "rotation" and slide.kind == "sliding" and slide.frame == turn.rate.body
    return body and not double(turn.vector.cross(slide.vector))


def _keeps_distance(term: Term) -> bool:
    """Whether a point keeps its distance from another point of its body, or from the centre of a
    circle that moves.
    """
    return term.kind == "rotation" or (term.kind == "arc" and term.frame != GROUND)


def _find_sign(number: Any) -> int:
    return 1 if double(number) > 0 else -1
