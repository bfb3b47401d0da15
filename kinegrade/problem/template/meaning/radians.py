"""Plain numbers in place of angles: `polar(O, r, 60)` is 60 radians where its author meant 60
degrees.
"""

from __future__ import annotations

from typing import Any, assert_never

from kinegrade.errors import FieldError
from kinegrade.expressions.tree import Call, Expression, Name, Number, Operation, Operator
from kinegrade.language.message import Message


def require_no_radians(tree: Expression) -> None:
    """Raises FieldError for an angle that is written as a number other than zero, without pi.

    An angle of so many radians can be had as a parameter whose unit is rad.
    """
    value = evaluate_literals(tree)
    if value is None or value == 0:
        return
    count = abs(int(value)) if value.q == 1 else 0
    degrees, written = str(value), _write_parts_of_pi(value)
    raise FieldError(
        Message("template.radians", count=count, radians=degrees),
        do=Message("template.meant-degrees", count=count, degrees=degrees, written=written),
    )


def evaluate_literals(tree: Expression) -> Any:
    """The rational that literals alone make; None for anything else."""
    match tree:
        case Number(value):
            return value
        case Name() | Call():
            return None
        case Operation(sign, left, right):
            return _apply_sign(sign, evaluate_literals(left), evaluate_literals(right))
        case _:
            assert_never(tree)


def _apply_sign(sign: Operator, left: Any, right: Any) -> Any:
    """left sign right of two rationals; None where one is missing or the sign is no such
    operation.
    """
    if left is None or right is None or (sign == "/" and right == 0):
        return None
    match sign:
        case "+":
            return left + right
        case "-":
            return left - right
        case "*":
            return left * right
        case "/":
            return left / right
        case "**":
            return None
        case _:
            assert_never(sign)


def _write_parts_of_pi(degrees: Any) -> str:
    """An angle in degrees as a part of pi.

    >>> from flint import fmpq
    >>> _write_parts_of_pi(fmpq(60)), _write_parts_of_pi(fmpq(-37)), _write_parts_of_pi(fmpq(180))
    ('pi/3', '-37*pi/180', 'pi')
    """
    share = degrees / 180
    sign = "-" if share < 0 else ""
    top = "pi" if abs(share.p) == 1 else f"{abs(share.p)}*pi"
    return f"{sign}{top}" if share.q == 1 else f"{sign}{top}/{share.q}"
