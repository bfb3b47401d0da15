"""What a value of a template's expression may be, and where it is at fault."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from flint import fmpq

from kinegrade.errors import ExpressionError, KinegradeError, MechanismError
from kinegrade.language.message import Message
from kinegrade.mechanics.geometry import Round
from kinegrade.mechanics.joints import Line
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.angle import Angle
from kinegrade.numbers.pi_multiple import PiMultiple
from kinegrade.numbers.refusals import Inexact
from kinegrade.numbers.surd import MAX_HEIGHT, Surd, height


def require_measure(value: Any) -> Any:
    """A coordinate, radius or rate, unchanged. Raises ExpressionError for what is not a number,
    Inexact for pi in it.
    """
    if isinstance(value, (Vector, Line, Round, str)):
        raise ExpressionError(Message("template.number-expected"))
    if isinstance(value, Angle):
        raise Inexact  # a length with pi in it
    return require_bounded(value)


def require_bounded(value: Any) -> Any:
    """A value, unchanged. Raises Inexact for an exact number with far too many digits."""
    if isinstance(value, (fmpq, Surd, PiMultiple)) and height(value) > MAX_HEIGHT:
        raise Inexact  # a number of too many digits
    return value


def locate(place: str, make: Callable[..., Any], *arguments: Any) -> Any:
    """What `make` gives for its arguments; an error is reported with its place in the template."""
    try:
        return make(*arguments)
    except MechanismError as error:
        raise MechanismError(*error.faults_at(place)) from error
    except KinegradeError as error:
        raise ExpressionError(*error.faults_at(place)) from error
