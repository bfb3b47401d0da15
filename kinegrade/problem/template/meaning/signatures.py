"""What the functions of expressions take and give: by name, the kinds of their arguments and of
their value.

`expression.make_elementary_functions`, `mechanics.geometry`, `quantities` and `centrode` work them
out; a test holds the names here against theirs. The comments that begin with `#:` say what each
function gives; the reference of docs/ prints them.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Literal, assert_never

from kinegrade.problem.template.meaning.dimension import (
    ACCELERATION,
    CHANGE,
    LENGTH,
    NUMBER,
    RATE,
    SPEED,
    Dimension,
)
from kinegrade.problem.template.meaning.kinds import (
    Arrow,
    BodyKind,
    Kind,
    Ring,
    Scalar,
    Side,
    Straight,
    Unknown,
    unite_dimensions,
)

# A POINT is named, as its motion is meant; a PLACE may be worked out, and is written POINT to
# people as well.
PlainSlot = Literal[
    "NUMBER", "PLACE", "VECTOR", "LINE", "CIRCLE", "LINE|CIRCLE", "PLACE|LINE", "SIDE"
]
Slot = PlainSlot | Literal["RATIO", "ANGLE", "PLACE|ANGLE", "POINT", "BODY", "PARAMETER"]
Result = Callable[[str, Sequence[Kind]], Kind]


@dataclass(frozen=True)
class Signature:
    """The slots that a function's arguments fill, how many of them it needs, and the kind of its
    value.
    """

    slots: tuple[Slot, ...]
    needed: int
    result: Result

    def usage(self, name: str) -> str:
        """How the function is written: "velocity(POINT[, BODY])"."""
        slots = [slot.replace("PLACE", "POINT") for slot in self.slots]
        more = "".join(f"[, {slot}]" for slot in slots[self.needed :])
        return f"{name}({', '.join(slots[: self.needed])}{more})"


def _make_signature(*slots: Slot, gives: Result, optional: int = 0) -> Signature:
    """The signature of a function; the last `optional` slots may stay empty."""
    return Signature(slots, len(slots) - optional, gives)


def _scalar(dimension: Dimension) -> Result:
    """A number of that dimension."""
    return lambda name, kinds: Scalar(dimension)


def _vector(dimension: Dimension) -> Result:
    """A vector of that dimension."""
    return lambda name, kinds: Arrow(dimension)


def _joined(name: str, kinds: Sequence[Kind]) -> Kind:
    """A vector of the dimension that all arguments have, angles aside."""
    return Arrow(unite_dimensions(f"{name}(...)" if name else "(x, y)", *kinds))


def _apart(name: str, kinds: Sequence[Kind]) -> Kind:
    """A number of the dimension that all arguments have."""
    return Scalar(unite_dimensions(f"{name}(...)", *kinds))


def _polar(name: str, kinds: Sequence[Kind]) -> Kind:
    """The point at a distance from another one; the third argument is an angle."""
    return _joined(name, kinds[:2])


def _circle(name: str, kinds: Sequence[Kind]) -> Kind:
    """A circle, its radius of the dimension of its centre."""
    unite_dimensions(f"{name}(...)", *kinds)
    return Ring()


def _line(name: str, kinds: Sequence[Kind]) -> Kind:
    """A line."""
    return Straight()


def _first(name: str, kinds: Sequence[Kind]) -> Kind:
    """A number of the first argument's dimension."""
    kind = kinds[0]
    match kind:
        case Scalar(dimension) | Arrow(dimension):
            return Scalar(dimension)
        case Straight() | Ring() | BodyKind() | Side() | Unknown():
            return Unknown()
        case _:
            assert_never(kind)


def _same(name: str, kinds: Sequence[Kind]) -> Kind:
    """A vector of the first argument's dimension."""
    kind = kinds[0]
    match kind:
        case Arrow(dimension):
            return Arrow(dimension)
        case Scalar() | Straight() | Ring() | BodyKind() | Side() | Unknown():
            return Unknown()
        case _:
            assert_never(kind)


def _root(name: str, kinds: Sequence[Kind]) -> Kind:
    """A number of half the dimension."""
    kind = kinds[0]
    if not isinstance(kind, Scalar) or kind.dimension is None:
        return kind
    return Scalar(kind.dimension ** Fraction(1, 2))


def _ratio(name: str, kinds: Sequence[Kind]) -> Kind:
    """A pure number; of literals alone a literal."""
    unite_dimensions(f"{name}(...)", *kinds)
    literal = all(isinstance(kind, Scalar) and kind.dimension is None for kind in kinds)
    return Scalar(None) if literal else Scalar(NUMBER)


ELEMENTARY: Mapping[str, Signature] = {
    #: The square root.
    "sqrt": _make_signature("NUMBER", gives=_root),
    #: The absolute value.
    "abs": _make_signature("NUMBER", gives=_first),
    #: The sine of an angle.
    "sin": _make_signature("ANGLE", gives=_ratio),
    #: The cosine of an angle.
    "cos": _make_signature("ANGLE", gives=_ratio),
    #: The tangent of an angle.
    "tan": _make_signature("ANGLE", gives=_ratio),
    #: The angle between -pi/2 and pi/2 with that sine.
    "asin": _make_signature("RATIO", gives=_ratio),
    #: The angle between 0 and pi with that cosine.
    "acos": _make_signature("RATIO", gives=_ratio),
    #: The angle between -pi/2 and pi/2 with that tangent.
    "atan": _make_signature("RATIO", gives=_ratio),
    #: The direction of the vector (second, first), in (-pi, pi].
    "atan2": _make_signature("NUMBER", "NUMBER", gives=_ratio),
}
CONSTRUCTIONS: Mapping[str, Signature] = {
    **ELEMENTARY,
    #: The point or vector with these components.
    "": _make_signature("NUMBER", "NUMBER", gives=_joined),
    #: The point at a distance from another one, in the direction of an angle.
    "polar": _make_signature("PLACE", "NUMBER", "ANGLE", gives=_polar),
    #: The line through a point and another point, or in the direction of an angle.
    "line": _make_signature("PLACE", "PLACE|ANGLE", gives=_line),
    #: The circle about a point with a radius.
    "circle": _make_signature("PLACE", "NUMBER", gives=_circle),
    #: The common point of two lines; or, on the named side, that of a line and a circle or of two
    #: circles.
    "meet": _make_signature(
        "LINE|CIRCLE", "LINE|CIRCLE", "SIDE", gives=_vector(LENGTH), optional=1
    ),
    #: The foot of the perpendicular from a point to a line.
    "foot": _make_signature("PLACE", "LINE", gives=_same),
    #: The midpoint of two points.
    "midpoint": _make_signature("PLACE", "PLACE", gives=_joined),
    #: The distance of a point from another point or from a line.
    "distance": _make_signature("PLACE", "PLACE|LINE", gives=_apart),
    #: The point at a distance from the first point, towards the second or beyond it.
    "toward": _make_signature("PLACE", "PLACE", "NUMBER", gives=_joined),
    #: The component to the right.
    "x": _make_signature("VECTOR", gives=_first),
    #: The component upwards.
    "y": _make_signature("VECTOR", gives=_first),
    #: The vector turned counter-clockwise by a right angle.
    "turned": _make_signature("VECTOR", gives=_same),
    #: The angle of the vector from the first point to the second.
    "direction": _make_signature("PLACE", "PLACE", gives=_ratio),
}
QUANTITIES: Mapping[str, Signature] = {
    **CONSTRUCTIONS,
    #: The velocity of a point, of the body named where it belongs to several.
    "velocity": _make_signature("POINT", "BODY", gives=_vector(SPEED), optional=1),
    #: The acceleration of a point, in the same way.
    "acceleration": _make_signature("POINT", "BODY", gives=_vector(ACCELERATION), optional=1),
    #: The angular velocity of a body, or relative to a second body.
    "omega": _make_signature("BODY", "BODY", gives=_scalar(RATE), optional=1),
    #: The angular acceleration of a body, or relative to a second body.
    "alpha": _make_signature("BODY", "BODY", gives=_scalar(CHANGE), optional=1),
    #: The velocity of a point of the first body as seen from the second.
    "relative_velocity": _make_signature("POINT", "BODY", "BODY", gives=_vector(SPEED)),
    #: The acceleration of a point of the first body as seen from the second.
    "relative_acceleration": _make_signature("POINT", "BODY", "BODY", gives=_vector(ACCELERATION)),
    #: The Coriolis acceleration of a point of the first body, the moving frame being the second.
    "coriolis": _make_signature("POINT", "BODY", "BODY", gives=_vector(ACCELERATION)),
    #: The normal part of the acceleration of the first point relative to the second, both on the
    #: body.
    "normal_acceleration": _make_signature("POINT", "POINT", "BODY", gives=_vector(ACCELERATION)),
    #: The tangential part of the acceleration of the first point relative to the second, both on
    #: the body.
    "tangential_acceleration": _make_signature(
        "POINT", "POINT", "BODY", gives=_vector(ACCELERATION)
    ),
    #: The velocity pole (instantaneous centre) of a body.
    "pole": _make_signature("BODY", gives=_vector(LENGTH)),
    #: The length of a vector.
    "magnitude": _make_signature("VECTOR", gives=_first),
    #: The component of the first vector along the second.
    "along": _make_signature("VECTOR", "VECTOR", gives=_first),
    #: The angle from the first vector to the second, counter-clockwise, in (-pi, pi].
    "angle": _make_signature("VECTOR", "VECTOR", gives=_scalar(NUMBER)),
    #: The angle between two vectors, from 0 to pi.
    "between": _make_signature("VECTOR", "VECTOR", gives=_scalar(NUMBER)),
    #: The fixed centrode of a body while the parameter changes, where it is a circle.
    "circle_of_poles": _make_signature("BODY", "PARAMETER", gives=_circle),
    #: The radius of a circle.
    "radius": _make_signature("CIRCLE", gives=_scalar(LENGTH)),
    #: The centre of a circle.
    "centre": _make_signature("CIRCLE", gives=_vector(LENGTH)),
}
