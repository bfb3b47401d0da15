"""Checks of two points of a body along an axis: where angles place their vectors, the rotation
makes the difference of the components.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import chain
from typing import assert_never

from kinegrade.language.message import Message
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Level
from kinegrade.worked.case import Case
from kinegrade.worked.checks.check import Check, compare
from kinegrade.worked.checks.forms import compare_points
from kinegrade.worked.checks.sides import Side
from kinegrade.worked.findings import Fact, Piece
from kinegrade.worked.formulas.atoms import AXES, OTHER, TWO, ZERO, AxisName, add_terms
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.measures import double, length
from kinegrade.worked.formulas.numbers import measure
from kinegrade.worked.vectors.components import find_heading
from kinegrade.worked.vectors.inclinations import find_cosine, name_axis
from kinegrade.worked.vectors.summands import PLACES
from kinegrade.worked.vectors.vectors import UNITS

_ALONG: dict[AxisName, Vector] = {"x": Vector(1, 0), "y": Vector(0, 1)}
_DIRECTIONS: dict[AxisName, float] = {"x": 0.0, "y": 90.0}


@dataclass(frozen=True)
class Turned:
    """Two points of a body, with the vectors found of them and the body's rates."""

    body: str
    points: tuple[str, str]
    facts: tuple[Fact, Fact]
    omega: float
    alpha: float


def list_component_checks(turned: Turned, level: Level, case: Case) -> Iterator[Check]:
    """The checks along both axes; none where a component has led to a vector, or no angle places
    one.
    """
    if any(fact.by_components for fact in turned.facts):
        return
    start, end = turned.points
    for axis in AXES:
        before, after = (_list_shares(fact, axis, case) for fact in turned.facts)
        if None in before or None in after:
            continue
        shares = chain(filter(None, before), _list_turning(turned, axis, level, case))
        left = Side(add_terms(filter(None, after)), double(turned.facts[1].value[PLACES[axis]]))
        way = Message(
            f"solution.component-check-{level}",
            axis=axis,
            first=case.naming.point(start),
            second=case.naming.point(end),
        )
        form = compare_points(turned.body, turned.points, turned.facts, _ALONG[axis], case)
        right = Side(add_terms(shares), left.value)
        yield compare(way, left, right, UNITS[level, False], form=form)


def _list_shares(fact: Fact, axis: AxisName, case: Case) -> Sequence[Formula | None]:
    """The magnitudes times cosines that make a component; None for what no angle places."""
    telling = (piece for piece in fact.parts if double(piece.value.squared()))
    return [one for piece in telling if (one := _find_share(piece, axis, case)) != ZERO]


def _find_share(piece: Piece, axis: AxisName, case: Case) -> Formula | None:
    heading, along = find_heading(piece, case), name_axis(_DIRECTIONS[axis])
    if heading is None or along is None:
        return None
    value = double(piece.value[PLACES[axis]])
    if not value:
        return ZERO
    size = measure(length(piece.value, case.arithmetic), piece.symbol.unit)
    cosine = find_cosine(heading, along)
    share = size if cosine is None else size.dot(cosine.state(True))
    return share.signed(1 if value > 0 else -1)


def _list_turning(turned: Turned, axis: AxisName, level: Level, case: Case) -> Iterator[Formula]:
    """What the rotation about the first point adds, its arms by coordinates."""
    start, end = (case.motion.points[point] for point in turned.points)
    across, sign = OTHER[axis], {"x": -1, "y": 1}[axis]
    match level:
        case "velocity":
            rate = turned.omega
        case "acceleration":
            rate = turned.alpha
            yield from _multiply(turned.omega, -1, axis, (start, end), squared=True)
        case _:
            assert_never(level)
    yield from _multiply(rate, sign, across, (start, end), squared=False, unit=UNITS[level, True])


def _multiply(
    rate: float,
    sign: int,
    axis: AxisName,
    ends: tuple[Vector, Vector],
    *,
    squared: bool,
    unit: str = "rad/s",
) -> Iterator[Formula]:
    """A rate, or its square, times the difference of two coordinates."""
    before, after = (measure(end[PLACES[axis]], "m") for end in ends)
    if not rate or before == after:
        return
    number = measure(abs(rate), unit)
    turning = number**TWO if squared else number
    signed = sign if squared or rate > 0 else -sign
    yield turning.dot(after - before).signed(signed)
