"""The same mechanism with slightly other numbers, which shows what holds by this paper's numbers
alone.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from math import sqrt
from typing import TypeVar

from msgspec import structs

from kinegrade.errors import KinegradeError
from kinegrade.expressions.tree import Expression, Number, Operation
from kinegrade.mechanics.motion import Motion, solve_motion
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.doubles import Doubles, convert_number
from kinegrade.problem.assembling.assemble import assemble
from kinegrade.problem.assembling.construction import construct
from kinegrade.problem.solution import Solution

_STEPS = (1e-3, -1e-3, 1e-5, -1e-5)  # relative; of angles that are zero, in radians

_Found = TypeVar("_Found")


def find_nearby_points(solution: Solution) -> Mapping[str, Vector] | None:
    """The points, in doubles, where every parameter has changed a little and no two alike; None
    where the mechanism does not go together so.
    """

    def place(values: Mapping[str, float], arithmetic: Doubles) -> Mapping[str, Vector]:
        return construct(solution.template, values, arithmetic).points

    return _try_nearby(solution, place)


def find_nearby_motion(solution: Solution) -> Motion | None:
    """The motion, in doubles, where every parameter has changed so, and every driver drives, of
    which the template says that it stands still; None where the mechanism does not move so.
    """
    template, scheme = solution.template, solution.template.scheme
    moved = tuple(replace(driver, velocity=_add_some(driver.velocity)) for driver in scheme.drivers)
    moving = structs.replace(template, scheme=structs.replace(scheme, drivers=moved))

    def move(values: Mapping[str, float], arithmetic: Doubles) -> Motion:
        return solve_motion(assemble(moving, values, arithmetic).mechanism, arithmetic)

    return _try_nearby(solution, move)


def _add_some(velocity: Expression) -> Expression:
    """A velocity, a little larger."""
    return Operation("+", velocity, Operation("/", Number(1), Number(997)))


def _try_nearby(
    solution: Solution, find: Callable[[Mapping[str, float], Doubles], _Found]
) -> _Found | None:
    """What is found with changed parameters, by the first change that the mechanism allows."""
    arithmetic = Doubles()
    for step in _STEPS:
        try:
            with arithmetic.context():
                return find(dict(_change(solution, step)), arithmetic)
        except (KinegradeError, ArithmeticError):
            continue
    return None


def _change(solution: Solution, step: float) -> Iterator[tuple[str, float]]:
    """Every parameter, changed by a share of its own."""
    for place, name in enumerate(solution.template.parameters):
        value = convert_number(solution.assembly.values[name])
        yield name, value + step * sqrt(2 + place) * (abs(value) or 1.0)
