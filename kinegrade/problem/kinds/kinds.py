"""What an expression of a template gives: a number or a vector of some dimension, a line, a circle,
a body, a side.

It is known without any values. `meaning` finds it; `signatures` says what functions take and give.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import assert_never

from msgspec import Struct

from kinegrade.errors import FieldError
from kinegrade.language.message import Message, Part, Quoted, Text
from kinegrade.numbers.units import Unit
from kinegrade.problem.kinds.dimension import (
    LENGTH,
    NUMBER,
    Dimension,
    describe_dimension,
    find_dimension,
)


class Scalar(Struct, frozen=True):
    """A number or an angle. The dimension is None where only literals made it: they take any, as 2
    in `2 < omega`.
    """

    dimension: Dimension | None


class Arrow(Struct, frozen=True):
    """A point or a vector; its components have the dimension. `point` is its name where a point is
    named.
    """

    dimension: Dimension | None
    point: str = ""


class Straight(Struct, frozen=True):
    """A line."""


class Ring(Struct, frozen=True):
    """A circle."""


class BodyKind(Struct, frozen=True):
    """A body, by its name."""


class Side(Struct, frozen=True):
    """The name of one of two common points, such as upper."""


class Unknown(Struct, frozen=True):
    """The kind of an expression whose fault is reported elsewhere; it goes with everything."""


Kind = Scalar | Arrow | Straight | Ring | BodyKind | Side | Unknown


def describe_kind(kind: Kind) -> Message:
    """A kind for a message."""
    match kind:
        case Scalar(Dimension() as dimension):
            return describe_dimension(dimension)
        case Scalar():
            return Message("template.a-number")
        case Arrow(_, ""):
            return Message("template.a-vector")
        case Arrow():
            return Message("template.a-point")
        case Straight():
            return Message("template.a-line")
        case Ring():
            return Message("template.a-circle")
        case BodyKind():
            return Message("template.a-body")
        case Side():
            return Message("template.a-side")
        case Unknown():
            return Message("template.of-unknown-kind")
        case _:
            assert_never(kind)


def require_unit(kind: Kind, unit: Unit, listed: Callable[[Dimension], Text]) -> None:
    """Raises FieldError where a number cannot be counted in a unit; `listed` says of its dimension
    what to do.
    """
    found = kind.dimension if isinstance(kind, Scalar) else None
    if found is not None and found != find_dimension(unit):
        what = Message(
            "template.cannot-be-counted",
            dimension=describe_dimension(found),
            unit=Quoted(unit.text),
        )
        raise FieldError(what, do=listed(found))


def unite_dimensions(where: Part, *kinds: Kind) -> Dimension | None:
    """The one dimension of numbers and vectors that go together; None where all are literals or
    unknown.

    Raises FieldError where two differ; `where` says what brings them together.
    """
    found: Dimension | None = None
    for kind in kinds:
        dimension = kind.dimension if isinstance(kind, Scalar | Arrow) else None
        if dimension is None:
            continue
        if found is not None and dimension != found:
            first, second = describe_dimension(found), describe_dimension(dimension)
            what = Message("template.dimensions-apart", where=where, first=first, second=second)
            raise FieldError(what, do=advise_on_units(found, dimension))
        found = dimension
    return found


def advise_on_units(*dimensions: Dimension) -> Message:
    """What to do where two dimensions differ: a number of teeth is no length."""
    if {*dimensions} == {LENGTH, NUMBER}:
        return Message("template.make-length")
    return Message("template.check-units")
