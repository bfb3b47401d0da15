"""The command that solves a template: solve."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

import kinegrade
from kinegrade.cli.help import command
from kinegrade.cli.options import (
    CYCLE,
    FORCE,
    LANGUAGE,
    LARGE_PRINT,
    METHOD,
    OPTIONAL_OUTPUT,
    refusing,
)
from kinegrade.cli.terminal import terminal_words
from kinegrade.errors import TemplateError
from kinegrade.language.message import Fault, Message, Quoted

if TYPE_CHECKING:
    from kinegrade.language import Language
    from kinegrade.language.catalogue import Catalogue
    from kinegrade.problem.quantity import Quantity
    from kinegrade.problem.solution import Solution
    from kinegrade.problem.template.template import Method

_ALL = "all"
_LONGEST = 30  # characters of an exact form that is read beside its decimal
SETTINGS = click.option(
    "--set",
    "settings",
    multiple=True,
    metavar="NAME=VALUE",
)
ASKS = click.option(
    "--asks",
    "asked",
    metavar="all|NAME,...",
)


@command()
@click.argument("template_name", metavar="TEMPLATE")
@SETTINGS
@ASKS
@click.option(
    "--json",
    "as_json",
    is_flag=True,
)
@click.option(
    "--exact",
    "whole",
    is_flag=True,
)
@OPTIONAL_OUTPUT
@METHOD
@CYCLE
@LARGE_PRINT
@LANGUAGE
@FORCE
@refusing
def solve(
    *,
    template_name: str,
    settings: tuple[str, ...],
    asked: str | None,
    as_json: bool,
    whole: bool,
    output: Path | None,
    method: Method | None,
    cycle: bool,
    large_print: bool,
    language: Language,
    force: bool,
) -> None:
    """Solve a template exactly at given values; the rest take their published value, or the first
    drawable one.
    """
    from kinegrade.choosing.describing import describe_other_words

    solved = kinegrade.template(template_name).solve(**read_settings(settings))
    asks = None if asked is None else choose_asks(asked, solved)
    solution = solved if asks is None else solved.only(asks)
    if not as_json and (statement := describe_other_words(solution, language)):
        click.echo(f"{statement}\n")
    click.echo(_write_json(solution) if as_json else _write_table(solution, whole=whole))
    if output is not None:
        from kinegrade.exam.printing.sample import print_worked_solution
        from kinegrade.files.output import write_file

        pages = print_worked_solution(
            solution, language, asks, method, cycle=cycle, large=large_print
        )
        write_file(output, pages, "pdf", force=force)


def read_settings(settings: tuple[str, ...]) -> dict[str, str]:
    """The values of --set. Raises TemplateError for a setting without "=" or given twice."""
    values: dict[str, str] = {}
    faults = []
    for setting in settings:
        name, mark, value = setting.partition("=")
        if not mark or not name.strip() or not value.strip():
            faults.append(Message("terminal.setting", setting=Quoted(setting)))
        elif name.strip() in values:
            faults.append(Message("terminal.setting-twice", name=name.strip()))
        values[name.strip()] = value.strip()
    if faults:
        raise TemplateError(*faults)
    return values


def choose_asks(asked: str, solution: Solution) -> tuple[str, ...]:
    """The asks of --asks, in the order of the template. Raises TemplateError for unknown ones."""
    from kinegrade.problem.solution import explain_no_ask

    if asked.strip() == _ALL:
        return tuple(solution)
    names = [name.strip() for name in asked.split(",")]
    faults = [explain_no_ask(name, solution) for name in names if name not in solution]
    if faults:
        raise TemplateError(*(Fault(solution.template.name, each) for each in faults))
    return tuple(name for name in solution if name in names)


def _write_json(solution: Solution) -> str:
    """The solution as JSON. Raises TemplateError for values that no JSON number holds."""
    import json

    record = {
        "template": solution.template.name,
        "parameters": {name: quantity.record() for name, quantity in solution.parameters.items()},
        "answers": {name: quantity.record() for name, quantity in solution.answers.items()},
    }
    try:
        return json.dumps(record, ensure_ascii=False, indent=1, allow_nan=False)
    except ValueError as error:
        raise TemplateError(Message("terminal.beyond-json")) from error


def _write_table(solution: Solution, *, whole: bool) -> str:
    """The solution as a table: name, decimal, unit, exact form; that of any length as a `whole`."""
    words, lines = terminal_words(), []
    for group in (solution.parameters, solution.answers):
        for name, quantity in group.items():
            lines.append(_write_row(name, quantity, _write_exact(quantity, words, whole=whole)))
        lines.append("")
    return "\n".join(lines[:-1])


def _write_row(name: str, quantity: Quantity, exact: str) -> str:
    decimal = exact if quantity.at_infinity else quantity.decimal(10)
    return f"{name:<14} {decimal:>18} {quantity.measure.printed:<6}  {exact}"


def _write_exact(quantity: Quantity, words: Catalogue, *, whole: bool) -> str:
    """What stands beside the decimal: the exact form, or how long it is."""
    if quantity.at_infinity:
        return words.text("terminal.infinity")
    if quantity.exact is None:
        return words.text("terminal.enclosure")
    if whole or len(quantity.exact) <= _LONGEST:
        return quantity.exact
    return words.text("terminal.long-form", number=len(quantity.exact))
