"""From a template and values to a mechanism: parameters into SI, points constructed, joints and
drivers made.

The same steps in any arithmetic: exact, balls, or arrays of floats over a whole class.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from kinegrade.errors import ExpressionError
from kinegrade.expressions.evaluation import evaluate
from kinegrade.expressions.tree import Expression, find_names
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.numbers.angle import Angle
from kinegrade.numbers.number import Arithmetic
from kinegrade.numbers.refusals import Inexact
from kinegrade.problem.assembling.construction import construct
from kinegrade.problem.assembling.measures import locate, require_bounded
from kinegrade.problem.assembling.parts import Parts
from kinegrade.problem.template.template import Template


@dataclass(frozen=True)
class Assembly:
    """A mechanism with the values (SI, radians) that its expressions may name."""

    mechanism: Mechanism
    values: Mapping[str, Any]
    functions: Mapping[str, Callable[..., Any]]


def assemble(
    template: Template,
    given: Mapping[str, Any],
    arithmetic: Arithmetic,
) -> Assembly:
    """The mechanism at `given` (parameters in SI). Raises MechanismError, ExpressionError with the
    place, Inexact.
    """
    built = construct(template, given, arithmetic)
    values, functions, points = built.values, built.functions, built.points
    for name, tree in template.scheme.steps.items():
        values[name] = locate(f"steps.{name}", _take_step, tree, values, functions, arithmetic)
    parts = Parts(values, functions, points, arithmetic)
    joints = tuple(
        locate(sentence.text, parts.joint, sentence) for sentence in template.scheme.joints
    )
    drivers = tuple(
        locate(sentence.text, parts.driver, sentence) for sentence in template.scheme.drivers
    )
    return Assembly(Mechanism(points, template.scheme.bodies, joints, drivers), values, functions)


def _take_step(
    tree: Expression,
    values: Mapping[str, Any],
    functions: Mapping[str, Callable[..., Any]],
    arithmetic: Arithmetic,
) -> Any:
    """The value of a step, an angle or a number. Raises Inexact where exact angles are added to
    numbers, which balls of radians can be.
    """
    try:
        return require_bounded(evaluate(tree, values, functions, arithmetic))
    except ExpressionError:
        angles = (isinstance(values.get(name), Angle) for name in find_names(tree))
        if arithmetic.exact and any(angles):
            raise Inexact from None
        raise
