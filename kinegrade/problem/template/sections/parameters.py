"""The table `[parameters]`: the quantities that are given, and what may be drawn for them."""

from __future__ import annotations

from kinegrade.expressions.reading import read_expression
from kinegrade.files.fields.table import Table
from kinegrade.numbers.units import Unit, read_unit
from kinegrade.problem.template.domain import read_choices
from kinegrade.problem.template.notation import write_symbol
from kinegrade.problem.template.sections.keys import PARAMETER
from kinegrade.problem.template.sections.values import present, written
from kinegrade.problem.template.template import Parameter
from kinegrade.problem.template.translations import translated

_LIKE = '{ unit = "m", draw = [1, 2] }'


def read_parameters(table: Table) -> dict[str, Parameter]:
    """The givens of a file that can be read, by name."""
    entries = table.table("parameters").each_table(_LIKE)
    return present({name: _read_parameter(name, entry) for name, entry in entries.items()})


def unit(value: object) -> Unit:
    """A unit, which may be 1 without quotation marks."""
    return read_unit(written(value))


def _read_parameter(name: str, table: Table) -> Parameter | None:
    entry = table.only(*PARAMETER)
    measured_in = entry.required("unit", unit)
    choices = entry.required("draw", read_choices)
    published = entry.optional("published", _read_value)
    means = entry.required("means", translated)
    label = entry.with_default("symbol", written, write_symbol(name))
    if measured_in is None or choices is None or means is None:
        return None
    return Parameter(name, label, measured_in, choices, published, means)


def _read_value(value: object) -> str:
    """The text of an expression."""
    text = written(value)
    read_expression(text)
    return text
