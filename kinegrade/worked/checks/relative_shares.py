"""What the motion of a point relative to a frame that turns amounts to when it is multiplied by a
vector: its speed and its tangential acceleration along its path, the normal one on a circle, and
the Coriolis acceleration.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import assert_never

from kinegrade.mechanics.relations.terms import Term
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Part, VectorEquation
from kinegrade.worked.case import Case
from kinegrade.worked.checks.amounts import UNIT, Amount, Multiplier, gather
from kinegrade.worked.checks.arms import point_from, point_from_base
from kinegrade.worked.formulas.atoms import TWO
from kinegrade.worked.formulas.measures import bearing, double, find_sign, length
from kinegrade.worked.formulas.numbers import measure
from kinegrade.worked.vectors.known_vectors import find_positive_sense
from kinegrade.worked.vectors.relatives import find_relative, index_relative
from kinegrade.worked.vectors.slopes.cosines import find_cosine
from kinegrade.worked.vectors.slopes.derived_angles import is_line_found
from kinegrade.worked.vectors.slopes.directions import name_direction
from kinegrade.worked.vectors.slopes.inclination import name_axis
from kinegrade.worked.vectors.table.tracks import find_track_ends
from kinegrade.worked.vectors.vectors import UNITS, name_by_role, name_part


def find_speed(term: Term, case: Case) -> tuple[Amount, Vector]:
    """A relative velocity as it has been stated, and its positive sense."""
    positive = find_positive_sense(term, case, "velocity")
    away = term.velocity(case.motion.rates)
    number = index_relative(find_relative(term), case)
    stated = length(away, case.arithmetic) * find_sign(away.dot(positive))
    return Amount(name_by_role("r", "velocity", number), measure(stated, "m/s")), positive


def list_relative_shares(
    term: Term, by: Multiplier, equation: VectorEquation, case: Case
) -> list[Amount] | None:
    """The shares of a relative motion; None where one is not known by what the page has."""
    shares = _Relative(term, by, equation, case)
    match equation.level:
        case "velocity":
            found = shares.find_tangential()
        case "acceleration":
            found = _join((shares.find_tangential(), shares.find_normal(), shares.find_coriolis()))
        case _:
            assert_never(equation.level)
    return found


def _join(parts: tuple[list[Amount] | None, ...]) -> list[Amount] | None:
    known = [one for one in parts if one is not None]
    return [one for part in known for one in part] if len(known) == len(parts) else None


@dataclass(frozen=True)
class _Relative:
    """A point that slides, or turns about a centre, in a frame that turns."""

    term: Term
    by: Multiplier
    equation: VectorEquation
    case: Case

    def find_tangential(self) -> list[Amount] | None:
        """The speed, or the tangential acceleration, along the path."""
        level, case, term = self.equation.level, self.case, self.term
        positive = find_positive_sense(term, case, level)
        if not double(case.rates(level)[term.rate]) or not double(self.by.vector.dot(positive)):
            return []
        part = self._find_part()
        if part is None or case.findings.spares(term.rate, level):
            return None
        sense = find_sign(part.value.dot(positive))
        number = measure(length(part.value, case.arithmetic) * sense, UNITS[level, False])
        return self._times(Amount(name_part(self.equation, part, case), number), positive)

    def _find_part(self) -> Part | None:
        """The relative motion along the path, as it stands in the equation."""
        return next((one for one in self.equation.parts if _is_of(one, self.term)), None)

    def find_normal(self) -> list[Amount] | None:
        """The normal acceleration on a circle, v_r^2/r towards its centre."""
        term = self.term
        match term.kind:
            case "sliding" | "rotation":
                return []
            case "arc":
                if not double(self.case.motion.rates[term.rate]):
                    return []
                speed, _ = find_speed(term, self.case)
                arm = point_from_base(term, self.case)
                radius = arm.length or UNIT
                rate = speed.squared().over(radius.squared())
                return [one.signed(-1) for one in gather(rate, tuple(self.by.dot(arm.pair)))]
            case _:
                assert_never(term.kind)

    def find_coriolis(self) -> list[Amount] | None:
        """The Coriolis acceleration, twice the relative velocity turned with the frame."""
        omega = self.case.motion.omega(self.term.frame)
        if not double(omega) or not double(self.case.motion.rates[self.term.rate]):
            return []
        speed, positive = find_speed(self.term, self.case)
        turning = Amount(self.case.naming.omega(self.term.frame), measure(omega, "rad/s"))
        twice = Amount(TWO * turning.letters, TWO.dot(turning.numbers)).times(speed)
        return self._times(twice, positive.turned())

    def _times(self, size: Amount, direction: Vector) -> list[Amount] | None:
        """A size times the share of a direction along or normal to the path."""
        by = self.by.vector
        along, across = double(by.dot(direction)), double(by.cross(direction))
        if not along:
            return []
        if not across and self.by.length is not None:
            return [size.times(self.by.length).signed(find_sign(along))]
        path = self._find_line()
        if path is None or path.length is None:
            return self._turn(size, direction)
        line = path.turned() if double(path.vector.cross(direction)) else path
        sign = find_sign(line.vector.dot(direction))
        rate = size.over(path.length)
        return [one.signed(sign) for one in gather(rate, tuple(self.by.dot(line.pair)))]

    def _turn(self, size: Amount, direction: Vector) -> list[Amount] | None:
        """The same along an axis by an angle of the path that is known."""
        part = self._find_part()
        heading = name_direction(bearing(direction), part, self.case) if part else None
        along = name_axis(bearing(self.by.vector)) if self.by.is_unit else None
        cosine = find_cosine(heading, along) if heading and along else None
        if cosine is None or not is_line_found(cosine.value, self.case):
            return None
        return [size.times(Amount(cosine.state(False), cosine.state(True))).signed(cosine.sign)]

    def _find_line(self) -> Multiplier | None:
        """The path between two points, or the radius of the circle."""
        match self.term.kind:
            case "arc" | "rotation":
                return point_from_base(self.term, self.case)
            case "sliding":
                ends = find_track_ends(self.term, self.case)
                return point_from(*ends, self.case) if ends else None
            case _:
                assert_never(self.term.kind)


def _is_of(part: Part, term: Term) -> bool:
    return part.term == term and part.role == "relative" and part.part != "n"
