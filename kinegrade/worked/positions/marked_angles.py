"""Directions that the figure states: its mark of a given angle lies between a line and an axis."""

from __future__ import annotations

from collections.abc import Mapping
from math import degrees
from typing import NamedTuple

from kinegrade.expressions.tree import Expression, Name
from kinegrade.numbers.angle import Angle
from kinegrade.problem.template.hints import SIDES
from kinegrade.problem.template.hints import Angle as Mark
from kinegrade.worked.case import Case
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.measures import bearing, double
from kinegrade.worked.formulas.symbols import read_symbol

_BEARINGS: Mapping[str, float] = {"right": 0.0, "up": 90.0, "left": 180.0, "down": 270.0}
_CLOSE = 1e-6  # degrees


def find_marked_angle(ends: tuple[str, str], case: Case) -> tuple[int, Expression] | None:
    """The given that the figure marks between the line through two points and an axis, and the sign
    with which it counts; None where it marks none.
    """
    for mark in case.template.figure.angles:
        given = find_marked_given(mark, case)
        for axis, end in ((mark.start, mark.end), (mark.end, mark.start)):
            if given is not None and _is_on_line(ends, (mark.at, end), case):
                sign = _find_sign(axis, (mark.at, end), given, case)
                if sign:
                    return sign, Name(given)
    return None


class Marked(NamedTuple):
    """A side of a mark: the line through two points, and whether another line is normal to it."""

    ends: tuple[str, str]
    across: bool


def find_marked_parallel(ends: tuple[str, str], angle: Formula | None, case: Case) -> Marked | None:
    """The line of which the figure marks an angle that states the line through two points too,
    normal or parallel to it; None where it is that line, or where no mark has the angle.
    """
    sides = [
        (mark.at, end)
        for mark in case.template.figure.angles
        if angle is not None and read_symbol(mark.symbol).looks_like(angle)
        for end in (mark.start, mark.end)
        if end not in SIDES
    ]
    if any(_is_on_line(ends, side, case) for side in sides):
        return None
    quarters = ((side, _count_quarters(ends, side, case)) for side in sides)
    found = (Marked(side, count % 2 == 1) for side, count in quarters if count is not None)
    return next(found, None)


def _count_quarters(ends: tuple[str, str], side: tuple[str, str], case: Case) -> int | None:
    """By how many right angles two lines differ, None where they are oblique."""
    points = case.motion.points
    first, second = (bearing(points[end] - points[start]) for start, end in (ends, side))
    count = round((first - second) / 90)
    return count if abs(first - second - 90 * count) < _CLOSE else None


def find_marked_given(mark: Mark, case: Case) -> str | None:
    """The angle among the givens whose letter stands at a mark."""
    symbol, givens = read_symbol(mark.symbol), case.template.parameters
    angles = (name for name in case.template.angles if read_symbol(givens[name].symbol) == symbol)
    return next(angles, None)


def measure_given(angle: str, case: Case) -> float:
    """An angle among the givens, in degrees."""
    value = case.solution.assembly.values[angle]
    return degrees(float(value.ball() if isinstance(value, Angle) else value))


def _is_on_line(ends: tuple[str, str], side: tuple[str, str], case: Case) -> bool:
    """Whether two points lie on the line of a mark's side."""
    if side[1] in SIDES:
        return False
    points = case.motion.points
    along = points[side[1]] - points[side[0]]
    return not any(double(along.cross(points[end] - points[side[0]])) for end in ends)


def _find_sign(axis: str, side: tuple[str, str], given: str, case: Case) -> int:
    """1 where the side is the axis turned through the given angle counter-clockwise, -1 clockwise;
    0 where neither is so, or the other side is no axis.
    """
    points, (at, end) = case.motion.points, side
    known = axis in SIDES
    start = _BEARINGS[axis] if known else bearing(points[axis] - points[at])
    if abs((start + 45) % 90 - 45) > _CLOSE:
        return 0
    angle, turned = measure_given(given, case), bearing(points[end] - points[at]) - start
    signs = (sign for sign in (1, -1) if abs((turned - sign * angle + 180) % 360 - 180) < _CLOSE)
    return next(signs, 0)
