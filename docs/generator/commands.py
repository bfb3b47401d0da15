"""The page of the commands, from the command line itself and its help."""

from __future__ import annotations

from collections.abc import Iterator

import click

from docs.generator.markdown import write_code, write_page, write_table
from kinegrade.cli import main
from kinegrade.language import ENGLISH
from kinegrade.language.catalogue import open_catalogue

_VERBATIM = "    "  # begins the lines of examples in the help


def write_commands() -> str:
    """Every command with what it does, its options and an example."""
    return write_page(
        "# Commands",
        "`kinegrade COMMAND --help` says the same at the terminal, in its language. Results go to "
        "standard output or to what `-o` names, messages to standard error. An output that exists "
        "is replaced only with `--force`: a folder only where kinegrade wrote it and nobody "
        "added to it, a single file whatever it holds: what a table or a text held is kept beside "
        "it as `NAME.previous-1`, `NAME.previous-2` ..., of any other file the last as "
        "`NAME.previous`, and what was edited by hand in a folder of marks or feedback in "
        "`NAME.previous-1`.",
        *(block for command in main.commands.values() for block in _describe(command)),
    )


def _describe(command: click.Command) -> Iterator[str]:
    context = click.Context(command, info_name=f"kinegrade {command.name}")
    yield f"## {command.name}"
    for paragraph in read_help(str(command.name)).split("\n\n"):
        yield _write_paragraph(paragraph)
    pieces = " ".join(command.collect_usage_pieces(context))
    yield f"```text\nkinegrade {command.name} {pieces}\n```"
    options = [each for each in command.params if isinstance(each, click.Option)]
    yield write_table(
        ("option", "meaning"),
        [(_write_option(each, context), _write_meaning(each, context)) for each in options],
    )


def read_help(key: str) -> str:
    """An English entry of the help."""
    return open_catalogue(ENGLISH).text(f"help.{key}")


def _write_paragraph(paragraph: str) -> str:
    """A paragraph of the help; its examples as a block, without their labels."""
    if not paragraph.startswith(_VERBATIM):
        return paragraph
    examples = [line[line.index("kinegrade") :] for line in paragraph.splitlines()]
    return "\n".join(("```text", *examples, "```"))


def _write_option(option: click.Option, context: click.Context) -> str:
    """How an option is written: its names, and what follows them."""
    names = ", ".join((*option.opts, *option.secondary_opts))
    if option.is_flag:
        return write_code(names)
    return write_code(f"{names} {option.make_metavar(context)}")


def _write_meaning(option: click.Option, context: click.Context) -> str:
    shown = str(option.name).replace("_", "-")
    words = open_catalogue(ENGLISH)
    key = f"help.{context.command.name}.{shown}"
    meaning = words.text(key if words.has(key) else f"help.option.{shown}")
    if option.required:
        return f"{meaning} Required."
    if option.show_default and not option.is_flag:
        return f"{meaning} Default: {write_code(str(option.default))}."
    return meaning
