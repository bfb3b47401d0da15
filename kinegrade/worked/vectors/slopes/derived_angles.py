"""The acute angle between a line and the x axis, which a solution derives and may name again."""

from __future__ import annotations

from kinegrade.worked.case import Case
from kinegrade.worked.formulas.atoms import Symbol
from kinegrade.worked.formulas.measures import bearing, double
from kinegrade.worked.formulas.symbols import index_letter, join_letters
from kinegrade.worked.positions.marked_angles import measure_given
from kinegrade.worked.vectors.slopes.inclination import CLOSE

ACUTE = "psi"  # the letter of a derived angle


def name_acute(ends: tuple[str, str], case: Case) -> Symbol:
    """The acute angle between a line and the x axis, psi_AB; psi_BA, or psi_CB of the same line,
    where that has been found.
    """
    order = find_same_line(ends, case) or ends
    return index_letter(ACUTE, join_letters(map(case.naming.letter, order)).row)


def find_same_line(ends: tuple[str, str], case: Case) -> tuple[str, str] | None:
    """Two points of the line through `ends` whose angle has been found, `ends` first."""
    for order in (ends, ends[::-1]):
        if order in case.findings.inclined:
            return order
    points = case.motion.points
    start, way = points[ends[0]], points[ends[1]] - points[ends[0]]

    def lies(point: str) -> bool:
        return not double(way.cross(points[point] - start))

    found = (pair for pair in case.findings.inclined if all(map(lies, pair)))
    return min(found, default=None)


def is_angle_found(ends: tuple[str, str], case: Case) -> bool:
    """Whether the acute angle of the line through two points has been found."""
    return find_same_line(ends, case) is not None


def is_line_found(angle: float, case: Case) -> bool:
    """Whether an acute angle, in degrees, is that of a line with x which has been introduced, or is
    given.
    """
    points = case.motion.points
    lines = (bearing(points[end] - points[start]) % 180 for start, end in case.findings.inclined)
    found = (min(line, 180 - line) for line in lines)
    given = (measure_given(name, case) for name in case.template.angles)
    return any(abs(one - angle) < CLOSE for one in (*found, *given))
