"""A question with named steps in place of a mechanism, as an entry of a bank states it and an exam
keeps it in a file of its own.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping

from kinegrade.expressions.angular import turns_round
from kinegrade.expressions.tree import Expression, Name
from kinegrade.files.fields.table import Table
from kinegrade.files.fields.values import flag
from kinegrade.language.message import Message
from kinegrade.problem.template.domain import read_choices
from kinegrade.problem.template.draft import Draft
from kinegrade.problem.template.hints import FigureHints
from kinegrade.problem.template.meaning.consistency import note_inconsistencies
from kinegrade.problem.template.notation import write_symbol
from kinegrade.problem.template.sections.asks import read_sign
from kinegrade.problem.template.sections.names import check_names, declared_names
from kinegrade.problem.template.sections.parameters import unit
from kinegrade.problem.template.sections.scheme import read_conditions, read_expressions
from kinegrade.problem.template.sections.stepwise_keys import (
    STEPWISE,
    STEPWISE_ASK,
    STEPWISE_MISTAKE,
    STEPWISE_PARAMETER,
)
from kinegrade.problem.template.sections.uses import check_uses
from kinegrade.problem.template.sections.values import expression, present, written
from kinegrade.problem.template.signs import Sign
from kinegrade.problem.template.template import (
    About,
    Ask,
    NamedMistake,
    Parameter,
    Template,
    TemplateFile,
)
from kinegrade.problem.template.translated import Translated
from kinegrade.problem.template.translations import translated

_BLANK = Translated(plain="")
_IDENTIFIER = re.compile(r"[a-z][a-z0-9]*(-[a-z0-9]+)*", re.ASCII)
_MOST_STEPS = 40
_LIKE_GIVEN = '{ unit = "s", draw = [4, 5, 6] }'
_LIKE_ASK = '{ unit = "m/s", points = 3, means = "..." }'
_LIKE_MISTAKE = '{ steps.s = "v*t", means = "..." }'


def read_stepwise(
    name: str, table: Table, file: TemplateFile, *, kept: bool = False
) -> Template | None:
    """The question that a table states, which goes by that name; what is wrong is noted in the
    table's faults. None where it lacks what every question has.

    One that is `kept` with an exam is read without a look at dimensions.
    """
    known = table.only(*STEPWISE)
    draft = _read_draft(known)
    check_uses(draft, table.faults)
    if not kept:
        note_inconsistencies(draft, table.faults)
    return draft.template(name, file) if draft.steps and draft.asks else None


def _read_draft(table: Table) -> Draft:
    declared = declared_names(table)
    check_names(table, declared)
    parameters, steps = _read_parameters(table), read_expressions(table, "steps")
    _require_some(table, len(declared["steps"]))
    read = {*parameters, *steps}
    return Draft(
        about=About(table.with_default("title", translated, _BLANK), family="", source=""),
        statement=table.required("statement", translated),
        texts={},
        parameters=parameters,
        lengths={},
        reasons={},
        points={},
        bodies={},
        joints={},
        drivers={},
        conditions=read_conditions(table),
        asks=_read_asks(table, declared["steps"], _list_angles(steps)),
        published={},
        figure=FigureHints(),
        faulty=frozenset((*declared["parameters"], *declared["steps"])) - read,
        steps=steps,
        mistakes=_read_mistakes(table, declared["steps"]),
    )


def _require_some(table: Table, count: int) -> None:
    """A fault where nothing is given, found or asked, or far too much is to be found."""
    expected = Message("template.steps-at-most", most=_MOST_STEPS)
    if table.holds_table("steps") and count > _MOST_STEPS:
        table.fault("steps", Message("template.steps", count=count), expected)
    for key in ("parameters", "steps", "asks"):
        if not table.value(key):
            table.missing(key, Message("template.in-every-stepwise"))


def _read_parameters(table: Table) -> dict[str, Parameter]:
    """The givens that can be read, by name."""
    entries = table.table("parameters").each_table(_LIKE_GIVEN)
    return present({name: _read_parameter(name, entry) for name, entry in entries.items()})


def _read_parameter(name: str, table: Table) -> Parameter | None:
    entry = table.only(*STEPWISE_PARAMETER)
    measured_in = entry.required("unit", unit)
    choices = entry.required("draw", read_choices)
    label = entry.with_default("symbol", written, write_symbol(name))
    if measured_in is None or choices is None:
        return None
    return Parameter(name, label, measured_in, choices, None, _BLANK)


def _list_angles(steps: Mapping[str, Expression]) -> Collection[str]:
    """The steps that are angles of positions, or such with others added."""
    angles: set[str] = set()
    for name, tree in steps.items():
        if turns_round(tree, angles):
            angles.add(name)
    return angles


def _read_asks(table: Table, steps: Collection[str], angles: Collection[str]) -> dict[str, Ask]:
    """The steps that are asked for and can be read, by name; `angles` are right with full turns
    more or less where nothing is said.
    """
    asked = table.table("asks").only(*steps, unknown=Message("template.no-step"))
    entries = asked.each_table(_LIKE_ASK)
    return present({name: _read_ask(name, entry, angles) for name, entry in entries.items()})


def _read_ask(name: str, table: Table, angles: Collection[str]) -> Ask | None:
    entry = table.only(*STEPWISE_ASK)
    counted_in = entry.required("unit", unit)
    means = entry.required("means", translated)
    label = entry.with_default("symbol", written, write_symbol(name))
    sign: Sign = entry.optional("sign", read_sign) or "magnitude"
    cyclic = entry.with_default("cyclic", flag, name in angles)
    if counted_in is None or means is None:
        return None
    return Ask(
        name, label, Name(name), counted_in, means, sign, points=0, vanishes=False, cyclic=cyclic
    )


def _read_mistakes(table: Table, steps: Collection[str]) -> dict[str, NamedMistake]:
    """The mistakes that can be read, by identifier."""
    entries = table.table("mistakes").each_table(_LIKE_MISTAKE)
    read = {name: _read_mistake(name, entry, steps) for name, entry in entries.items()}
    for name in read:
        if not _IDENTIFIER.fullmatch(name):
            what = Message("template.not-a-name")
            table.faults.note(("mistakes", name), what, Message("template.a-mistake-name"))
    return present(read)


def _read_mistake(name: str, table: Table, steps: Collection[str]) -> NamedMistake | None:
    entry = table.only(*STEPWISE_MISTAKE)
    means = entry.required("means", translated)
    unknown = Message("template.no-step")
    taken = entry.table("steps").only(*steps, unknown=unknown).entries(expression)
    if not entry.value("steps"):
        entry.missing("steps", Message("template.mistaken-steps"))
    return NamedMistake(name, taken, means) if means is not None and taken else None
