"""The pages about templates: what an author may write, and the templates that are shipped."""

from __future__ import annotations

from collections.abc import Container, Iterable, Iterator, Mapping
from functools import cache

from docs.generator.described import read_words
from docs.generator.markdown import write_code, write_page, write_table, write_words
from kinegrade.choosing.demands import find_demands
from kinegrade.language import ENGLISH
from kinegrade.language.catalogue import open_catalogue
from kinegrade.mechanics.geometry import BRANCHES
from kinegrade.numbers.units import FACTORS
from kinegrade.problem.kinds.signatures import CONSTRUCTIONS, ELEMENTARY, Signature
from kinegrade.problem.quantities.functions import QUANTITIES
from kinegrade.problem.template import sentences
from kinegrade.problem.template.hints import SHAPES
from kinegrade.problem.template.library.library import find_template_names, load_template
from kinegrade.problem.template.sections.keys import SHARED
from kinegrade.problem.template.signs import Sign, write_sign
from kinegrade.problem.template.tags import TAGS, Tag, list_tags
from kinegrade.problem.template.template import METHODS, Template
from kinegrade.sign_conventions import CONVENTIONS

_KEYS = "kinegrade.problem.template.sections.keys"
_SIGNATURES = "kinegrade.problem.kinds.signatures"
_QUANTITIES = "kinegrade.problem.quantities"
_INDENTED = "    "  # begins an example
_MARKS = {
    "lengths": "LENGTH",
    "angles": "ANGLE",
    "radii": "RADIUS",
    "circles": "CIRCLE",
    "arrows, straight": "MOVING",
    "arrows, curved": "TURNING",
}


def write_template_page() -> str:
    """The tables and keys of a template, and the words in them."""
    return write_page(
        "# Templates",
        "A template is a TOML file. `kinegrade new NAME` writes one with every table and what goes "
        "there; [A textbook problem becomes a template](../tutorial/own-template.md) takes you "
        "through one. A text is a string, or one string for each language, "
        '`{ en = "crank", zh = "曲柄" }`.',
        "## Tables and keys",
        "Every template has:",
        write_words("key", read_words(_KEYS, "NEEDED")),
        "It may have:",
        write_words("key", {**read_words(_KEYS, "OPTIONAL"), **read_words(_KEYS, "SHARING")}),
        f"Methods: {_list(METHODS)}. A shared mechanism holds any of {_list(SHARED)}; a "
        "template's entries are laid over these by name, its joints and conditions follow them.",
        *_section("In `[parameters]`", "PARAMETER"),
        *_section("In `inputs`", "INPUT"),
        *_section("In `[asks]`", "ASK"),
        *_section("In `[[published]]`", "PUBLISHED"),
        "## Sign conventions",
        write_words("`sign`", {each: _write_plainly(each) for each in CONVENTIONS}),
        "## Sentences",
        "The sentences in which joints and inputs are stated:",
        *_write_sentences(),
        *_figure(),
    )


def write_expression_page() -> str:
    """What an expression of a template may hold."""
    return write_page(
        "# Expressions",
        "An expression has numbers (`0.25`, `1/3`, `sqrt(3)`), names, `pi`, `+ - * / **` and the "
        "functions below. What a function takes is in capitals; what is in brackets may be "
        "left out. Lengths are in metres, angles are angles: write `pi/2`, never `90`. "
        "Dimensions are checked when the template is read.",
        "## Numbers and angles",
        _write_functions(read_words(_SIGNATURES, "ELEMENTARY"), ELEMENTARY),
        "## Points, lines and circles",
        _write_functions(
            read_words(_SIGNATURES, "CONSTRUCTIONS"), _leave_out(CONSTRUCTIONS, ELEMENTARY)
        ),
        f"Sides: {_list(BRANCHES)}. Of two circles, `counterclockwise` and `clockwise` count from "
        "the directed line between the centres.",
        "## Quantities that may be asked",
        _write_functions(
            {
                **read_words(f"{_QUANTITIES}.motion_functions", "MOTION_FUNCTIONS"),
                **read_words(f"{_QUANTITIES}.measures", "MEASURES"),
            },
            _leave_out(QUANTITIES, CONSTRUCTIONS),
        ),
        "## Units",
        f"Products and quotients of powers of {_list(FACTORS)}, such as `mm/s^2` and `rad/s`; `1` "
        "is a pure number, and `deg` stands alone.",
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


def _section(title: str, name: str) -> Iterator[str]:
    yield f"## {title}"
    yield write_words("key", read_words(_KEYS, name))


def _figure() -> Iterator[str]:
    yield from _section("In `[figure]`", "FIGURE")
    yield f"Shapes: {_list(SHAPES)}."
    for title, name in _MARKS.items():
        yield f"### Entries of {title}"
        yield write_words("key", read_words(_KEYS, name))


def list_sentences() -> list[str]:
    """The sentences that their reader lists, an example of each kind."""
    return [line.strip() for line in _read_notes() if line.startswith(_INDENTED)]


def _write_sentences() -> Iterator[str]:
    """The sentences, and what the notes on them say."""
    yield "\n".join(("```text", *list_sentences(), "```"))
    yield " ".join(line for line in _read_notes() if not line.startswith(_INDENTED)).strip()


def _read_notes() -> list[str]:
    """What the reader of sentences says about them, without its title."""
    return str(sentences.__doc__).split("\n\n", 1)[1].splitlines()


def _write_functions(meanings: Mapping[str, str], functions: Mapping[str, Signature]) -> str:
    rows = [(write_code(each.usage(name)), meanings[name]) for name, each in functions.items()]
    return write_table(("function", "gives"), rows)


def _write_plainly(sign: Sign) -> str:
    """A sign convention in words, without LaTeX."""
    return write_sign(sign, ENGLISH).replace("$", "")


def _leave_out(
    functions: Mapping[str, Signature], others: Container[str]
) -> Mapping[str, Signature]:
    """The functions without those whose names are among the others."""
    return {name: each for name, each in functions.items() if name not in others}


def _list(words: Iterable[str]) -> str:
    return ", ".join(map(write_code, words))
