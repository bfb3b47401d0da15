"""What the functions of expressions take and give: by name, the kinds of their arguments and of
their value.

`expression.elementary`, `mechanics.geometry`, `quantities` and `centrode` work them out; a test
holds the names here against theirs.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Literal, assert_never

from kinegrade.problem.dimension import (
    ACCELERATION,
    CHANGE,
    LENGTH,
    NUMBER,
    RATE,
    SPEED,
    Dimension,
)
from kinegrade.problem.kinds import (
    Arrow,
    BodyKind,
    Kind,
    Ring,
    Scalar,
    Side,
    Straight,
    Unknown,
    united,
)

# A POINT is named, as its motion is meant; a PLACE may be worked out, and is written POINT to
# people as well.
PlainSlot = Literal[
    "NUMBER", "PLACE", "VECTOR", "LINE", "CIRCLE", "LINE or CIRCLE", "PLACE or LINE", "SIDE"
]
Slot = PlainSlot | Literal["RATIO", "ANGLE", "PLACE or ANGLE", "POINT", "BODY", "PARAMETER"]
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


def takes(*slots: Slot, gives: Result, optional: int = 0) -> Signature:
    """The signature of a function; the last `optional` slots may stay empty."""
    return Signature(slots, len(slots) - optional, gives)


def scalar(dimension: Dimension) -> Result:
    """A number of that dimension."""
    return lambda name, kinds: Scalar(dimension)


def vector(dimension: Dimension) -> Result:
    """A vector of that dimension."""
    return lambda name, kinds: Arrow(dimension)


def joined(name: str, kinds: Sequence[Kind]) -> Kind:
    """A vector of the dimension that all arguments have, angles aside."""
    return Arrow(united(f"{name}(...)" if name else "(x, y)", *kinds))


def apart(name: str, kinds: Sequence[Kind]) -> Kind:
    """A number of the dimension that all arguments have."""
    return Scalar(united(f"{name}(...)", *kinds))


def polar(name: str, kinds: Sequence[Kind]) -> Kind:
    """The point at a distance from another one; the third argument is an angle."""
    return joined(name, kinds[:2])


def circle(name: str, kinds: Sequence[Kind]) -> Kind:
    """A circle, its radius of the dimension of its centre."""
    united(f"{name}(...)", *kinds)
    return Ring()


def line(name: str, kinds: Sequence[Kind]) -> Kind:
    """A line."""
    return Straight()


def first(name: str, kinds: Sequence[Kind]) -> Kind:
    """A number of the first argument's dimension."""
    kind = kinds[0]
    match kind:
        case Scalar(dimension) | Arrow(dimension):
            return Scalar(dimension)
        case Straight() | Ring() | BodyKind() | Side() | Unknown():
            return Unknown()
        case _:
            assert_never(kind)


def same(name: str, kinds: Sequence[Kind]) -> Kind:
    """A vector of the first argument's dimension."""
    kind = kinds[0]
    match kind:
        case Arrow(dimension):
            return Arrow(dimension)
        case Scalar() | Straight() | Ring() | BodyKind() | Side() | Unknown():
            return Unknown()
        case _:
            assert_never(kind)


def root(name: str, kinds: Sequence[Kind]) -> Kind:
    """A number of half the dimension."""
    kind = kinds[0]
    if not isinstance(kind, Scalar) or kind.dimension is None:
        return kind
    return Scalar(kind.dimension ** Fraction(1, 2))


def ratio(name: str, kinds: Sequence[Kind]) -> Kind:
    """A pure number; of literals alone a literal."""
    united(f"{name}(...)", *kinds)
    literal = all(isinstance(kind, Scalar) and kind.dimension is None for kind in kinds)
    return Scalar(None) if literal else Scalar(NUMBER)


ELEMENTARY: Mapping[str, Signature] = {
    "sqrt": takes("NUMBER", gives=root),
    "abs": takes("NUMBER", gives=first),
    "sin": takes("ANGLE", gives=ratio),
    "cos": takes("ANGLE", gives=ratio),
    "tan": takes("ANGLE", gives=ratio),
    "asin": takes("RATIO", gives=ratio),
    "acos": takes("RATIO", gives=ratio),
    "atan": takes("RATIO", gives=ratio),
    "atan2": takes("NUMBER", "NUMBER", gives=ratio),
}
CONSTRUCTIONS: Mapping[str, Signature] = {
    **ELEMENTARY,
    "": takes("NUMBER", "NUMBER", gives=joined),
    "polar": takes("PLACE", "NUMBER", "ANGLE", gives=polar),
    "line": takes("PLACE", "PLACE or ANGLE", gives=line),
    "circle": takes("PLACE", "NUMBER", gives=circle),
    "meet": takes("LINE or CIRCLE", "LINE or CIRCLE", "SIDE", gives=vector(LENGTH), optional=1),
    "foot": takes("PLACE", "LINE", gives=same),
    "midpoint": takes("PLACE", "PLACE", gives=joined),
    "distance": takes("PLACE", "PLACE or LINE", gives=apart),
    "toward": takes("PLACE", "PLACE", "NUMBER", gives=joined),
    "x": takes("VECTOR", gives=first),
    "y": takes("VECTOR", gives=first),
    "turned": takes("VECTOR", gives=same),
    "direction": takes("PLACE", "PLACE", gives=ratio),
}
QUANTITIES: Mapping[str, Signature] = {
    **CONSTRUCTIONS,
    "velocity": takes("POINT", "BODY", gives=vector(SPEED), optional=1),
    "acceleration": takes("POINT", "BODY", gives=vector(ACCELERATION), optional=1),
    "omega": takes("BODY", "BODY", gives=scalar(RATE), optional=1),
    "alpha": takes("BODY", "BODY", gives=scalar(CHANGE), optional=1),
    "relative_velocity": takes("POINT", "BODY", "BODY", gives=vector(SPEED)),
    "relative_acceleration": takes("POINT", "BODY", "BODY", gives=vector(ACCELERATION)),
    "coriolis": takes("POINT", "BODY", "BODY", gives=vector(ACCELERATION)),
    "normal_acceleration": takes("POINT", "POINT", "BODY", gives=vector(ACCELERATION)),
    "tangential_acceleration": takes("POINT", "POINT", "BODY", gives=vector(ACCELERATION)),
    "pole": takes("BODY", gives=vector(LENGTH)),
    "magnitude": takes("VECTOR", gives=first),
    "along": takes("VECTOR", "VECTOR", gives=first),
    "angle": takes("VECTOR", "VECTOR", gives=scalar(NUMBER)),
    "between": takes("VECTOR", "VECTOR", gives=scalar(NUMBER)),
    "circle_of_poles": takes("BODY", "PARAMETER", gives=circle),
    "radius": takes("CIRCLE", gives=scalar(LENGTH)),
    "centre": takes("CIRCLE", gives=vector(LENGTH)),
}
