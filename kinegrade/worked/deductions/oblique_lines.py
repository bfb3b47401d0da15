"""Oblique lines of a projection: their letters and their directions by named angles."""

from __future__ import annotations

from dataclasses import dataclass

from kinegrade.language.math.tree import Sign
from kinegrade.mechanics.vector_equation import Part
from kinegrade.worked.case import Case
from kinegrade.worked.formulas.atoms import Symbol
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.measures import bearing
from kinegrade.worked.formulas.symbols import draw_arrow, join_letters
from kinegrade.worked.vectors.projection import Projection
from kinegrade.worked.vectors.slopes.directions import find_ends, name_along, name_direction
from kinegrade.worked.vectors.slopes.inclination import Inclination, name_axis
from kinegrade.worked.vectors.table.tracks import find_heading
from kinegrade.worked.vectors.vectors import name_part

RIGHT, _HALF = 90.0, 180.0
CLOSE = 1e-6  # degrees


@dataclass(frozen=True)
class ObliqueLine:
    """An oblique line: its letters, or the vector along it where no two points give it, its
    direction in degrees, and that by named angles.
    """

    letters: Formula
    direction: float
    named: Inclination
    ends: tuple[str, str] | None

    def is_across(self, direction: float) -> bool:
        """Whether a direction along or normal to the line is normal to it."""
        return round((direction - self.direction) / RIGHT) % 2 == 1


def find_line(part: Part, projection: Projection, case: Case) -> ObliqueLine | None:
    """The oblique line along or normal to which a part is."""
    direction, ends = bearing(find_heading(part)), find_ends(part, case)
    if ends is not None:
        return draw_line(ends, direction, case)
    named = name_direction(direction, part, case)
    if named is None or named.angle is None:
        return None
    return ObliqueLine(
        name_part(projection.equation, part, case, bold=True), direction, named, None
    )


def draw_line(ends: tuple[str, str], direction: float, case: Case) -> ObliqueLine | None:
    """The line through two points, along or normal to which a direction is; None along an axis."""
    if name_axis(direction) is not None or not {*ends} <= {*case.motion.points}:
        return None
    start, end = (case.motion.points[point] for point in ends)
    named, letters = name_along(bearing(end - start), ends, case), map(case.naming.letter, ends)
    return ObliqueLine(join_letters(letters), bearing(end - start), named, ends) if named else None


def measure_corner(first: ObliqueLine, second: ObliqueLine, case: Case) -> float | None:
    """The angle of two lines at the point that both end in, in degrees; None without one."""
    common = {*(first.ends or ())} & {*(second.ends or ())}
    if len(common) != 1:
        return None
    (corner,) = common
    directions = [
        line.direction if line.ends and line.ends[0] == corner else line.direction + _HALF
        for line in (first, second)
    ]
    return abs((directions[0] - directions[1] + _HALF) % (2 * _HALF) - _HALF)


def name_corner(first: ObliqueLine, second: ObliqueLine, case: Case) -> Symbol:
    """The angle at that point by the letters of both lines: that of a triangle."""
    one, other = first.ends or (), second.ends or ()
    (corner,) = {*one} & {*other}
    (start,), (end,) = {*one} - {corner}, {*other} - {corner}
    letters = join_letters(map(case.naming.letter, (start, corner, end)))
    return Symbol((Sign(r"\angle"), *letters.print()))


def direct_lines(
    first: ObliqueLine, second: ObliqueLine, angle: float, case: Case
) -> tuple[Formula, Formula]:
    """The letters of two lines, one of them from its other end where only so the angle, in
    degrees, is that between the directions of the letters; the vectors along them where it is
    obtuse, as lines make no obtuse angle.
    """
    between = abs((first.direction - second.direction + _HALF) % (2 * _HALF) - _HALF)
    as_they_are, obtuse = abs(between - angle) < CLOSE, angle > RIGHT + CLOSE
    turned = [False, False]
    if not as_they_are:
        turned = [second.ends is None, second.ends is not None]
    one, other = (
        _write_line(line, case, turned=back, obtuse=obtuse)
        for line, back in zip((first, second), turned, strict=True)
    )
    return one, other


def _write_line(line: ObliqueLine, case: Case, *, turned: bool, obtuse: bool) -> Formula:
    """The letters of a line, from its end to its start if `turned`, with an arrow if `obtuse`."""
    if line.ends is None:
        return line.letters
    ends = line.ends[::-1] if turned else line.ends
    letters = map(case.naming.letter, ends)
    return draw_arrow(letters) if obtuse else join_letters(letters)
