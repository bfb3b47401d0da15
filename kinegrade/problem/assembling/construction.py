"""The named lengths and the points of a template, constructed one after another."""

from __future__ import annotations

from collections.abc import Callable, Container, Mapping
from dataclasses import dataclass
from typing import Any

from kinegrade.errors import ExpressionError
from kinegrade.expressions.evaluation import evaluate, make_elementary_functions
from kinegrade.language.message import Fault, Message
from kinegrade.mechanics.branches import BRANCHES
from kinegrade.mechanics.geometry import make_constructions
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.number import Arithmetic
from kinegrade.problem.assembling.measures import locate, require_bounded, require_measure
from kinegrade.problem.template.template import Template


@dataclass(frozen=True)
class Construction:
    """The points with the values (SI, radians) and functions that expressions may name."""

    values: dict[str, Any]
    functions: Mapping[str, Callable[..., Any]]
    points: dict[str, Vector]


def construct(
    template: Template,
    given: Mapping[str, Any],
    arithmetic: Arithmetic,
    until: Container[str] | None = None,
) -> Construction:
    """The named lengths and the points at `given` (parameters in SI); with `until`, no point after
    the last of these. Raises as `assemble`.
    """
    values: dict[str, Any] = {
        "pi": arithmetic.turns(1),
        **given,
        **{branch: branch for branch in BRANCHES},
    }
    points: dict[str, Vector] = {}
    functions = {**make_elementary_functions(arithmetic), **make_constructions(arithmetic, points)}
    for name, tree in template.scheme.lengths.items():
        values[name] = require_bounded(
            locate(f"lengths.{name}", evaluate, tree, values, functions, arithmetic)
        )
    for name in _list_points(template, until):
        tree = template.scheme.points[name]
        place = locate(f"points.{name}", evaluate, tree, values, functions, arithmetic)
        if not isinstance(place, Vector):
            raise ExpressionError(Fault(f"points.{name}", Message("template.point-expected")))
        points[name] = values[name] = locate(f"points.{name}", _measure_point, place)
    return Construction(values, functions, points)


def _list_points(template: Template, until: Container[str] | None) -> list[str]:
    """The names of the points in order, up to the last that is in `until`."""
    names = [*template.scheme.points]
    if until is None:
        return names
    last = max((place for place, name in enumerate(names, 1) if name in until), default=0)
    return names[:last]


def _measure_point(place: Vector) -> Vector:
    """A new point, distinct from any other at the same place; its coordinates as `require_measure`
    takes them.
    """
    return Vector(require_measure(place.x), require_measure(place.y))
