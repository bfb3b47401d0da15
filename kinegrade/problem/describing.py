"""What `kinegrade show` prints of a template."""

from __future__ import annotations

from collections.abc import Iterator

from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.message import Message
from kinegrade.problem.solving import solve_template
from kinegrade.problem.statement import write_statement
from kinegrade.problem.statement_faults import check_statements
from kinegrade.problem.template.signs import write_sign
from kinegrade.problem.template.template import Ask, Parameter, Template


def describe_template(template: Template, language: Language) -> str:
    """A template in words: title, statement at its default values, parameters, asks and how many
    instances.
    """
    return "\n".join(_write_lines(template, language))


def _write_lines(template: Template, language: Language) -> Iterator[str]:
    """The lines of the description."""
    check_statements(template)
    solution = solve_template(template, {})
    yield f"{template.name}: {template.about.title.in_language(language)}"
    words = open_catalogue(language)
    about = template.about
    yield words.text("template.shown-origin", family=about.family, source=about.source)
    yield words.text("template.shown-combinations", number=template.combinations)
    yield ""
    yield write_statement(template, solution.parameters, language)
    yield words.text("template.shown-parameters")
    for name, parameter in template.parameters.items():
        means = parameter.means.in_language(language)
        yield f"  {name:<12} {parameter.unit.printed:<7} {_write_domain(parameter):<34} {means}"
    yield words.text("template.shown-asks")
    for name, ask in template.asks.items():
        points = words.write(_describe_points(ask))
        sign = write_sign(ask.sign, language)
        yield (
            f"  {name:<12} {ask.unit.printed:<7} {points:<11} {ask.means.in_language(language)} "
            f"({sign})"
        )


def _describe_points(ask: Ask) -> Message:
    if ask.points:
        return Message("template.shown-points", count=ask.points)
    return Message("template.shown-on-request")


def _write_domain(parameter: Parameter) -> str:
    """What may be drawn, in short."""
    choices = parameter.choices
    shown = (
        ", ".join(choices)
        if len(choices) <= 6
        else f"{choices[0]}, {choices[1]}, ... {choices[-1]}"
    )
    return f"{shown} ({len(choices)})"
