"""Checks of poles of bodies that slide through sleeves about fixed axes: the point of the body at
the axis moves along the sleeve, so the pole lies on the normal to it there.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from kinegrade.language.message import Message
from kinegrade.mechanics.vector import AxisName, Vector
from kinegrade.worked.case import Case
from kinegrade.worked.checks.check import Check, compare
from kinegrade.worked.checks.sides import Side
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.measures import double
from kinegrade.worked.formulas.numbers import measure
from kinegrade.worked.formulas.symbols import name_coordinate
from kinegrade.worked.positions.algebra import ZERO
from kinegrade.worked.positions.axes import choose_axes
from kinegrade.worked.vectors.summands import PLACES


def list_sleeve_checks(case: Case) -> Iterator[Check]:
    """The checks of the poles that the solution has found of such bodies, each with the line from
    the sleeve to the body's base point, where that lies along no axis.
    """
    frames = case.motion.frames
    pivots = frames.mechanism.find_pivots()
    for body in case.findings.poles:
        pin = frames.bases[body].point
        for holder, line in frames.mechanism.find_sleeves(body):
            sleeve = pivots.get(holder)
            if sleeve in (None, pin) or case.arithmetic.is_zero(case.motion.omega(body)):
                continue
            arm = case.motion.points[pin] - case.motion.points[sleeve]
            if all(map(double, arm)) and case.arithmetic.is_zero(arm.cross(line.direction)):
                yield _check_pole(body, sleeve, pin, case)


def _check_pole(body: str, sleeve: str, pin: str, case: Case) -> Check:
    """The two products of the scalar product that is zero, one on each side."""
    pole = case.findings.poles[body]
    places = {**case.motion.points, pole: case.motion.pole(body, case.arithmetic)}
    along, across = (
        multiply_coordinates(axis, sleeve, (pole, pin), places, case) for axis in PLACES
    )
    letter, axle, end = map(case.naming.point, (pole, sleeve, pin))
    way = Message(
        "solution.sleeve-normal",
        body=case.naming.body(body),
        pole=letter,
        sleeve=axle,
        pin=end,
    )
    turned = Side(-across.numbers, -across.value, -across.sum)
    return compare(way, along, turned, "m^2")


def multiply_coordinates(
    axis: AxisName, start: str, ends: tuple[str, str], places: Mapping[str, Vector], case: Case
) -> Side:
    """The product of the coordinates of two points, both from a third one."""
    fixed = choose_axes(case.construction).coordinate(axis, start)
    letters: list[Formula] = []
    numbers: list[Formula] = []
    value = 1
    before = places[start][PLACES[axis]]
    for end in ends:
        after = places[end][PLACES[axis]]
        letter = name_coordinate(axis, case.naming.letter(end))
        first = name_coordinate(axis, case.naming.letter(start))
        letters.append(letter if fixed == ZERO else letter - first)
        number = measure(after, "m")
        numbers.append(number if fixed == ZERO else number - measure(before, "m"))
        value = value * (after - before)
    return Side(numbers[0].dot(numbers[1]), value, letters[0] * letters[1])
