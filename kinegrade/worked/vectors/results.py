"""The values of unknown rates: of a vector along its direction, and of the rotation it belongs
to.
"""

from __future__ import annotations

from collections.abc import Iterator

from kinegrade.language.math.tree import Row
from kinegrade.language.message import Message
from kinegrade.mechanics.rates import Rate
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Level, Part
from kinegrade.worked.case import Case
from kinegrade.worked.formulas.equation import Equation, Link, equate
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.measures import double, length
from kinegrade.worked.formulas.numbers import measure, state_number
from kinegrade.worked.positions.stated_angles import find_track_angle, state_bearing
from kinegrade.worked.senses import (
    find_axis_sense,
    say_beside,
    state_rotation_sense,
    state_sense_along,
    state_way_round,
)
from kinegrade.worked.vectors.arms import name_length
from kinegrade.worked.vectors.stage import Stage, measure_along_direction
from kinegrade.worked.vectors.table.tracks import find_path_ends
from kinegrade.worked.vectors.vectors import UNITS, name_value


def state_results(stage: Stage, rate: Rate) -> Iterator[Equation]:
    """The value of a vector along its direction, and of the rotation it belongs to."""
    case, level = stage.case, stage.level
    found = stage.occurrences(rate)
    turning = rate.kind == "turning"
    if found and (len(found) == 1 or not turning):
        equation, part = found[0]
        symbol = name_value(equation, part, case)
        yield state_vector_value(symbol, part, case, level)
        if turning and not case.findings.spares(rate, level):
            yield state_rotation_result(rate, case, level, _divide_by_arm(symbol, part, stage))
    elif turning:
        yield state_rotation_result(rate, case, level)


def _divide_by_arm(symbol: Formula, part: Part, stage: Stage) -> tuple[Link, ...]:
    """A rotation as the speed over the arm, in symbols and, unless it is zero, in numbers."""
    ratio = symbol / name_length(part.base, part.point, stage.case)
    if part.term is None or not double(length(part.value, stage.case.arithmetic)):
        return equate(ratio)
    speed = measure_along_direction(part.term, stage.case, stage.level)
    arm = measure(length(part.term.vector, stage.case.arithmetic), "m")
    return equate(ratio, measure(speed, UNITS[stage.level, False]) / arm)


def state_rotation_result(
    rate: Rate, case: Case, level: Level, how: tuple[Link, ...] = ()
) -> Equation:
    """The value of an angular velocity or acceleration with its sense."""
    value = case.rates(level)[rate]
    links = (*how, *state_number(value, UNITS[level, True]))
    letters = case.naming.turning(rate.body, level)
    return Equation(letters, links, state_rotation_sense(value, case))


def state_vector_value(symbol: Formula, part: Part, case: Case, level: Level) -> Equation:
    """The algebraic value of an unknown vector along its positive direction, with its sense in
    words.
    """
    unit = UNITS[level, False]
    if part.term is None or part.coefficient is None:
        return Equation(symbol, state_number(length(part.value, case.arithmetic), unit))
    value = measure_along_direction(part.term, case, level)
    sense = state_sense(double(value), part.coefficient, part, case)
    return Equation(symbol, state_number(value, unit), sense)


def state_sense(value: float, positive: Vector, part: Part, case: Case) -> Row:
    """The direction beside the value of an unknown vector; of one against the positive sense of a
    rotation in which sense about what, where the vector is slanting.
    """
    if part.term and part.base and value < 0 and find_axis_sense(positive) is None:
        turn = value * double(part.term.vector.cross(positive))
        return state_way_round(part.base, turn, case)
    slanting = find_axis_sense(positive) is None and find_path_ends(part, case) is None
    if value < 0 and slanting and part.term and find_track_angle(part.term, case):
        angle = case.text(state_bearing(-positive, part.term, case))
        return say_beside(Message("solution.at-angle", angle=angle), case)
    return state_sense_along(value, positive, find_path_ends(part, case), case)
