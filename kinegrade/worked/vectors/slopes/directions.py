"""Directions by named angles: what a direction makes with the x axis, by an angle of the statement
or by one that is derived from the coordinates of two points.
"""

from __future__ import annotations

from typing import assert_never

from kinegrade.mechanics.relations.terms import Term
from kinegrade.mechanics.vector_equation import Part
from kinegrade.worked.case import Case
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.measures import bearing, tidy
from kinegrade.worked.positions.isosceles import find_mirrored_angle
from kinegrade.worked.positions.stated_angles import find_stated_angle, find_track_angle
from kinegrade.worked.vectors.known_vectors import find_path_term
from kinegrade.worked.vectors.slopes.derived_angles import is_angle_found, is_line_found, name_acute
from kinegrade.worked.vectors.slopes.inclination import RIGHT, Inclination, name_axis, relate
from kinegrade.worked.vectors.table.tracks import find_heading, find_track_ends


def find_inclination(part: Part, case: Case) -> Inclination | None:
    """The direction of a part, its positive one where it is unknown; None where no angle is
    named.
    """
    return name_direction(bearing(find_heading(part)), part, case)


def name_direction(direction: float, part: Part, case: Case) -> Inclination | None:
    """A direction along or normal to the line that belongs to a part."""
    ends = find_ends(part, case)
    if ends is not None:
        return name_along(direction, ends, case)
    track = find_track_angle(part.term, case) if part.term else None
    return name_axis(direction) or (relate(direction, track) if track else None)


def name_along(direction: float, ends: tuple[str, str], case: Case) -> Inclination | None:
    """A direction along or normal to the line through two points; None for any other."""
    axis = name_axis(direction)
    if axis is not None:
        return axis
    line = find_line(ends, case)
    return relate(direction, line) if line else None


def find_ends(part: Part, case: Case) -> tuple[str, str] | None:
    """The two points of the line along or normal to which a part lies."""
    term = part.term or find_path_term(part.together, case)
    return find_term_ends(term, case) if term else None


def find_term_ends(term: Term, case: Case) -> tuple[str, str] | None:
    """The two points of the line along or normal to which a term lies."""
    match term.kind:
        case "sliding":
            return find_track_ends(term, case)
        case "rotation" | "arc":
            return (term.base, term.point)
        case _:
            assert_never(term.kind)


def find_line(ends: tuple[str, str], case: Case) -> tuple[Formula, int, float] | None:
    """The named angle of a line, the sign with which it counts, and its value."""
    if not set(ends) <= set(case.motion.points):
        return None
    start, end = (case.motion.points[point] for point in ends)
    value = bearing(end - start)
    stated = find_stated_angle(ends, case) or find_mirrored_angle(ends, case)
    if stated is not None:
        return stated
    acute = min(value % 180, 180 - value % 180)
    return name_acute(ends, case), 1 if value % 180 < RIGHT else -1, tidy(acute)


def is_direction_told(part: Part, case: Case) -> bool:
    """Whether a part's direction is along an axis, or by an angle that is given or that the
    solution has found, of its own line or of one parallel to it.
    """
    ends, found = find_ends(part, case), find_inclination(part, case)
    if found is None or found.angle is None:
        return found is not None
    known = ends is None or is_inclination_known(found, ends, case)
    return known or is_line_found(found.value, case)


def is_inclination_known(found: Inclination, ends: tuple[str, str], case: Case) -> bool:
    """Whether the angle of a line is given or has been introduced."""
    return found.angle != name_acute(ends, case) or is_angle_found(ends, case)
