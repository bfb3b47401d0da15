"""Conditions: relations between givens, which drawn values must fulfil or by which a text applies,
read from text.
"""

from __future__ import annotations

import re
from collections.abc import Mapping

from kinegrade.errors import FieldError
from kinegrade.expressions.angular import is_angle
from kinegrade.expressions.reading import read_expression
from kinegrade.expressions.tree import Number
from kinegrade.files.fields.values import found
from kinegrade.language.message import Message
from kinegrade.problem.template.template import Condition, Relation

_MARK = re.compile(r"([<>=]=?|!=)")
# Each mark with the relation it states, and whether the sides change places.
_RELATIONS: Mapping[str, tuple[Relation, bool]] = {
    "<": ("<", False),
    "<=": ("<=", False),
    ">": ("<", True),
    ">=": ("<=", True),
    "==": ("==", False),
    "!=": ("!=", False),
}


def read_condition(text: str) -> Condition:
    """The relation that `text` states. Raises FieldError when it states none.

    >>> read_condition("phi > 0").relation
    '<'
    """
    parts = _MARK.split(text)
    if len(parts) != 3 or parts[1] not in _RELATIONS:
        raise FieldError(found(text), Message("template.a-condition"))
    left, right = read_expression(parts[0]), read_expression(parts[2])
    relation, turned = _RELATIONS[parts[1]]
    if turned:
        left, right = right, left
    return Condition(text, left, right, relation)


def mixes_angle_and_number(condition: Condition, angles: frozenset[str]) -> bool:
    """Whether a condition compares an angle with a number other than zero."""
    sides = (condition.left, condition.right)
    zero = any(isinstance(side, Number) and side.value == 0 for side in sides)
    return not zero and is_angle(sides[0], angles) != is_angle(sides[1], angles)
