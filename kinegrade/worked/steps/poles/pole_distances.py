"""Where the pole of a body lies: its distances from two points, by the triangle that it forms with
them, and its coordinates from there.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

from kinegrade.language.message import Message
from kinegrade.mechanics.vector import AxisName, Vector
from kinegrade.mechanics.vector_equation import Part
from kinegrade.worked.case import Case
from kinegrade.worked.document import Block
from kinegrade.worked.formulas.atoms import AXES, ONE, ZERO, Symbol, add_terms
from kinegrade.worked.formulas.equation import Equation, Link, drop_repetition, equate
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.measures import bearing, length
from kinegrade.worked.formulas.numbers import measure, state_angle, state_number
from kinegrade.worked.formulas.symbols import join_letters, name_coordinate
from kinegrade.worked.steps.couplers import Coupler
from kinegrade.worked.vectors.angle_sums import explain_sums
from kinegrade.worked.vectors.arms import introduce_lengths, name_length
from kinegrade.worked.vectors.slopes.cosines import Cosine, find_cosine
from kinegrade.worked.vectors.slopes.directions import name_direction
from kinegrade.worked.vectors.slopes.inclination import Inclination, name_axis
from kinegrade.worked.vectors.slopes.introduced_angles import introduce_angle
from kinegrade.worked.vectors.stage import divide_by
from kinegrade.worked.vectors.summands import PLACES
from kinegrade.worked.vectors.table.tracks import find_heading

RIGHT, _HALF = 90.0, 180.0
_CORNERS: dict[tuple[Literal["sin", "cos"], int], tuple[float, int]] = {
    ("cos", 1): (0.0, 1),
    ("cos", -1): (_HALF, -1),
    ("sin", 1): (RIGHT, -1),
    ("sin", -1): (RIGHT, 1),
}  # from a cosine to its angle: where to start, and with which sign the named angle counts
_DIRECTIONS: dict[AxisName, float] = {"x": 0.0, "y": 90.0}


@dataclass(frozen=True)
class PoleTriangle:
    """The triangle of a body's pole and the two points whose velocities have known directions."""

    coupler: Coupler
    letter: Symbol
    pole: Vector
    case: Case

    def explain_distances(self) -> Iterator[Block]:
        """The angles and the length that the distances take, and these."""
        equations = self._state_distances()
        self.case.findings.distances |= {equation.left.print() for equation in equations}
        if all(len(equation.links) > 1 for equation in equations):
            yield from self._introduce()
            yield self.case.say(self._name_law())
        yield self.case.show(*self._state_distances())  # by the angles that stand there now

    def _state_distances(self) -> tuple[Equation, ...]:
        """The distances of both points from the pole."""
        base, point = self.coupler.base, self.coupler.point
        return tuple(self._state_distance(*pair) for pair in ((base, point), (point, base)))

    def explain_coordinates(self) -> Iterator[Block]:
        """The coordinates of the pole, from the point that lies straight above, below or beside it
        where one does; its distance from that point unless it is one of the coordinates.
        """
        base, point = self.coupler.base, self.coupler.point
        straight = [one for one in (point, base) if name_axis(bearing(self._find_arm(one)))]
        start = straight[0] if straight else base
        yield self.case.show(*(self._state_coordinate(axis, start) for axis in AXES))

    def name_distance(self, part: Part) -> Symbol:
        """The letters of the distance of a point from the pole."""
        return join_letters((self.letter, self.case.naming.letter(part.point)))

    def measure_distance(self, part: Part) -> Formula:
        """The number of that distance."""
        return measure(length(self._find_arm(part), self.case.arithmetic), "m")

    def _introduce(self) -> Iterator[Block]:
        for part in (self.coupler.rotation, self.coupler.base, self.coupler.point):
            yield from introduce_angle(part, self.case)
        yield from map(self.case.show, introduce_lengths((self._ends,), self.case))
        yield from map(self.case.say, explain_sums(self._list_cosines(), self.case))

    def _name_law(self) -> Message:
        """By what the distances follow from the angles, and which these are."""
        case, base, point = self.case, self.coupler.base, self.coupler.point
        first, second = map(case.naming.point, (base.point, point.point))
        arms = self._name_directions(base, point), self._name_directions(point, base)
        corners = [_name_corner(reach, side) for side, reach, _ in filter(None, arms)]
        corners += [_name_corner(*(reach for _, reach, _ in filter(None, arms)))]
        names = ("at_first", "at_second", "at_pole")
        angles = {name: case.text(angle) for name, angle in zip(names, corners, strict=True)}
        pole = case.text(self.letter)
        return Message("solution.pole-triangle", pole=pole, first=first, second=second, **angles)

    @property
    def _ends(self) -> tuple[str, str]:
        return self.coupler.rotation.base, self.coupler.rotation.point

    def _find_arm(self, part: Part) -> Vector:
        return self.pole - self.case.motion.points[part.point]

    def _state_distance(self, part: Part, other: Part) -> Equation:
        """PA cos(PA, v_B) = AB cos(AB, v_B), since PB is normal to v_B; its value alone where the
        angles have no names.
        """
        case, directions = self.case, self._name_directions(part, other)
        value = state_number(length(self._find_arm(part), case.arithmetic), "m")
        left = self.name_distance(part)
        if directions is None:
            return Equation(left, value)
        chord = measure(length(self._find_chord(part, other), case.arithmetic), "m")
        names = name_length(*self._ends, case), chord
        working = (
            _divide(name, *directions, in_numbers)
            for name, in_numbers in zip(names, (False, True), strict=True)
        )
        return Equation(left, drop_repetition(equate(*working), value))

    def _name_directions(
        self, part: Part, other: Part
    ) -> tuple[Inclination, Inclination, Inclination] | None:
        """The directions of the chord, of the arm from a point to the pole, and of the other
        point's velocity, to which its own arm is normal; None where one of them has no name.
        """
        chord, arm = bearing(self._find_chord(part, other)), bearing(self._find_arm(part))
        side = name_direction(chord, self.coupler.rotation, self.case)
        reach = name_direction(arm, part, self.case)
        axis = name_direction(bearing(find_heading(other)), other, self.case)
        return None if side is None or reach is None or axis is None else (side, reach, axis)

    def _list_cosines(self) -> Iterator[Cosine | None]:
        """The cosines that the distances take."""
        base, point = self.coupler.base, self.coupler.point
        for pair in ((base, point), (point, base)):
            directions = self._name_directions(*pair)
            if directions is not None:
                *named, axis = directions
                yield from (find_cosine(one, axis) for one in named)

    def _find_chord(self, part: Part, other: Part) -> Vector:
        points = self.case.motion.points
        return points[other.point] - points[part.point]

    def _state_coordinate(self, axis: AxisName, start: Part) -> Equation:
        """x_P = x_A + PA cos(PA, x)."""
        case, place = self.case, PLACES[axis]
        left = name_coordinate(axis, self.letter)
        value = state_number(self.pole[place], "m")
        arm = name_direction(bearing(self._find_arm(start)), start, case)
        along = name_axis(_DIRECTIONS[axis])
        if arm is None or along is None:
            return Equation(left, value)
        return Equation(left, drop_repetition(self._add_arm(axis, start, arm, along), value))

    def _add_arm(
        self, axis: AxisName, start: Part, arm: Inclination, along: Inclination
    ) -> tuple[Link, ...]:
        """A point's coordinate and the share of its distance from the pole, in symbols and in
        numbers.
        """
        case = self.case
        from_symbol = name_coordinate(axis, case.naming.letter(start.point))
        from_number = measure(case.motion.points[start.point][PLACES[axis]], "m")
        terms = (
            (from_symbol, self.name_distance(start), False),
            (from_number, self.measure_distance(start), True),
        )
        return equate(*(_add(*one, arm, along) for one in terms))


def _name_corner(side: Inclination, other: Inclination) -> Formula:
    """The angle between two sides of a triangle by named angles, a right one by its degrees."""
    cosine = find_cosine(side, other)
    if cosine is None:
        return state_angle(RIGHT)
    start, turned = _CORNERS[cosine.function, cosine.sign]
    value = start + turned * cosine.value
    terms = [*([state_angle(start)] if start else []), cosine.angle.signed(turned)]
    if value < 0:
        terms = [-one for one in terms]
    elif value > _HALF:
        terms = [state_angle(2 * _HALF), *(-one for one in terms)]
    return add_terms(sorted(terms, key=lambda one: -one.sign))


def _add(
    start: Formula, size: Formula, in_numbers: bool, arm: Inclination, along: Inclination
) -> Formula:
    """A coordinate plus the share of a distance, what is zero left out."""
    sign, cosine = _state_cosine(arm, along, in_numbers)
    share = size if cosine == ONE else size * cosine
    shares = () if ZERO in (cosine, size) else (share.signed(sign),)
    return add_terms((*(() if start == ZERO else (start,)), *shares))


def _divide(
    size: Formula, side: Inclination, arm: Inclination, axis: Inclination, in_numbers: bool
) -> Formula:
    """A size times the cosine of one angle, over the cosine of another."""
    sign, above = _state_cosine(side, axis, in_numbers)
    other, below = _state_cosine(arm, axis, in_numbers)
    if above == ZERO:
        return ZERO
    product = size if above == ONE else size * above
    return divide_by(product, below).signed(sign * other)


def _state_cosine(heading: Inclination, axis: Inclination, in_numbers: bool) -> tuple[int, Formula]:
    """The cosine of the angle between two directions, and its sign."""
    named = find_cosine(heading, axis)
    if named is not None:
        return named.sign, named.state(in_numbers)
    quarters = (heading.quarters - axis.quarters) % 4
    return (1, ZERO) if quarters % 2 else (1 - quarters, ONE)
