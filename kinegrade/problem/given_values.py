"""The values of an instance's parameters, as texts and as numbers in SI."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from functools import lru_cache
from typing import Any

from kinegrade.errors import ExpressionError, Problem, TemplateError, suggest
from kinegrade.expressions.reading import read_expression
from kinegrade.expressions.tree import Expression
from kinegrade.language.lines import show_in_one_line
from kinegrade.language.message import Fault, Message, Quoted
from kinegrade.numbers.field import Field
from kinegrade.numbers.number import Arithmetic
from kinegrade.numbers.refusals import Inexact
from kinegrade.problem.assembling.parameters import read_parameter
from kinegrade.problem.template.template import Template


def read_values(template: Template, given: Mapping[str, str]) -> dict[str, Expression]:
    """The trees of all parameters' values. Raises TemplateError with every fault."""
    faults: list[Problem] = []
    trees: dict[str, Expression] = {}
    for name in given:
        if name not in template.parameters:
            hint = suggest(name, template.parameters)
            problem = Message("template.no-parameter", name=Quoted(name), hint=hint)
            faults.append(Fault(template.name, problem))
    for name, parameter in template.parameters.items():
        text = given.get(name, parameter.default)
        try:
            trees[name] = _read_cached(text)
        except ExpressionError as error:
            where = f"{template.name}: {name} = {show_in_one_line(text[:60])}"
            faults += error.faults_at(where)
    if faults:
        raise TemplateError(*faults)
    return trees


@lru_cache(maxsize=4096)
def _read_cached(text: str) -> Expression:
    """The tree of a value, read once: few values are drawn often. Raises ExpressionError."""
    return read_expression(text)


def find_parameter_values(
    template: Template, trees: Mapping[str, Expression], arithmetic: Arithmetic
) -> dict[str, Any]:
    """All parameters in SI. Raises TemplateError with every value that is no number (roots of
    negative numbers, unknown names), Inexact where the exact field does not hold them.
    """
    faults: list[Problem] = []
    values: dict[str, Any] = {}
    for name, parameter in template.parameters.items():
        try:
            values[name] = read_parameter(parameter, trees[name], arithmetic)
            if parameter.is_size and arithmetic.sign(values[name]) < 0:
                raise ExpressionError(Message("template.negative-length"))
        except ExpressionError as error:
            faults += error.faults_at(f"{template.name}: {name}")
    if faults:
        raise TemplateError(*faults)
    return values


def find_certain_values(
    template: Template, trees: Mapping[str, Expression], values: Mapping[str, Any]
) -> dict[str, Any]:
    """The parameters in SI, exact wherever they can be, although the instance is solved by
    balls.
    """
    found = dict(values)
    for name, parameter in template.parameters.items():
        with suppress(Inexact):
            found[name] = read_parameter(parameter, trees[name], Field())
    return found
