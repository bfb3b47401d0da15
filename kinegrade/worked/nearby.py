"""The same mechanism with slightly other numbers, which shows what holds by this paper's numbers
alone.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from math import sqrt

from kinegrade.errors import KinegradeError
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.doubles import Doubles, convert_number
from kinegrade.problem.assemble import construct
from kinegrade.problem.solution import Solution

_STEPS = (1e-3, -1e-3, 1e-5, -1e-5)  # relative; of angles that are zero, in radians


def find_nearby_points(solution: Solution) -> Mapping[str, Vector] | None:
    """The points, in doubles, where every parameter has changed a little and no two alike; None
    where the mechanism does not go together so.
    """
    arithmetic = Doubles()
    for step in _STEPS:
        try:
            with arithmetic.context():
                values = dict(_change(solution, step))
                return construct(solution.template, values, arithmetic).points
        except (KinegradeError, ArithmeticError):
            continue
    return None


def _change(solution: Solution, step: float) -> Iterator[tuple[str, float]]:
    """Every parameter, changed by a share of its own."""
    for place, name in enumerate(solution.template.parameters):
        value = convert_number(solution.assembly.values[name])
        yield name, value + step * sqrt(2 + place) * (abs(value) or 1.0)
