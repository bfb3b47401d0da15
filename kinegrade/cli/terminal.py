"""What the commands say on the terminal: on standard error, in the language of the environment, or
in the one that is asked for.
"""

from __future__ import annotations

import click

from kinegrade.language import Language
from kinegrade.language.catalogue import Catalogue, open_catalogue
from kinegrade.language.known import choose_terminal_language
from kinegrade.language.message import Message, Part

_WANTED = "kinegrade.language"  # in what a command line keeps


def terminal_words() -> Catalogue:
    """The words in which the terminal is spoken to."""
    context = click.get_current_context(silent=True)
    wanted = None if context is None else context.meta.get(_WANTED)
    return open_catalogue(wanted or choose_terminal_language())


def speak(language: Language | None) -> None:
    """From here on, the command speaks to the terminal in the language; where it is None, in that
    of the environment.
    """
    click.get_current_context().meta[_WANTED] = language


def say(what: Part) -> None:
    """Say something, in one line or in a few."""
    click.echo(terminal_words().write(what), err=True)


def write_line(what: Part) -> str:
    """Something to be said in one line."""
    return " ".join(terminal_words().write(what).split())


def refuse_usage(what: Message) -> click.UsageError:
    """The error of a command line that contradicts itself."""
    return click.UsageError(write_line(what))


def refuse_value(option: str, what: Message) -> click.BadParameter:
    """The error of an option's value."""
    return click.BadParameter(write_line(what), param_hint=option)
