"""The command that moves a mechanism through its cycle: cycle."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, get_args

import click

import kinegrade
from kinegrade.cli.help import command
from kinegrade.cli.options import FORCE, LANGUAGE, OPTIONAL_OUTPUT, refusing
from kinegrade.cli.problems.solve import ASKS, SETTINGS, choose_asks, read_settings
from kinegrade.errors import OutputError
from kinegrade.language.message import Fault, Message, list_choices

if TYPE_CHECKING:
    from kinegrade.language import Language
    from kinegrade.public.cycles import CycleFormat


@command()
@click.argument("template_name", metavar="TEMPLATE")
@SETTINGS
@ASKS
@click.option("--centrodes", is_flag=True)
@OPTIONAL_OUTPUT
@LANGUAGE
@FORCE
@refusing
def cycle(
    *,
    template_name: str,
    settings: tuple[str, ...],
    asked: str | None,
    centrodes: bool,
    output: Path | None,
    language: Language,
    force: bool,
) -> None:
    """Move a mechanism through the whole range of its input: strokes, extremes, curves."""
    from kinegrade.cycles.curves import find_followed
    from kinegrade.cycles.cycle import make_cycle
    from kinegrade.files.output import write_file
    from kinegrade.public.cycles import describe_cycle, write_cycle

    kind = None if output is None else _find_kind(output)
    solution = kinegrade.template(template_name).solve(**read_settings(settings))
    every = find_followed(solution) if asked == "all" else None
    names = every or (choose_asks(asked, solution) if asked else None)
    found = make_cycle(solution, names, centrodes=centrodes)
    for line in describe_cycle(found, language):
        click.echo(line)
    if output is not None and kind is not None:
        write_file(output, write_cycle(found, language, kind), kind, force=force)


def _find_kind(output: Path) -> CycleFormat:
    """What a file's name says that it is to be. Raises OutputError for another ending."""
    from kinegrade.public.cycles import CycleFormat

    ending = output.suffix.lower().removeprefix(".")
    for kind in get_args(CycleFormat):
        if ending == kind:
            return kind  # type: ignore[no-any-return]
    expected = list_choices(f".{kind}" for kind in get_args(CycleFormat))
    what = Message("motion.no-format")
    raise OutputError(Fault(str(output), what, Message("files.ending", endings=expected)))
