"""Points at a distance along a line from a point of it, and what that distance is called."""

from __future__ import annotations

from typing import NamedTuple

from kinegrade.expressions.tree import Call, Expression, Name
from kinegrade.language.math.tree import Row
from kinegrade.mechanics.vector import AxisName
from kinegrade.numbers.units import Unit
from kinegrade.worked.formulas.atoms import AXES, Symbol
from kinegrade.worked.formulas.symbols import name_coordinate, name_quantity
from kinegrade.worked.positions.algebra import ONE, Pair, is_negated, over, plus, times
from kinegrade.worked.positions.axes import length_of
from kinegrade.worked.positions.instance import METRE, Instance

Line = tuple[Pair, Pair]  # a point and a direction


class Way(NamedTuple):
    """A line, the unit of distances along it, metres where its direction is a unit vector, and what
    the distance of the point sought is called; s where that is no side of a figure.
    """

    base: Pair
    along: Pair
    unit: Unit = METRE
    side: Symbol | None = None


def name_distance_along(line: Call, instance: Instance) -> tuple[str, str]:
    """The letter of the distance along a line, and the point from which it counts."""
    return instance.case.text(_choose_letter("s", instance)), instance.text(line.arguments[0])


def _choose_letter(name: str, instance: Instance) -> Symbol:
    """The symbol of an auxiliary quantity, numbered where the template already uses that letter."""
    return name_quantity(instance.free(name))


def solve_along_line(
    point: str, way: Way, share: Expression, instance: Instance
) -> tuple[Row, ...]:
    """The distance worked out, then the coordinates of the point at it from the line's given
    point.
    """
    name = instance.free("s")
    symbol = way.side or name_quantity(name)
    further = instance.named(name, symbol, instance.value(share), way.unit)
    if way.unit is METRE and further.sign(share) > 0:
        _note_length(point, way.base, symbol, instance)
    step = Name(name)
    lines = further.equation(further.formula(step), share, way.unit)
    for axis, start, part in zip(AXES, way.base, way.along, strict=True):
        lines += further.equation(
            name_coordinate_of(further, axis, point), plus(start, times(step, part))
        )
    return lines


def _note_length(point: str, base: Pair, symbol: Symbol, instance: Instance) -> None:
    """Keep the distance of a point from the named point of its line as worked out."""
    starts = (step.point for step in instance.steps if instance.axes.pair(Name(step.point)) == base)
    start = next(starts, None)
    if start is not None and start != point:
        instance.case.findings.arms.setdefault(frozenset((start, point)), symbol)


def make_unit_line(line: Line, instance: Instance) -> Line:
    """A line with a unit direction vector: as it is where given by an angle, else divided by its
    length.
    """
    base, along = line
    if is_unit(along):
        return line
    size = length_of(Call("", along), instance.axes)
    return base, (over(along[0], size), over(along[1], size))


def is_unit(along: Pair) -> bool:
    """Whether a direction is given by an angle or an axis, and not by two points."""
    sizes = [part.right if is_negated(part) else part for part in along]
    return ONE in sizes or any(
        isinstance(size, Call) and size.function in ("cos", "sin") for size in sizes
    )


def name_coordinate_of(instance: Instance, axis: AxisName, point: str) -> Symbol:
    """x_B or y_B, the left side of an equation."""
    return name_coordinate(axis, instance.symbols[point])
