"""The mechanism as written: lengths, points and bodies by name; joints, inputs and conditions by
their position in the file.
"""

from __future__ import annotations

from functools import partial

from kinegrade.errors import FieldError
from kinegrade.expressions.reading import read_expression
from kinegrade.expressions.tree import Expression
from kinegrade.files.fields.table import Table
from kinegrade.files.fields.values import found
from kinegrade.language.message import Message
from kinegrade.mechanics.mechanism import Body
from kinegrade.problem.template.conditions import read_condition
from kinegrade.problem.template.sections.keys import INPUT
from kinegrade.problem.template.sections.values import expression, present, words
from kinegrade.problem.template.sentences import (
    DriverSentence,
    JointSentence,
    read_driver,
    read_joint,
)
from kinegrade.problem.template.template import Condition

_LIKE_INPUT = '{ motion = "OA turns", velocity = "omega" }'
_NOTHING: Expression = read_expression("0")


def read_expressions(table: Table, key: str) -> dict[str, Expression]:
    """The named expressions of the table under a key that can be read, in order."""
    return table.table(key).entries(expression)


def read_bodies(table: Table) -> dict[str, Body]:
    """The bodies that can be read, by name."""
    entries = table.table("bodies")
    return present({name: entries.required(name, partial(_read_body, name)) for name in entries})


def read_joints(table: Table) -> dict[int, JointSentence]:
    """The joints that can be read, by their position in the file."""
    return table.numbered("joints", lambda value: read_joint(words(value)))


def read_conditions(table: Table) -> dict[int, Condition]:
    """The conditions that can be read, by their position in the file."""
    return table.numbered("conditions", lambda value: read_condition(words(value)))


def read_drivers(table: Table) -> dict[int, DriverSentence]:
    """The inputs that can be read, by their position in the file."""
    entries = table.tables("inputs", _LIKE_INPUT)
    return present({number: _read_driver(entry) for number, entry in enumerate(entries)})


def _read_body(name: str, value: object) -> Body:
    """A body with its marked points: "O A", or "particle M"."""
    match words(value).split():
        case ["particle", point]:
            return Body(name, (point,), particle=True)
        case [first, *others] if first != "particle":
            return Body(name, (first, *others))
        case _:
            raise FieldError(found(value), Message("template.body-points"))


def _read_driver(table: Table) -> DriverSentence | None:
    entry = table.only(*INPUT)
    velocity = entry.required("velocity", expression)
    acceleration = entry.with_default("acceleration", expression, _NOTHING)

    def driven(value: object) -> DriverSentence:
        return read_driver(words(value), velocity or _NOTHING, acceleration)

    driver = entry.required("motion", driven)
    return driver if velocity is not None else None
