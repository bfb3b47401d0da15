"""Checks of accelerations by differentiating twice what positions fulfil: the direction of a slot
about the axis of its body, the distance of two points, that of an axis from a line. What velocities
add goes by those of the points themselves, so that no relative velocity and no Coriolis
acceleration is used again.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import chain, pairwise

from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.relations.terms import Term
from kinegrade.worked.checks.amounts import (
    UNIT,
    Amount,
    add_letters,
    add_numbers,
    gather,
    point_along,
)
from kinegrade.worked.checks.arms import find_path_normal, point_from_base
from kinegrade.worked.checks.check import Check
from kinegrade.worked.checks.multiplied import TermSide
from kinegrade.worked.checks.positions.conditions import (
    differentiate_direction,
    differentiate_distance,
    differentiate_length,
)
from kinegrade.worked.checks.twice import Ends, Twice
from kinegrade.worked.formulas.atoms import AXES, TWO
from kinegrade.worked.formulas.measures import double
from kinegrade.worked.formulas.numbers import measure
from kinegrade.worked.vectors.stage import Stage


def list_second_derivatives(stages: Iterable[Stage]) -> Iterator[Check]:
    """The checks of the equations of steps, the last ones first: of points that slide, else of
    lengths, which take the coordinates of more points.
    """
    found = [
        _Constraints(equation, stage.case)
        for stage in stages
        for equation in reversed(stage.equations)
    ]
    slides = chain.from_iterable((*one.list_directions(), *one.list_offsets()) for one in found)
    telling = [check for check in slides if check.is_telling]
    yield from telling or chain.from_iterable(one.list_lengths() for one in found)


@dataclass(frozen=True)
class _Constraints(Twice):
    """What the place of the point at the end of both chains fulfils."""

    def _list_slides(self) -> Iterator[tuple[Term, Term, Ends]]:
        """The points that slide along lines of bodies that turn, seen from the bodies' axes."""
        for before, other in (self.chains, self.chains[::-1]):
            for turn, slide in pairwise(before):
                rest = tuple(one for one in before if one not in (turn, slide))
                moves = other or rest
                if moves and _is_own(turn, slide) and self._is_known(turn):
                    yield turn, slide, Ends(other, rest)

    def _is_known(self, turn: Term) -> bool:
        """Whether a body turns, and its angular acceleration is on the page."""
        spared = self.case.findings.spares(turn.rate, "acceleration")
        return not spared and bool(double(self.case.motion.rates[turn.rate]))

    def list_directions(self) -> Iterator[Check]:
        """The direction of a line through the axis of a body, along which a point slides: phi =
        arctan(y/x), so r^2 alpha + 2 omega r.v = r x a.
        """
        for turn, slide, ends in self._list_slides():
            arm = point_from_base(turn, self.case)
            moved = self.list_velocities(ends, arm)
            if double(turn.vector.cross(slide.vector)) or len(arm.pair) < len(AXES) or not moved:
                continue
            square = (arm.length or UNIT).squared()
            own = (*self.list_turned(turn, (square,)), *self.double_omega(turn, moved))
            by = arm.turned()
            value = self.shares.measure((turn, slide), by)
            angle = differentiate_direction(arm, turn, "acceleration", self.case)
            yield from self.compare(angle, ends, TermSide((), own, value), by)

    def list_offsets(self) -> Iterator[Check]:
        """The distance of the axis of a body from a line of it along which a point slides: r.n is
        constant, so (r.e) alpha + (r.n) omega^2 + 2 omega e.v = n.a, with e along the line.
        """
        for turn, slide, ends in self._list_slides():
            by, line = find_path_normal(turn, slide, self.case)
            if by is None or not double(turn.vector.cross(slide.vector)):
                continue
            along, arm = by.turned().turned().turned(), point_from_base(turn, self.case)
            moved = self.list_velocities(ends, along)
            if not moved:
                continue
            omega = self.case.motion.rates[turn.rate]
            square = Amount(self.case.naming.omega(turn.rate.body), measure(omega, "rad/s"))
            own = (
                *self.list_turned(turn, tuple(along.dot(arm.pair))),
                *gather(square.squared(), tuple(by.dot(arm.pair))),
                *self.double_omega(turn, moved),
            )
            value = self.shares.measure((turn, slide), by)
            turned = TermSide((), own, value)
            fixed = differentiate_distance(by, turn, slide, "acceleration", self.case)
            for check in self.compare(fixed, ends, turned, by):
                yield check.with_length(line, self.case) if line else check

    def list_lengths(self) -> Iterator[Check]:
        """The distance of two points: r.a + v^2 = 0, both of one point from the other."""
        for before, other in (self.chains, self.chains[::-1]):
            if not before or not other:
                continue
            own = before[-1]
            match own.kind:
                case "rotation":
                    yield from self._check_length(own, Ends(other, before[:-1]))
                case "arc":
                    if own.frame != GROUND:
                        centre = self.case.motion.frames.chain(own.frame, own.base)
                        yield from self._check_length(own, Ends(other, tuple(centre)))
                case "sliding":
                    continue

    def _check_length(self, own: Term, ends: Ends) -> Iterator[Check]:
        arm = point_from_base(own, self.case)
        shares = [self.list_velocities(ends, point_along(axis)) for axis in AXES]
        if arm.length is None or not any(shares) or None in shares:
            return
        speeds = tuple(_square(one) for one in shares if one)
        vector = self.find_velocity(ends)
        fixed = differentiate_length(arm, arm.length.letters, "acceleration", self.case)
        turned = TermSide((), speeds, -double(vector.squared()))
        yield from self.compare(fixed, ends, turned, arm)


def _square(shares: list[Amount]) -> Amount:
    """Less the square of their sum, of one alone without its sign."""
    if len(shares) == 1:
        return shares[0].squared().signed(-1)
    return Amount(add_letters(shares) ** TWO, add_numbers(shares) ** TWO).signed(-1)


def _is_own(turn: Term, slide: Term) -> bool:
    """Whether a point slides along a line of the body that turns."""
    return turn.kind == "rotation" and slide.kind == "sliding" and slide.frame == turn.rate.body
