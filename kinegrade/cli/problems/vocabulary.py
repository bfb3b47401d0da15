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


@command()
@click.argument("group", metavar="[GROUP]", type=LateChoice(_read_groups), required=False)
@READER_LANGUAGE
@refusing
def words(group: Group | None, language: Language | None) -> None:
    """List what a template may say: sentences, constructions, quantities, keys, units."""
    from kinegrade.problem.vocabulary import GROUPS, describe_group, list_sections, write_meaning

    chosen = language or choose_terminal_language()
    if group is None:
        width = max(map(len, GROUPS))
        for each in GROUPS:
            click.echo(f"{each:{width}}  {write_meaning(describe_group(each), chosen)}")
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
