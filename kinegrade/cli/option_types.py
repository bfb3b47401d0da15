"""The types of options: a language, one of the names of a table, a level or a range of levels."""

from __future__ import annotations

from collections.abc import Callable, Iterable

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


class LateChoice(click.Choice[str]):
    """Reads one of the names that `read_names` gives, of a table that is imported only when
    the option is read or described.
    """

    def __init__(self, read_names: Callable[[], Iterable[str]]) -> None:
        super().__init__(())
        self.read_names = read_names

    def convert(self, value: str, param: click.Parameter | None, ctx: click.Context | None) -> str:
        """The name; one of several that lacks the plural's s serves."""
        plural = f"{value}s"
        return super().convert(plural if plural in self.choices else value, param, ctx)

    @property
    def choices(self) -> tuple[str, ...]:
        """The names, in the order of their table."""
        return tuple(self.read_names())

    @choices.setter
    def choices(self, names: tuple[str, ...]) -> None:
        """click sets the names at first, when they are not known yet."""
