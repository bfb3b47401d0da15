"""The commands by which an instructor chooses templates: list, show."""

from __future__ import annotations

import re
import shutil
import sys
from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from kinegrade.cli.help import command
from kinegrade.cli.option_types import LanguageChoice
from kinegrade.cli.options import FILE, FORCE, finish_with_complaints, refusing, require_writable
from kinegrade.cli.terminal import write_line
from kinegrade.errors import TemplateError
from kinegrade.files.fields.values import found
from kinegrade.language import ENGLISH, Language
from kinegrade.language.known import choose_terminal_language
from kinegrade.language.message import Fault, Message
from kinegrade.language.terminal_lines import align, cut

if TYPE_CHECKING:
    from kinegrade.choosing.choice import Entry
    from kinegrade.problem.template.template import Template
    from kinegrade.problem.template.translated import Translated

_BOUNDS = re.compile(r"([0-9]{1,4})(?:\.\.([0-9]{1,4}))?")
READER_LANGUAGE = click.option("--lang", "language", type=LanguageChoice())


class BoundsType(click.ParamType[tuple[int, int]]):
    """Reads a level or a range of levels: `3` or `2..3`."""

    name = "bounds"

    def get_metavar(self, param: click.Parameter, ctx: click.Context) -> str:
        """What help shows."""
        return "N..M"

    def convert(
        self, value: object, param: click.Parameter | None, ctx: click.Context | None
    ) -> tuple[int, int]:
        """The least and the most. Raises BadParameter."""
        stated = _BOUNDS.fullmatch(str(value))
        if stated is None or int(stated[1]) > int(stated[2] or stated[1]):
            self.fail(
                write_line(Fault("", found(str(value)), Message("choosing.bounds"))), param, ctx
            )
        return int(stated[1]), int(stated[2] or stated[1])


BOUNDS = BoundsType()


@command("list")
@READER_LANGUAGE
@click.option("--family")
@click.option("--tag", multiple=True)
@click.option("--without-tag", multiple=True, metavar="TAG")
@click.option("--joint", multiple=True)
@click.option("--without-joint", multiple=True, metavar="JOINT")
@click.option("--asks", multiple=True, metavar="WORD")
@click.option("--method", multiple=True)
@click.option("--difficulty", type=BOUNDS)
@click.option("--minutes", type=BOUNDS)
@click.option("--tags", "tags_alone", is_flag=True)
@refusing
def list_templates(
    *, language: Language | None, family: str | None, tags_alone: bool, **wishes: Any
) -> None:
    """List the problem templates."""
    from kinegrade.choosing.choice import Wishes, choose, count_tags, read_entries
    from kinegrade.problem.template.library.library import find_template_names, load_template

    entries = read_entries(map(load_template, find_template_names()))
    families = () if family is None else (family,)
    choice = choose(entries, Wishes(families, **wishes))
    if tags_alone:
        _print_rows(_tabulate_tags(count_tags(choice.entries)), ("tag", "count", "meaning"))
    else:
        rows = [_write_entry(entry, language) for entry in choice.entries]
        _print_rows(rows, ("name", "family", "title", "difficulty", "minutes", "tags"))
    finish_with_complaints(choice.complaints)


def _write_entry(entry: Entry, language: Language | None) -> tuple[str, ...]:
    """A row of the list: name, family, title, difficulty, minutes, tags."""
    return (
        entry.template.name,
        entry.family,
        _write_title(entry.template.about.title, language),
        str(entry.demands.difficulty),
        str(entry.demands.minutes),
        " ".join(sorted(entry.tags)),
    )


def _write_title(title: Translated, language: Language | None) -> str:
    """A title in the language wanted, or the languages in which it is; where none is wanted, in the
    reader's language if it can be.
    """
    from kinegrade.language.prose.plain import write_line as write_title

    if language is not None and not title.has(language):
        return f"({', '.join(title.languages)})"
    return write_title(title.in_language(language or _prefer(title.languages)), "title")


def _prefer(languages: Sequence[Language]) -> Language:
    """Of the languages that there are, the reader's, else English, else any; English for a plain
    text, which is the same in all.
    """
    preferred = (choose_terminal_language(), ENGLISH, *languages)
    return next((language for language in preferred if language in languages), ENGLISH)


def _tabulate_tags(counts: Mapping[str, int]) -> list[tuple[str, ...]]:
    """A row for each tag: its name, how many templates have it, what it means."""
    return [(tag, str(count), _write_meaning(tag)) for tag, count in counts.items()]


def _write_meaning(tag: str) -> str:
    """What a tag means; nothing for the word of an author."""
    from kinegrade.problem.template.tags import TAGS

    return write_line(Message(f"choosing.tag-{tag}")) if tag in TAGS else ""


def _print_rows(rows: Sequence[Sequence[str]], columns: Sequence[str]) -> None:
    """Rows for programs, with tabs; in a terminal under a header, aligned and no wider than it."""
    if not _is_terminal():
        click.echo("".join("\t".join(row) + "\n" for row in rows), nl=False)
    elif rows:
        header = [write_line(Message(f"choosing.column-{column}")) for column in columns]
        lines = align(header, rows).splitlines()
        width = shutil.get_terminal_size().columns
        click.echo("\n".join(cut(line, width) for line in lines))


def _is_terminal() -> bool:
    """Whether people read what is printed."""
    return sys.stdout.isatty()


@command()
@click.argument("template_name", metavar="TEMPLATE")
@READER_LANGUAGE
@click.option(
    "-o",
    "--output",
    type=FILE,
)
@click.option(
    "--seed",
    callback=require_writable,
    default="sample",
    show_default=True,
)
@FORCE
@refusing
def show(
    template_name: str, language: Language | None, output: Path | None, seed: str, force: bool
) -> None:
    """Show a template: statement, parameters, what can be asked, how many instances."""
    from kinegrade.choosing.choice import make_entry
    from kinegrade.choosing.describing import describe_template
    from kinegrade.problem.template.library.library import load_template

    template = load_template(template_name)
    chosen = _choose_language(template, language)
    click.echo(describe_template(make_entry(template), chosen))
    if output is not None:
        from kinegrade.exam.printing.sample import print_sample
        from kinegrade.files.output import write_file

        write_file(output, print_sample(template, seed, chosen), "pdf", force=force)


def _choose_language(template: Template, wanted: Language | None) -> Language:
    """The language wanted, else the reader's where the template has it. Raises TemplateError."""
    from kinegrade.problem.template.texts import find_languages, require_language

    if wanted is None:
        return _prefer(find_languages(template))
    require_language([template], wanted)
    return wanted


def choose_common_language(names: Iterable[str]) -> Language:
    """The reader's language where all of these templates have it, else one that they share; of
    those that cannot be read nothing is asked.
    """
    from kinegrade.problem.template.library.library import load_template
    from kinegrade.problem.template.texts import find_languages

    shared: list[Language] | None = None
    for name in names:
        with suppress(TemplateError):
            own = find_languages(load_template(name))
            shared = [each for each in own if shared is None or each in shared]
    return _prefer(shared or [])
