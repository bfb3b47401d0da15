"""The statement of an instance: the template's text with this student's numbers in it.

Statements are Markdown with LaTeX math between dollar signs. `{{ r }}` becomes `$r = 0.25\\,\\unit{m}$`,
`{{ r.value }}` the number with its unit alone. Nothing else of Jinja is allowed: a template from a stranger can
print its parameters and no more.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache

from jinja2 import StrictUndefined, TemplateSyntaxError, UndefinedError, nodes
from jinja2 import Template as JinjaTemplate
from jinja2.sandbox import SandboxedEnvironment

from kinegrade.errors import TemplateError
from kinegrade.exact.angle import Angle
from kinegrade.exact.text import LATEX, angle_text
from kinegrade.language import LANGUAGES, Language
from kinegrade.problem.quantity import Quantity
from kinegrade.problem.template import Template

ALLOWED = (nodes.Template, nodes.Output, nodes.TemplateData, nodes.Name, nodes.Getattr)
ENVIRONMENT = SandboxedEnvironment(
    undefined=StrictUndefined, autoescape=False, keep_trailing_newline=False
)


@dataclass(frozen=True)
class Given:
    """A parameter as a statement prints it."""

    symbol: str
    text: str

    @property
    def value(self) -> str:
        """The number with its unit, without the symbol."""
        return f"${self.text}$"

    def __str__(self) -> str:
        return f"${self.symbol} = {self.text}$"


def with_unit(quantity: Quantity) -> str:
    """A quantity in LaTeX math: number and upright unit."""
    unit = quantity.measure
    if isinstance(quantity.number, Angle) and quantity.number.parts:
        return angle_text(quantity.number, degrees=False, form=LATEX)
    if unit.degrees:
        return f"{quantity.given_text}^\\circ"
    return (
        quantity.given_text if unit.text == "1" else rf"{quantity.given_text}\,\unit{{{unit.text}}}"
    )


def statement(template: Template, parameters: Mapping[str, Quantity], language: Language) -> str:
    """The statement in one language at these parameters. Raises TemplateError for what is not allowed."""
    givens = {
        name: Given(template.parameters[name].symbol, with_unit(quantity))
        for name, quantity in parameters.items()
    }
    text = template.statement.in_language(language)
    try:
        return prepared(text).render(givens)
    except (TemplateSyntaxError, UndefinedError) as error:
        raise TemplateError(
            f"{template.name}.toml: statement.{language}: {error.message}"
        ) from error


@lru_cache(maxsize=256)
def prepared(text: str) -> JinjaTemplate:
    """A statement's text read once; raises TemplateSyntaxError."""
    return ENVIRONMENT.from_string(text)


def check_statements(template: Template) -> None:
    """Raises TemplateError for statements that do more than print parameters, or that leave one out."""
    faults: list[str] = []
    for language in LANGUAGES:
        faults += statement_faults(template, language)
    if faults:
        raise TemplateError(*faults)


def statement_faults(template: Template, language: Language) -> list[str]:
    """What is wrong with a statement."""
    where = f"{template.name}.toml: statement.{language}"
    try:
        tree = ENVIRONMENT.parse(template.statement.in_language(language))
    except (TemplateSyntaxError, RecursionError) as error:
        return [
            f"{where}: {getattr(error, 'message', 'nested too deeply')}: only {{{{ parameter }}}} is filled in"
        ]
    strange = sorted({kind for node in tree.find_all(nodes.Node) if (kind := forbidden(node))})
    named = {node.name for node in tree.find_all(nodes.Name)}
    faults = [
        f"{where}: {kind}: only {{{{ parameter }}}} and {{{{ parameter.value }}}} are filled in"
        for kind in strange
    ]
    faults += [
        f"{where}: {{{{ {name} }}}}: no such parameter"
        for name in sorted(named - set(template.parameters))
    ]
    faults += [
        f"{where}: the parameter {name} is not given to the student: write {{{{ {name} }}}}"
        for name in template.parameters
        if name not in named
    ]
    return faults


def forbidden(node: nodes.Node) -> str:
    """What of Jinja a node is that statements may not use; "" for what they may."""
    if isinstance(node, nodes.Getattr) and not (
        node.attr == "value" and isinstance(node.node, nodes.Name)
    ):
        return f"attribute .{node.attr}"
    return "" if isinstance(node, ALLOWED) else type(node).__name__
