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
from kinegrade.language.catalogue import FORM_SEPARATOR, open_catalogue
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
from kinegrade.problem.template.translated import Translated
from kinegrade.problem.template.translations import translated

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


def read_body_names(table: Table) -> dict[str, Translated]:
    """What bodies are called, by their names in the file."""
    entries = table.table("bodies")
    named = {name: value for name, value in entries.content.items() if isinstance(value, dict)}
    called = {name: value["called"] for name, value in named.items() if value.get("called")}
    return present({name: entries.required(name, _read_called) for name in called})


def _read_called(value: object) -> Translated:
    """A name, or in a language whose nouns change, one that has all forms in their order."""
    called = translated(value["called"]) if isinstance(value, dict) else Translated()
    for language, name in called.by_language:
        forms, known = name.split(FORM_SEPARATOR), open_catalogue(language).forms
        if not all(each.strip() for each in forms) or len(forms) not in {1, len(known)}:
            expected = Message("template.forms-of-noun", forms=FORM_SEPARATOR.join(known))
            raise FieldError(found(name), expected)
    return called


def _read_body(name: str, value: object) -> Body:
    """A body with its marked points: "O A", or "particle M"; beside its name where it has one."""
    if isinstance(value, dict):
        if not {"points"} <= value.keys() <= {"points", "called"}:
            raise FieldError(found(value), Message("template.body-points"))
        value = value["points"]
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
