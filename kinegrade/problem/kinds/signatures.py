"""What the functions of expressions take and give: by name, the kinds of their arguments and of
their value.

`expression.make_elementary_functions`, `mechanics.geometry`, `quantities` and `centrode` work them
out; a test holds the names here against theirs. What each function gives is said by the entry
`words.function-NAME` of the catalogues.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import Literal, assert_never

from msgspec import Struct

from kinegrade.expressions.tree import SIDES_OF
from kinegrade.problem.kinds.dimension import (
    LENGTH,
    NUMBER,
    Dimension,
)
from kinegrade.problem.kinds.kinds import (
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


class Signature(Struct, frozen=True):
    """The slots that a function's arguments fill, how many of them it needs, the kind of its value,
    and a call of it that is shown.
    """

    slots: tuple[Slot, ...]
    needed: int
    result: Result
    example: str

    def usage(self, name: str) -> str:
        """How the function is written: "velocity(POINT[, BODY])", "left of POINT->POINT"."""
        slots = [slot.replace("PLACE", "POINT") for slot in self.slots]
        if name in SIDES_OF.values():
            return f"{name} {'->'.join(slots)}"
        more = "".join(f"[, {slot}]" for slot in slots[self.needed :])
        return f"{name}({', '.join(slots[: self.needed])}{more})"


def make_signature(*slots: Slot, gives: Result, example: str, optional: int = 0) -> Signature:
    """The signature of a function; the last `optional` slots may stay empty."""
    return Signature(slots, len(slots) - optional, gives, example)


def give_scalar(dimension: Dimension) -> Result:
    """A number of that dimension."""
    return lambda name, kinds: Scalar(dimension)


def give_vector(dimension: Dimension) -> Result:
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


def _side(name: str, kinds: Sequence[Kind]) -> Kind:
    """One of two common points."""
    return Side()


def give_first(name: str, kinds: Sequence[Kind]) -> Kind:
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
    "sqrt": make_signature("NUMBER", gives=_root, example="sqrt(l**2 - h**2)"),
    "abs": make_signature("NUMBER", gives=give_first, example="abs(omega)"),
    "sin": make_signature("ANGLE", gives=_ratio, example="sin(phi)"),
    "cos": make_signature("ANGLE", gives=_ratio, example="cos(phi + pi/2)"),
    "tan": make_signature("ANGLE", gives=_ratio, example="tan(phi)"),
    "asin": make_signature("RATIO", gives=_ratio, example="asin(r/l)"),
    "acos": make_signature("RATIO", gives=_ratio, example="acos(r/l)"),
    "atan": make_signature("RATIO", gives=_ratio, example="atan(h/b)"),
    "atan2": make_signature("NUMBER", "NUMBER", gives=_ratio, example="atan2(h, b)"),
}
_LEFT = "meet(circle(A, l), circle(D, m), left of A->D)"
_RIGHT = "meet(circle(A, l), circle(D, m), right of A->D)"
CONSTRUCTIONS: Mapping[str, Signature] = {
    **ELEMENTARY,
    "": make_signature("NUMBER", "NUMBER", gives=_joined, example="(b, -h)"),
    "polar": make_signature("PLACE", "NUMBER", "ANGLE", gives=_polar, example="polar(O, r, phi)"),
    "line": make_signature("PLACE", "PLACE|ANGLE", gives=_line, example="line(O, pi/2)"),
    "circle": make_signature("PLACE", "NUMBER", gives=_circle, example="circle(A, l)"),
    "meet": make_signature(
        "LINE|CIRCLE",
        "LINE|CIRCLE",
        "SIDE",
        gives=give_vector(LENGTH),
        optional=1,
        example="meet(circle(A, l), line(O, 0), right)",
    ),
    "foot": make_signature("PLACE", "LINE", gives=_same, example="foot(A, line(O, B))"),
    "midpoint": make_signature("PLACE", "PLACE", gives=_joined, example="midpoint(A, B)"),
    "distance": make_signature(
        "PLACE", "PLACE|LINE", gives=_apart, example="distance(A, line(O, B))"
    ),
    "toward": make_signature("PLACE", "PLACE", "NUMBER", gives=_joined, example="toward(A, B, l)"),
    "x": make_signature("VECTOR", gives=give_first, example="x(A)"),
    "y": make_signature("VECTOR", gives=give_first, example="y(velocity(B))"),
    "turned": make_signature("VECTOR", gives=_same, example="turned(B - A)"),
    "left of": make_signature("PLACE", "PLACE", gives=_side, example=_LEFT),
    "right of": make_signature("PLACE", "PLACE", gives=_side, example=_RIGHT),
    "direction": make_signature("PLACE", "PLACE", gives=_ratio, example="direction(O, A)"),
}
