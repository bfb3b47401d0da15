"""Which kind and dimension a part of an expression must have, and what is at fault where it has
another.
"""

from __future__ import annotations

from typing import Literal

from kinegrade.errors import FieldError
from kinegrade.expressions.tree import Expression
from kinegrade.language.message import Message, Quoted, list_choices
from kinegrade.problem.kinds.dimension import NUMBER, Dimension, describe_dimension
from kinegrade.problem.kinds.kinds import (
    Arrow,
    Kind,
    Scalar,
    Unknown,
    advise_on_units,
    describe_kind,
)
from kinegrade.problem.template.meaning.meaning import Scope
from kinegrade.problem.template.meaning.radians import evaluate_literals

Having = Literal["coordinates", "velocity", "acceleration", "direction"]


def require_number(kind: Kind) -> Kind:
    """A kind that must be a number. Raises FieldError for anything else."""
    if not isinstance(kind, Scalar | Unknown):
        raise FieldError(describe_kind(kind), Message("template.a-number"))
    return kind


def require_dimension(kind: Kind, expected: Dimension, having: Having) -> None:
    """Raises FieldError where a kind has another dimension than is expected."""
    found = kind.dimension if isinstance(kind, Scalar | Arrow) else None
    if found is not None and found != expected:
        raise FieldError(
            Message(f"template.its-{having}", dimension=describe_dimension(found)),
            describe_dimension(expected),
            advise_on_units(found, expected),
        )


def require_no_number(scope: Scope, one: Expression, other: Expression) -> None:
    """Raises FieldError for a number other than zero that is added to what has a dimension."""
    number, kind = evaluate_literals(one), scope.kind(other)
    found = kind.dimension if isinstance(kind, Scalar) else None
    if number and found not in (None, NUMBER):
        what = Message(
            "template.added-number", number=str(number), dimension=describe_dimension(found)
        )
        raise FieldError(what, do=Message("template.added-with-unit"))


def list_units(found: Dimension) -> Message:
    """The units in SI that a dimension may be counted in."""
    units = ("rad", "deg", "1") if found == NUMBER else (found.unit,)
    return Message("template.write-unit", units=list_choices(map(Quoted, units)))
