"""The value of --lang: one of the languages that have a catalogue."""

from __future__ import annotations

import click

from kinegrade.cli.terminal import write_line
from kinegrade.errors import FieldError
from kinegrade.language import Language
from kinegrade.language.known import known_languages, read_language


class LanguageChoice(click.ParamType[Language]):
    """Reads the name of a language; another one is refused with the nearest."""

    name = "language"

    def get_metavar(self, param: click.Parameter, ctx: click.Context) -> str:
        """The names, as help shows them."""
        return f"[{'|'.join(known_languages())}]"

    def convert(
        self, value: object, param: click.Parameter | None, ctx: click.Context | None
    ) -> Language:
        """The language. Raises BadParameter."""
        try:
            return read_language(str(value))
        except FieldError as error:
            self.fail("; ".join(map(write_line, error.faults)), param, ctx)
