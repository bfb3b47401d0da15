"""The pages about templates: what an author may write, and the templates that are shipped."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import cache

from docs.generator.markdown import write_code, write_page, write_table
from kinegrade.choosing.demands import find_demands
from kinegrade.language import ENGLISH
from kinegrade.language.catalogue import open_catalogue
from kinegrade.problem.template.library.library import find_template_names, load_template
from kinegrade.problem.template.sections.keys import SHARED
from kinegrade.problem.template.tags import TAGS, Tag, list_tags
from kinegrade.problem.template.template import METHODS, Template
from kinegrade.problem.vocabulary import (
    Group,
    Word,
    describe_group,
    list_sections,
    write_meaning,
)


def write_template_page() -> str:
    """The tables and keys of a template, and the words in them."""
    return write_page(
        "# Templates",
        "A template is a TOML file. `kinegrade new NAME` writes one with every table and what goes "
        "there; [A textbook problem becomes a template](../tutorial/own-template.md) takes you "
        "through one. `kinegrade words` shows this page and the next one at the terminal, in your "
        "language. A text is a string, or one string for each language, "
        '`{ en = "crank", zh = "曲柄" }`.',
        *_write_group("template"),
        f"Methods: {_list(METHODS)}. A shared mechanism holds any of {_list(SHARED)}; a "
        "template's entries are laid over these by name, its joints and conditions follow them.",
        *_write_group("parameters"),
        *_write_group("joints"),
        *_write_group("inputs"),
        *_write_group("asks"),
        *_write_group("figure"),
    )


def write_expression_page() -> str:
    """What an expression of a template may hold."""
    return write_page(
        "# Expressions",
        "An expression has numbers (`0.25`, `1/3`, `sqrt(3)`), names, `pi`, `+ - * / **` and the "
        "functions below. What a function takes is in capitals; what is in brackets may be "
        "left out. Lengths are in metres, angles are angles: write `pi/2`, never `90`. "
        "Dimensions are checked when the template is read.",
        *_write_group("points"),
        *_write_group("quantities"),
        *_write_group("units"),
    )


def write_shipped_page() -> str:
    """The shipped templates, by family."""
    rows = sorted((one.about.family, one.name) for one in _shipped())
    return write_page(
        "# Shipped templates",
        "`kinegrade show NAME` shows one in full, `kinegrade gallery -o gallery.pdf` all of them "
        "with their figures.",
        write_table(
            ("template", "title", "family", "difficulty", "minutes", "tags", "asks with points"),
            [_describe(load_template(name)) for _, name in rows],
        ),
        "## Tags",
        "`kinegrade list --tag WORD` finds the templates with a tag, and a bank draws from them by "
        '`tag = "WORD"`; `kinegrade list --tags` counts them.',
        write_table(("tag", "meaning"), [(write_code(tag), _explain(tag)) for tag in TAGS]),
    )


@cache
def _shipped() -> tuple[Template, ...]:
    return tuple(map(load_template, find_template_names()))


def _explain(tag: Tag) -> str:
    """What a tag means."""
    return open_catalogue(ENGLISH).text(f"choosing.tag-{tag}")


def _describe(template: Template) -> tuple[str, ...]:
    about, demands = template.about, find_demands(template)
    return (
        write_code(template.name),
        about.title.in_language(ENGLISH),
        about.family,
        str(demands.difficulty),
        str(demands.minutes),
        ", ".join(sorted(list_tags(template))),
        _list(template.asked()),
    )


def _write_group(group: Group) -> Iterator[str]:
    """A heading for what a group of words is for, and its words in tables."""
    yield f"## {group.capitalize()}"
    yield write_meaning(describe_group(group), ENGLISH)
    for section in list_sections(group):
        yield f"### {write_meaning(section.title, ENGLISH).removesuffix(':')}"
        rows = [_write_word(word) for word in section.words]
        has_examples = any(word.examples for word in section.words)
        header = ("written", "meaning", "for example")[: 3 if has_examples else 2]
        yield write_table(header, [row[: len(header)] for row in rows])


def _write_word(word: Word) -> tuple[str, str, str]:
    """What is written, what it means, and examples of it."""
    return write_code(word.text), write_meaning(word.meaning, ENGLISH), _list(word.examples)


def _list(words: Iterable[str]) -> str:
    return ", ".join(map(write_code, words))
