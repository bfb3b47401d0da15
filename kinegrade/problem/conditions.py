"""Conditions: the inequalities between givens that drawn values must fulfil, read from their text."""

from __future__ import annotations

import re

from kinegrade.angular import is_angle
from kinegrade.errors import ExpressionError
from kinegrade.expression import Number, read
from kinegrade.problem.template import Condition


def read_condition(text: str) -> Condition:
    """The inequality that `text` states. Raises ExpressionError when it states none."""
    parts = re.split(r"(<=?)", text)
    if len(parts) != 3:
        raise ExpressionError(f'"{text}": expected "left < right" or "left <= right"')
    return Condition(text, read(parts[0]), read(parts[2]), parts[1] == "<")


def mixed(condition: Condition, angles: frozenset[str]) -> bool:
    """Whether a condition holds an angle against a number other than zero."""
    sides = (condition.left, condition.right)
    zero = any(isinstance(side, Number) and side.value == 0 for side in sides)
    return not zero and is_angle(sides[0], angles) != is_angle(sides[1], angles)
