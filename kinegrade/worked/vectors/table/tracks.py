"""The points that give the line along which a point slides."""

from __future__ import annotations

from kinegrade.expressions.tree import Name
from kinegrade.mechanics.relations.terms import Term
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Part
from kinegrade.worked.case import Case
from kinegrade.worked.formulas.measures import NEGLIGIBLE


def find_heading(part: Part) -> Vector:
    """The vector whose direction a part has: itself, or the positive sense of an unknown one."""
    return part.value if part.coefficient is None else part.coefficient


def find_path_ends(part: Part, case: Case) -> tuple[str, str] | None:
    """The points that give the line along which a part slides, in its positive sense; None where no
    two points do.
    """
    return orient_track(part.term, find_heading(part), case) if part.term else None


def orient_track(term: Term, positive: Vector, case: Case) -> tuple[str, str] | None:
    """The points that give the line along which a point slides, so that the way from one to the
    other is the `positive` one; None where no two points do.
    """
    ends = find_track_ends(term, case) if term.kind == "sliding" else None
    if ends is None:
        return None
    start, end = (case.motion.points[point] for point in ends)
    return ends if float((end - start).dot(positive)) > 0 else (ends[1], ends[0])


def find_track_ends(term: Term, case: Case) -> tuple[str, str] | None:
    """The two points by which the line is given along which a point slides, None where it is given
    otherwise.
    """
    sentence = case.joint(term)
    if sentence and sentence.on and len(sentence.on.arguments) == 2:
        start, end = sentence.on.arguments
        if isinstance(start, Name) and isinstance(end, Name) and end.name in case.motion.points:
            return start.name, end.name
        if isinstance(start, Name) and _lies_aslant(start.name, term, case):
            return start.name, term.point
    return None


def _lies_aslant(start: str, term: Term, case: Case) -> bool:
    """Whether a line through a point, given by its angle, passes through the point that slides
    along it, and along no axis.
    """
    points, x, y = case.motion.points, *map(abs, map(float, term.vector))
    if start not in points or min(x, y) < NEGLIGIBLE:
        return False
    away = points[term.point] - points[start]
    offset = abs(float(away.cross(term.vector)))
    return offset < NEGLIGIBLE < float(away.squared())
