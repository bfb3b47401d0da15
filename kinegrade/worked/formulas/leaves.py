"""What stands as a symbol in a formula of symbols: names, coordinates and distances of points,
vectors between points, angles in whole degrees.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import Any, assert_never

from kinegrade.expressions.evaluation import evaluate
from kinegrade.expressions.tree import Call, Expression, Name, Operation, find_names, walk
from kinegrade.expressions.tree import Number as Literal
from kinegrade.language.math.tree import Letter
from kinegrade.numbers.field import Field
from kinegrade.numbers.rounded_text import write_decimal
from kinegrade.worked.formulas.atoms import Measured, Number, Symbol
from kinegrade.worked.formulas.expression import Formulation
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.symbols import (
    draw_arrow,
    join_letters,
    name_angle,
    name_coordinate,
    name_point,
    name_quantity,
)

_X_AXIS = Symbol((Letter("x"),))


def formulate(symbols: Mapping[str, Symbol], points: Collection[str] = ()) -> Formulation:
    """The formulas of expressions in symbols.

    `pi` stands as such, but in degrees within sines and cosines, and everywhere in an angle to be
    stated in degrees. The difference of two of the `points` is a vector with an arrow.
    """
    return Formulation(
        lambda tree, angular: (
            _find_vector_between(tree, symbols, points) or _find_leaf(tree, angular, symbols)
        )
    )


def _find_leaf(tree: Expression, angular: bool, symbols: Mapping[str, Symbol]) -> Formula | None:
    if angular and (half_turns := _count_half_turns(tree)) is not None:
        degrees = Measured(Number(write_decimal(abs(half_turns * 180), 6)), "deg")
        return -degrees if half_turns < 0 else degrees
    match tree:
        case Name(name):
            return symbols.get(name) or name_quantity(name)
        case Call(function="x" | "y" as axis, arguments=(Name(point),)):
            return name_coordinate(axis, _find_letter(point, symbols))
        case Call(function="distance", arguments=(Name(first), Name(second))):
            return join_letters(_find_letter(point, symbols) for point in (first, second))
        case Call(function="direction", arguments=(Name(first), Name(second))):
            ends = (_find_letter(point, symbols) for point in (first, second))
            return name_angle(_X_AXIS, draw_arrow(ends))
        case Literal() | Operation() | Call():
            return None
        case _:
            assert_never(tree)


def _find_letter(point: str, symbols: Mapping[str, Symbol]) -> Symbol:
    return symbols.get(point) or name_point(point)


def _find_vector_between(
    tree: Expression, symbols: Mapping[str, Symbol], points: Collection[str]
) -> Symbol | None:
    """The difference of two points as the vector from the second to the first; None for any other
    expression.
    """
    match tree:
        case Operation(sign="-", left=Name(end), right=Name(start)):
            if not {start, end} <= set(points):
                return None
            return draw_arrow(_find_letter(point, symbols) for point in (start, end))
        case _:
            return None


def count_quarter_turns(tree: Expression) -> int | None:
    """The number of right angles, 0 to 3, in an angle made of numbers and `pi`; None for any other
    angle.
    """
    half_turns = _count_half_turns(tree)
    quarters = None if half_turns is None else half_turns * 2
    return None if quarters is None or quarters != int(quarters) else int(quarters) % 4


def _count_half_turns(tree: Expression) -> Any:
    """An angle made of numbers and `pi` alone, divided by pi; None for any other expression."""
    if set(find_names(tree)) - {"pi"} or any(isinstance(part, Call) for part in walk(tree)):
        return None
    field = Field()
    value = evaluate(tree, {"pi": field.turns(1)}, {}, field)
    return getattr(value, "half_turns", value if value == 0 else None)
