"""Checks of two points of a body along an axis: where angles place their vectors, the rotation
makes the difference of the components.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from kinegrade.language.message import Message
from kinegrade.mechanics.rates import make_turning
from kinegrade.mechanics.relations.terms import Term
from kinegrade.mechanics.vector import AxisName, Vector
from kinegrade.mechanics.vector_equation import Level
from kinegrade.worked.case import Case
from kinegrade.worked.checks.check import Check, compare
from kinegrade.worked.checks.forms import compare_points
from kinegrade.worked.checks.sides import make_side
from kinegrade.worked.coincident_points import name_owned_point
from kinegrade.worked.findings import Fact
from kinegrade.worked.formulas.atoms import AXES
from kinegrade.worked.formulas.measures import double, is_zero
from kinegrade.worked.vectors.components import (
    find_heading,
    list_component,
    list_turning_summands,
)
from kinegrade.worked.vectors.summands import PLACES
from kinegrade.worked.vectors.vectors import UNITS

_ALONG: dict[AxisName, Vector] = {"x": Vector(1, 0), "y": Vector(0, 1)}


@dataclass(frozen=True)
class Turned:
    """Two points of a body, with the vectors found of them."""

    body: str
    points: tuple[str, str]
    facts: tuple[Fact, Fact]


def list_component_checks(turned: Turned, level: Level, case: Case) -> Iterator[Check]:
    """The checks along both axes; none where a component has led to a vector, or no angle places
    one.
    """
    if not all(_is_placed(fact, case) for fact in turned.facts):
        return
    start, end = turned.points
    points = case.motion.points
    rate = make_turning(turned.body)
    rotation = Term("rotation", rate, points[end] - points[start], end, start)
    for axis in AXES:
        before, after = (list(list_component(fact, axis, case)) for fact in turned.facts)
        before += list_turning_summands(axis, rotation, case, level)
        value = double(turned.facts[1].value[PLACES[axis]])
        first, second = (
            name_owned_point(point, turned.body, fact.symbol, case)
            for point, fact in zip(turned.points, turned.facts, strict=True)
        )
        kind = f"solution.component-check-{level}"
        way = Message(kind, axis=axis, first=first, second=second)
        form = compare_points(turned.body, turned.points, turned.facts, _ALONG[axis], case)
        sides = make_side(after, value), make_side(before, value)
        yield compare(way, *sides, UNITS[level, False], form=form)


def _is_placed(fact: Fact, case: Case) -> bool:
    """Whether a vector is known by magnitudes whose directions angles give."""
    pieces = (piece for piece in fact.parts if not is_zero(piece.value))
    return not fact.by_components and all(find_heading(piece, case) for piece in pieces)
