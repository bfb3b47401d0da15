"""Commands whose help comes from the catalogues, in the language of the terminal.

The help of a command is the entry `help.<command>`, that of an option `help.<command>.<option>`,
or `help.option.<option>` where it means the same everywhere.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator
from copy import copy
from typing import Any

import click

from kinegrade.cli.terminal import refuse_usage, terminal_words
from kinegrade.language.message import Message

_VERBATIM = "    "  # begins the lines of a paragraph whose lines stay as they are
_UNWRAPPED = "\b\n"  # click's mark of such a paragraph


class Command(click.Command):
    """A command that has its words in the catalogues."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Read the command line. Raises UsageError where an option is given twice that has one
        value: the first would be lost.
        """
        given = self.make_parser(ctx).parse_args(list(args))[2]
        for option, count in Counter(given).items():
            if count > 1 and isinstance(option, click.Option) and _has_one_value(option):
                what = Message("terminal.option-twice", option=option.opts[-1])
                raise refuse_usage(what)
        return super().parse_args(ctx, args)

    def format_help_text(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Write what the command does."""
        described = copy(self)
        described.help = read_help(str(self.name))
        super(Command, described).format_help_text(ctx, formatter)

    def format_options(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Write what the options do."""
        described = copy(self)
        described.params = [_describe(each, str(self.name)) for each in self.params]
        super(Command, described).format_options(ctx, formatter)

    def get_short_help_str(self, limit: int = 45) -> str:
        """The first sentence of what the command does."""
        described = copy(self)
        described.help = read_help(str(self.name))
        return super(Command, described).get_short_help_str(limit)


def _has_one_value(option: click.Option) -> bool:
    return not (option.multiple or option.is_flag or option.count)


def command(name: str | None = None) -> Callable[[Callable[..., Any]], Command]:
    """Makes a function a command; by default of its name."""
    return click.command(name, cls=Command)


def read_help(name: str) -> str:
    """The help of a command as click formats it."""
    paragraphs = terminal_words().text(f"help.{name}").split("\n\n")
    return "\n\n".join(map(_mark_verbatim, paragraphs))


def list_help_keys(program: click.Group) -> Iterator[str]:
    """The entries that the help of a program uses."""
    yield "help.main"
    for name, each in program.commands.items():
        yield f"help.{name}"
        for option in each.params:
            if isinstance(option, click.Option):
                yield _find_key(option, name)


def _mark_verbatim(paragraph: str) -> str:
    if not paragraph.startswith(_VERBATIM):
        return paragraph
    return _UNWRAPPED + "\n".join(line.strip() for line in paragraph.splitlines())


def _describe(parameter: click.Parameter, command_name: str) -> click.Parameter:
    if not isinstance(parameter, click.Option):
        return parameter
    described = copy(parameter)
    described.help = terminal_words().text(_find_key(parameter, command_name))
    return described


def _find_key(option: click.Option, command_name: str) -> str:
    shown = str(option.name).replace("_", "-")
    key = f"help.{command_name}.{shown}"
    return key if terminal_words().has(key) else f"help.option.{shown}"
