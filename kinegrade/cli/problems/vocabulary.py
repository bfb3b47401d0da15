"""The command that lists what an author of templates may write: words."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from typing import TYPE_CHECKING

import click

from kinegrade.cli.help import command
from kinegrade.cli.option_types import LateChoice
from kinegrade.cli.options import refusing
from kinegrade.cli.problems.choosing import READER_LANGUAGE
from kinegrade.language import Language
from kinegrade.language.known import choose_terminal_language
from kinegrade.language.terminal_lines import wrap

if TYPE_CHECKING:
    from kinegrade.problem.vocabulary import Group, Section

_INDENT = "    "


def _read_groups() -> tuple[str, ...]:
    from kinegrade.problem.vocabulary import GROUPS

    return GROUPS


class _GroupChoice(LateChoice):
    """Reads the name of a group, in any language."""

    def convert(self, value: str, param: click.Parameter | None, ctx: click.Context | None) -> str:
        """The group of that name."""
        from kinegrade.problem.vocabulary import find_group

        return super().convert(find_group(value) or value, param, ctx)


@command()
@click.argument("group", metavar="[GROUP]", type=_GroupChoice(_read_groups), required=False)
@READER_LANGUAGE
@refusing
def words(group: Group | None, language: Language | None) -> None:
    """List what a template may say: sentences, constructions, quantities, keys, units."""
    from kinegrade.problem.vocabulary import (
        GROUPS,
        describe_group,
        list_names,
        list_sections,
        write_meaning,
    )

    chosen = language or choose_terminal_language()
    if group is None:
        width = max(map(len, GROUPS))
        for each in GROUPS:
            name = list_names(each, chosen)[0]
            own = "" if name == each else f"{name}: "
            click.echo(f"{each:{width}}  {own}{write_meaning(describe_group(each), chosen)}")
        return
    lines = [_write_section(section, chosen) for section in list_sections(group)]
    click.echo("\n\n".join("\n".join(section) for section in lines))


def _write_section(section: Section, language: Language) -> Iterator[str]:
    """A title, and below it each word with its meaning and examples, indented."""
    from kinegrade.problem.vocabulary import write_meaning

    width = shutil.get_terminal_size().columns - len(_INDENT)
    yield write_meaning(section.title, language)
    for word in section.words:
        yield f"  {word.text}"
        for line in wrap(write_meaning(word.meaning, language), width):
            yield f"{_INDENT}{line}"
        for example in word.examples:
            yield f"{_INDENT}| {example}"
