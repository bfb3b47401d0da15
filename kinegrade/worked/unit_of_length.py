"""The unit in which a worked solution counts lengths: that of its question.

What is given and asked in centimetres stays in centimetres from the first line to the last. One in
inches and feet is worked out in feet. Where a question mixes other units of length, or counts time
in hours, its solution is in SI, as books do it.
"""

from __future__ import annotations

from collections.abc import Iterable
from math import isclose
from typing import Literal

from msgspec.structs import replace

from kinegrade.mechanics.motion import Motion
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.units import SCALES, Unit
from kinegrade.problem.quantity import Quantity
from kinegrade.problem.solution import Solution
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.template import Template
from kinegrade.worked.formulas.notation import DIGITS

METRE: Literal["m"] = "m"
_INCHES_AND_FEET = {"in", "ft"}
_LARGEST = 10**DIGITS
_EQUAL = 1e-9  # two ways of working a place out agree to this share of the largest length


def count_lengths_as_given(solution: Solution, asked: Iterable[str]) -> tuple[Solution, str]:
    """The instance with its unit of length taken for the metre, and the name of that unit.

    A mechanism of 20 cm moves as one of 20 m does, so the instance is solved once more as if its
    numbers were metres. One whose template writes lengths as numbers, in SI, stays as it is, and so
    does one that moves at ten thousands of its unit, of which rounding would fill up with zeros.
    """
    template = solution.template
    unit = _find_unit(template, asked)
    texts = {name: quantity.exact for name, quantity in solution.parameters.items()}
    given = {name: text for name, text in texts.items() if text is not None}
    if unit == METRE or len(given) < len(texts):
        return solution, METRE
    counted = solve_template(_count_in_metres(template, unit), given, solution.answers)
    agreeing = _is_scaled(solution, counted, float(SCALES[unit][0].rational))
    return (counted, unit) if agreeing and _reads_well(counted) else (solution, METRE)


def _find_unit(template: Template, asked: Iterable[str]) -> str:
    """The one unit of length of what is given and asked, feet beside inches; m where there are
    others, or none.
    """
    units = [parameter.unit for parameter in template.parameters.values()]
    units += [template.asks[name].unit for name in asked]
    names = frozenset[str]().union(*(unit.lengths for unit in units))
    if names == _INCHES_AND_FEET:
        name = "ft"
    elif len(names) == 1:
        (name,) = names
    else:
        return METRE
    return name if all(_write_in_metres(unit).is_si for unit in units if unit.lengths) else METRE


def _write_in_metres(unit: Unit) -> Unit:
    """A unit with metres in place of its units of length."""
    for name in unit.lengths:
        unit = unit.count_lengths(name, METRE)
    return unit


def _count_in_metres(template: Template, unit: str) -> Template:
    """The template with metres in place of a unit of length, and others measured by that."""

    def exchange(before: Unit) -> Unit:
        scale = before.scale / SCALES[unit][0] ** before.length
        return replace(before.count_lengths(unit, METRE), scale=scale)

    parameters = {
        name: replace(parameter, unit=exchange(parameter.unit))
        for name, parameter in template.parameters.items()
    }
    asks = {name: replace(ask, unit=exchange(ask.unit)) for name, ask in template.asks.items()}
    return replace(template, scheme=replace(template.scheme, parameters=parameters), asks=asks)


def _is_scaled(solution: Solution, counted: Solution, scale: float) -> bool:
    """Whether the second instance is the first, its lengths counted in units of that many
    metres.
    """
    places, others = (_list_places(each) for each in (solution, counted))
    most = max((abs(place) for place in places), default=0.0)
    near = (
        isclose(place, other * scale, rel_tol=0, abs_tol=most * _EQUAL)
        for place, other in zip(places, others, strict=True)
    )
    answers = (_agree(answer, counted[name]) for name, answer in solution.items())
    return all(near) and all(answers) and _move_alike(solution.motion, counted.motion, scale)


def _move_alike(motion: Motion, counted: Motion, scale: float) -> bool:
    """Whether all rates are the same, or the same in the other unit."""
    levels = (motion.rates, counted.rates), (motion.changes, counted.changes)
    pairs = [(float(ours[rate]), float(theirs[rate])) for ours, theirs in levels for rate in ours]
    return all(
        any(isclose(one, other * factor, rel_tol=_EQUAL, abs_tol=_EQUAL) for factor in (1, scale))
        for one, other in pairs
    )


def _reads_well(counted: Solution) -> bool:
    """Whether no motion and no answer needs more digits before the point than are printed."""
    motion = counted.doubles
    numbers = [*motion.rates.values(), *motion.changes.values()]
    numbers += [answer.value for answer in counted.values() if not answer.at_infinity]
    for body in counted.assembly.mechanism.bodies:
        for point in body.points:
            numbers += [*motion.velocity(point, body.name), *motion.acceleration(point, body.name)]
    return all(abs(number) < _LARGEST for number in numbers)


def _list_places(solution: Solution) -> list[float]:
    """The coordinates of the points of an instance."""
    points = (each for each in solution.assembly.values.values() if isinstance(each, Vector))
    return [float(number) for point in points for number in (point.x, point.y)]


def _agree(one: Quantity, other: Quantity) -> bool:
    """Whether two answers are the same number of the same unit of length."""
    return one.at_infinity == other.at_infinity and (
        one.at_infinity or isclose(one.value, other.value, rel_tol=_EQUAL, abs_tol=_EQUAL)
    )
