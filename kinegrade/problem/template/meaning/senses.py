"""Whether the sign convention of an ask fits what is asked: a sense of rotation goes with rates of
rotation, a direction with components, and the quantity is positive where the convention says so.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import assert_never

from kinegrade.errors import FieldError
from kinegrade.expressions.tree import Call, Expression, Operation, is_literal_zero
from kinegrade.language.message import Message, Quoted, list_choices
from kinegrade.problem.kinds.dimension import find_dimension
from kinegrade.problem.template.template import Ask
from kinegrade.problem.template.translated import Translated
from kinegrade.sign_conventions import ALONG_AXES, SENSES, Convention

# What makes each function positive, and its negative
_POSITIVE: Mapping[str, tuple[Convention, Convention]] = {
    "omega": ("ccw", "cw"),
    "alpha": ("ccw", "cw"),
    "x": ("+x", "-x"),
    "y": ("+y", "-y"),
}


def require_fitting_sign(ask: Ask) -> None:
    """Raises FieldError for a sense or direction that the quantity cannot have.

    That a magnitude is never negative shows only when the instances are solved.
    """
    match ask.sign:
        case Translated() | "magnitude" | "unsigned" | "signed":
            return
        case "ccw" | "cw" | "+x" | "-x" | "+y" | "-y":
            plain, negated = _take_off_minus(ask.quantity)
            if isinstance(plain, Call) and plain.function in _POSITIVE:
                _require_positive(ask.sign, plain.function, negated=negated)
            else:
                _require_kind(ask.sign, ask)
        case _:
            assert_never(ask.sign)


def _take_off_minus(quantity: Expression) -> tuple[Expression, bool]:
    """A quantity without the minus before it, and whether there was one."""
    if isinstance(quantity, Operation) and quantity.sign == "-" and is_literal_zero(quantity):
        return quantity.right, True
    return quantity, False


def find_positive(ask: Ask) -> Convention | None:
    """The sense in which a plain rate or component counts as positive; None for any other."""
    plain, negated = _take_off_minus(ask.quantity)
    if not isinstance(plain, Call) or plain.function not in _POSITIVE:
        return None
    return _POSITIVE[plain.function][negated]


def _require_positive(sign: Convention, function: str, *, negated: bool) -> None:
    """Raises FieldError where a function, or its negative, counts in another sense."""
    fitting, opposite = _POSITIVE[function]
    if negated:
        fitting, opposite = opposite, fitting
    if sign == fitting:
        return
    stated, other = (f"{'-' if one else ''}{function}(...)" for one in (negated, not negated))
    way_out = Message("template.negate-quantity", sign=Quoted(sign), quantity=Quoted(other))
    raise FieldError(
        Message("template.sign-misfit", sign=Quoted(sign), quantity=stated),
        _list_signs(fitting),
        way_out if sign == opposite else "",
    )


def _require_kind(sign: Convention, ask: Ask) -> None:
    """Raises FieldError for a sense of rotation of what has a length in its unit, and for a
    direction along an axis of a rate of rotation.
    """
    dimension = find_dimension(ask.unit)
    turns = dimension.length == 0 and dimension.time != 0
    if (sign in SENSES and dimension.length != 0) or (sign in ALONG_AXES and turns):
        raise FieldError(
            Message("template.sign-misfit", sign=Quoted(sign), quantity=Quoted(ask.unit.text)),
            _list_signs(*(SENSES if turns else ALONG_AXES)),
        )


def _list_signs(*fitting: Convention) -> Message:
    return Message("fields.one-of", choices=list_choices(map(Quoted, (*fitting, "signed"))))
