"""From a template and values to a mechanism: parameters into SI, points constructed, joints and
drivers made.

The same steps in any arithmetic: exact, balls, or arrays of floats over a whole class.
"""

from __future__ import annotations

from collections.abc import Callable, Container, Mapping
from dataclasses import dataclass
from typing import Any

from flint import fmpq

from kinegrade.errors import ExpressionError, KinegradeError, MechanismError
from kinegrade.expressions.angular import is_angle
from kinegrade.expressions.evaluation import evaluate, make_elementary_functions
from kinegrade.expressions.tree import Call, Expression, Name, find_names
from kinegrade.language.message import Fault, Message
from kinegrade.mechanics.branches import BRANCHES
from kinegrade.mechanics.drivers import Driver
from kinegrade.mechanics.geometry import Constructions, Round, make_constructions
from kinegrade.mechanics.joints import Circle, Joint, Line
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.sentence import DriverParts, JointParts
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.angle import Angle
from kinegrade.numbers.number import Arithmetic
from kinegrade.numbers.pi_multiple import PiMultiple
from kinegrade.numbers.refusals import Inexact
from kinegrade.numbers.surd import MAX_HEIGHT, Surd, height
from kinegrade.problem.template.sentences import DriverSentence, JointSentence
from kinegrade.problem.template.template import Parameter, Template


@dataclass(frozen=True)
class Assembly:
    """A mechanism with the values (SI, radians) that its expressions may name."""

    mechanism: Mechanism
    values: Mapping[str, Any]
    functions: Mapping[str, Callable[..., Any]]


def read_parameter(parameter: Parameter, tree: Expression, arithmetic: Arithmetic) -> Any:
    """A parameter in SI from an expression in its unit; degrees may also be given as an angle like
    atan(3/4).

    Raises ExpressionError for what is not a number, Inexact where no exact field contains it.
    """
    value = evaluate(
        tree, {"pi": arithmetic.turns(1)}, make_elementary_functions(arithmetic), arithmetic
    )
    angular = is_angle(tree, frozenset())
    if parameter.unit.degrees:
        return value if angular else arithmetic.turns(value / 180)
    if parameter.unit.text == "rad":
        return value if angular or not arithmetic.exact else _read_radians(value)
    if isinstance(value, Vector):
        raise ExpressionError(Message("template.number-expected"))
    if isinstance(value, Angle):
        raise Inexact  # a number with pi in it
    return value * arithmetic.scale(parameter.unit.scale)


def _read_radians(value: Any) -> Any:
    """A number of radians as an exact angle: only zero is one."""
    if value == 0:
        return Angle(value)
    raise Inexact  # a rational number of radians


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
        values[name] = _require_bounded(
            _locate(f"lengths.{name}", evaluate, tree, values, functions, arithmetic)
        )
    for name in _list_points(template, until):
        tree = template.scheme.points[name]
        place = _locate(f"points.{name}", evaluate, tree, values, functions, arithmetic)
        if not isinstance(place, Vector):
            raise ExpressionError(Fault(f"points.{name}", Message("template.point-expected")))
        points[name] = values[name] = _locate(f"points.{name}", _measure_point, place)
    return Construction(values, functions, points)


def _list_points(template: Template, until: Container[str] | None) -> list[str]:
    """The names of the points in order, up to the last that is in `until`."""
    names = [*template.scheme.points]
    if until is None:
        return names
    last = max((place for place, name in enumerate(names, 1) if name in until), default=0)
    return names[:last]


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
        values[name] = _locate(f"steps.{name}", _take_step, tree, values, functions, arithmetic)
    parts = _Parts(values, functions, points, arithmetic)
    joints = tuple(
        _locate(sentence.text, parts.joint, sentence) for sentence in template.scheme.joints
    )
    drivers = tuple(
        _locate(sentence.text, parts.driver, sentence) for sentence in template.scheme.drivers
    )
    return Assembly(Mechanism(points, template.scheme.bodies, joints, drivers), values, functions)


def _require_measure(value: Any) -> Any:
    """A coordinate, radius or rate, unchanged. Raises ExpressionError for what is not a number,
    Inexact for pi in it.
    """
    if isinstance(value, (Vector, Line, Round, str)):
        raise ExpressionError(Message("template.number-expected"))
    if isinstance(value, Angle):
        raise Inexact  # a length with pi in it
    return _require_bounded(value)


def _measure_point(place: Vector) -> Vector:
    """A new point, distinct from any other at the same place; its coordinates as `_require_measure`
    takes them.
    """
    return Vector(_require_measure(place.x), _require_measure(place.y))


def _require_bounded(value: Any) -> Any:
    """A value, unchanged. Raises Inexact for an exact number with far too many digits."""
    if isinstance(value, (fmpq, Surd, PiMultiple)) and height(value) > MAX_HEIGHT:
        raise Inexact  # a number of too many digits
    return value


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
        return _require_bounded(evaluate(tree, values, functions, arithmetic))
    except ExpressionError:
        angles = (isinstance(values.get(name), Angle) for name in find_names(tree))
        if arithmetic.exact and any(angles):
            raise Inexact from None
        raise


def _locate(place: str, make: Callable[..., Any], *arguments: Any) -> Any:
    """What `make` gives for its arguments; an error is reported with its place in the template."""
    try:
        return make(*arguments)
    except MechanismError as error:
        raise MechanismError(*error.faults_at(place)) from error
    except KinegradeError as error:
        raise ExpressionError(*error.faults_at(place)) from error


@dataclass(frozen=True)
class _Parts:
    """Makes joints and drivers from their sentences at an instance's values."""

    values: Mapping[str, Any]
    functions: Mapping[str, Callable[..., Any]]
    points: Mapping[str, Vector]
    arithmetic: Arithmetic

    def value(self, tree: Expression) -> Any:
        """The value of an expression, which may name points."""
        return evaluate(tree, self.values, self.functions, self.arithmetic)

    def shape(self, tree: Call | None) -> Any:
        """A line as a value, a circle with its centre by name; None where the sentence has no such
        shape.
        """
        if tree is None:
            return None
        if tree.function == "circle" and isinstance(tree.arguments[0], Name):
            return Circle(tree.arguments[0].name, _require_measure(self.value(tree.arguments[1])))
        line = self.value(tree)
        if not isinstance(line, Line):
            raise ExpressionError(Message("template.shape-expected"))
        return line

    def joint(self, sentence: JointSentence) -> Joint:
        """The joint that a sentence states."""
        parts = JointParts(
            sentence.point,
            sentence.body,
            sentence.of,
            sentence.bodies,
            self.shape(sentence.circle),
            self.shape(sentence.on),
            sentence.carrier,
            sentence.options,
        )
        return sentence.stated.make(parts)

    def driver(self, sentence: DriverSentence) -> Driver:
        """The driver that a sentence states."""
        parts = DriverParts(
            sentence.point,
            sentence.body,
            sentence.of,
            self.direction(sentence.along) if sentence.along is not None else Vector(0, 0),
            sentence.centre,
            _require_measure(self.value(sentence.velocity)),
            _require_measure(self.value(sentence.acceleration)),
        )
        return sentence.stated.make(parts)

    def direction(self, tree: Expression) -> Vector:
        """The unit vector of an angle. Raises ExpressionError for what is not an angle."""
        value = self.value(tree)
        if isinstance(value, (Vector, Line, Round, str)):
            raise ExpressionError(Message("template.direction-expected"))
        return Constructions(self.arithmetic, self.points).unit(value)


__all__ = ["Assembly", "assemble", "read_parameter"]
