"""A value of an option that is one of the names of a table elsewhere, which is imported only when
the option is read or described.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable

import click


class LateChoice(click.Choice[str]):
    """Reads one of the names that `read_names` gives."""

    def __init__(self, read_names: Callable[[], Iterable[str]]) -> None:
        super().__init__(())
        self.read_names = read_names

    @property
    def choices(self) -> tuple[str, ...]:
        """The names, in the order of their table."""
        return tuple(self.read_names())

    @choices.setter
    def choices(self, names: tuple[str, ...]) -> None:
        """click sets the names at first, when they are not known yet."""
