"""The values of a parameter at which a template is probed: those that can be drawn, and their near
neighbours.

A neighbour is an eighth of the way to the next drawable value, so it is near on the scale of the
parameter, whether micrometres or kilometres, and it never leaves the author's range. Values of one
size and two senses, such as 1 and -1, are a choice between the two: they have no neighbours.
"""

from __future__ import annotations

from itertools import pairwise
from math import floor, log10
from typing import Any

from kinegrade.numbers.rounded_text import write_decimal
from kinegrade.problem.given_values import find_parameter_values, read_values
from kinegrade.problem.solving import solve_certified
from kinegrade.problem.template.template import Parameter, Template

_STEP = 8  # a neighbour is this part of the way to the next drawable value
_FIGURES = 2  # of the distance to the neighbour that its decimal shows


def list_probed(template: Template, parameter: Parameter) -> list[str]:
    """The drawable values as they are written, then their neighbours as decimals."""
    sizes = sorted(float(_write_size(template, parameter.name, text)) for text in parameter.choices)
    if len({abs(value) for value in sizes}) == 1:
        return list(parameter.choices)
    return [*parameter.choices, *_list_neighbours(sizes)]


def _list_neighbours(sizes: list[float]) -> list[str]:
    """The neighbour of each of some sorted values on the side of the next one, with enough decimals
    to distinguish it.

    >>> _list_neighbours([0.002, 0.004]), _list_neighbours([15.0, 30.0])
    (['0.00225', '0.00375'], ['16.9', '28.1'])
    """
    found = []
    for low, high in pairwise(sizes):
        step = (high - low) / _STEP
        decimals = max(0, _FIGURES - 1 - floor(log10(step)))
        found += [f"{low + step:.{decimals}f}", f"{high - step:.{decimals}f}"]
    return found


def _write_size(template: Template, name: str, text: str) -> str:
    """A drawable value in its unit, as a decimal."""
    parameter = template.parameters[name]
    trees = read_values(template, {name: text})

    def decimal(arithmetic: Any) -> str:
        value = find_parameter_values(template, trees, arithmetic)[name]
        scale = arithmetic.scale(parameter.unit.scale)
        number = value if parameter.unit.degrees else value / scale
        if parameter.unit.degrees and not arithmetic.exact:
            number = number * 180 / arithmetic.turns(1)
        return write_decimal(number, 15, parameter.unit.degrees)

    return solve_certified(decimal)
