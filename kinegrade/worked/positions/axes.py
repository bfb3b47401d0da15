"""Points and vectors in coordinates: what a construction says about x and y.

Differences, sums and rotations of vectors become formulas in the coordinates of named points.
Coordinates that are zero by the choice of the axes are substituted, so that formulas are as short
as in a textbook.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from typing import Literal, assert_never

from kinegrade.expressions.tree import Call, Expression, Name, Number, Operation
from kinegrade.worked.construction_steps import PLACED, Step
from kinegrade.worked.positions.algebra import (
    ONE,
    TWO,
    ZERO,
    Pair,
    is_negated,
    minus,
    over,
    plus,
    root,
    square,
    times,
)
from kinegrade.worked.positions.right_angles import make_unit, turn_back


@dataclass(frozen=True)
class Axes:
    """Writes vectors in coordinates; `points` are the named points, `zeros` the coordinates x(A)
    that are zero.
    """

    points: frozenset[str]
    zeros: frozenset[Expression]

    def x(self, point: str) -> Expression:
        """The x coordinate of a named point."""
        return self.coordinate("x", point)

    def y(self, point: str) -> Expression:
        """The y coordinate of a named point."""
        return self.coordinate("y", point)

    def coordinate(self, axis: str, point: str) -> Expression:
        """A coordinate of a named point, or zero where the choice of the axes makes it zero."""
        leaf = Call(axis, (Name(point),))
        return ZERO if leaf in self.zeros else leaf

    def is_vector(self, tree: Expression) -> bool:
        """Whether an expression is a point or a vector rather than a number."""
        match tree:
            case Name(name=name):
                return name in self.points
            case Call(function=function):
                return function in ("", "turned") or function in PLACED
            case Operation(left=left, right=right):
                return self.is_vector(left) or self.is_vector(right)
            case Number():
                return False
            case _:
                assert_never(tree)

    def pair(self, tree: Expression) -> Pair | None:
        """The coordinates of a point or vector as formulas; None for intersections and feet of
        perpendiculars.
        """
        match tree:
            case Name():
                return (self.x(tree.name), self.y(tree.name)) if tree.name in self.points else None
            case Call(function="", arguments=(x, y)):
                return turn_back(x), turn_back(y)
            case Call(function="turned", arguments=(vector,)):
                return _turn_left(self.pair(vector))
            case Call(function="polar", arguments=(centre, radius, angle)):
                return _add("+", self.pair(centre), scale(make_unit(angle), radius))
            case Call(function="midpoint", arguments=(first, second)):
                return _divide(_add("+", self.pair(first), self.pair(second)), TWO)
            case Operation():
                return self.combined(tree)
            case Number() | Call():
                return None
            case _:
                assert_never(tree)

    def combined(self, tree: Operation) -> Pair | None:
        """Sums and multiples of vectors."""
        if is_negated(tree):
            return _add("-", (ZERO, ZERO), self.pair(tree.right))
        match tree.sign:
            case "+" | "-":
                return _add(tree.sign, self.pair(tree.left), self.pair(tree.right))
            case "/":
                return _divide(self.pair(tree.left), tree.right)
            case "*":
                ends = (tree.left, tree.right)
                vector, factor = ends if self.is_vector(tree.left) else ends[::-1]
                return scale(self.pair(vector), factor)
            case "**":
                raise ValueError("a vector cannot be raised to a power")
            case _:
                assert_never(tree.sign)


@lru_cache(maxsize=256)
def choose_axes(all_steps: tuple[Step, ...]) -> Axes:
    """The axes in which points are given, with the coordinates that each construction, or the fixed
    line along which a point slides, obviously makes zero.
    """
    axes = Axes(frozenset(step.point for step in all_steps), frozenset())
    for step in all_steps:
        leaves = (Call("x", (Name(step.point),)), Call("y", (Name(step.point),)))
        lines = (*_list_lines(step.tree), *([step.track] if step.track else ()))
        pairs = [axes.pair(step.tree), *(_find_line_coordinates(line, axes) for line in lines)]
        zeros = {
            leaf
            for pair in pairs
            if pair is not None
            for leaf, part in zip(leaves, pair, strict=True)
            if part == ZERO
        }
        axes = Axes(axes.points, axes.zeros | zeros)
    return axes


def _list_lines(tree: Expression) -> Iterator[Call]:
    """The lines that meet something in a point."""
    if isinstance(tree, Call) and tree.function == "meet":
        for shape in tree.arguments[:2]:
            if isinstance(shape, Call) and shape.function == "line":
                yield shape


def _find_line_coordinates(line: Call, axes: Axes) -> Pair:
    """What a line parallel to an axis says about its points; ONE where it says nothing."""
    start, direction = find_line(line, axes)
    return (
        ONE if direction[0] != ZERO else start[0],
        ONE if direction[1] != ZERO else start[1],
    )


def find_line(shape: Call, axes: Axes) -> tuple[Pair, Pair]:
    """A point of a line and the line's direction, a unit vector where the line is given by an
    angle.
    """
    start = axes.pair(shape.arguments[0]) or (ZERO, ZERO)
    if not axes.is_vector(shape.arguments[1]):
        return start, make_unit(shape.arguments[1])
    end = axes.pair(shape.arguments[1]) or (ZERO, ZERO)
    return start, (minus(end[0], start[0]), minus(end[1], start[1]))


def _turn_left(pair: Pair | None) -> Pair | None:
    """The vector turned by 90 degrees counter-clockwise."""
    return None if pair is None else (minus(ZERO, pair[1]), pair[0])


def _add(sign: Literal["+", "-"], first: Pair | None, second: Pair | None) -> Pair | None:
    """The sum or difference of two vectors."""
    if first is None or second is None:
        return None
    combine = {"+": plus, "-": minus}[sign]
    return combine(first[0], second[0]), combine(first[1], second[1])


def scale(pair: Pair | None, factor: Expression) -> Pair | None:
    """A multiple of a vector."""
    return None if pair is None else (times(factor, pair[0]), times(factor, pair[1]))


def _divide(pair: Pair | None, divisor: Expression) -> Pair | None:
    """A part of a vector."""
    return None if pair is None else (over(pair[0], divisor), over(pair[1], divisor))


def length_of(vector: Expression, axes: Axes) -> Expression:
    """The length of a vector as a formula: the distance of its ends where these are named."""
    match vector:
        case Call(function="turned", arguments=(inner,)):
            return length_of(inner, axes)
        case Operation(sign="-", left=Name(start), right=Name(end)):
            return Call("distance", (Name(end), Name(start)))
        case Operation(sign="-", right=inner) if is_negated(vector):
            return length_of(inner, axes)
        case Number() | Name() | Operation() | Call():
            pass
        case _:
            assert_never(vector)
    x, y = axes.pair(vector) or (ZERO, ZERO)
    return root(plus(square(x), square(y)))
