"""Checks of poles that normals have given: their distances by coordinates."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from kinegrade.language.message import Message
from kinegrade.worked.case import Case
from kinegrade.worked.checks.check import Check, compare
from kinegrade.worked.checks.positions.places import state_difference
from kinegrade.worked.checks.sides import Side
from kinegrade.worked.formulas.atoms import AXES, ZERO, add_squares
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.measures import length
from kinegrade.worked.formulas.numbers import measure
from kinegrade.worked.formulas.symbols import join_letters, name_coordinate
from kinegrade.worked.positions.algebra import ZERO as ORIGIN
from kinegrade.worked.positions.axes import choose_axes
from kinegrade.worked.steps.couplers import find_coupler
from kinegrade.worked.steps.poles.poles import name_pole
from kinegrade.worked.vectors.stage import Stage


def list_pole_checks(stages: Iterable[Stage], case: Case) -> Iterator[Check]:
    """The checks of all poles, each from the points whose velocities have led to it, where they lie
    neither straight above one another nor beside.
    """
    for coupler in filter(None, map(find_coupler, stages)):
        pole = case.motion.pole(coupler.body, case.arithmetic)
        letter = case.naming.point(name_pole(coupler.body, case))
        for part in (coupler.point, coupler.base):
            place = case.motion.points[part.point]
            sides = [state_difference(*pair) for pair in zip(place, pole, strict=True)]
            if ZERO not in sides:
                distance = length(pole - place, case.arithmetic)
                point = case.naming.point(part.point)
                way = Message("solution.check-pole", pole=letter, point=point)
                letters = add_squares(_name_sides(part.point, coupler.body, case))
                ends = name_pole(coupler.body, case), part.point
                told = join_letters(map(case.naming.letter, ends))
                left = Side(add_squares(sides), distance, letters)
                yield compare(way, left, Side(measure(distance, "m"), distance, told), "m")


def _name_sides(point: str, body: str, case: Case) -> Iterator[Formula]:
    """The coordinates of a pole from a point, in letters."""
    axes, pole = choose_axes(case.construction), case.naming.letter(name_pole(body, case))
    for axis in AXES:
        found = name_coordinate(axis, pole)
        start = name_coordinate(axis, case.naming.letter(point))
        yield found if axes.coordinate(axis, point) == ORIGIN else found - start
