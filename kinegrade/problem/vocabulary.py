"""Every word that an author of templates may write, group by group, with its meaning and examples.

The words are those of the tables that templates are read by, their meanings are in the catalogues;
`kinegrade words` and the reference of docs/ print them.
"""

from __future__ import annotations

import re
from collections.abc import Container, Iterable, Mapping
from dataclasses import dataclass
from typing import Literal, TypeAlias, assert_never, get_args

from kinegrade.expressions.tree import SIDES_OF
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.known import known_languages
from kinegrade.language.message import Message
from kinegrade.mechanics.branches import BRANCHES
from kinegrade.mechanics.drivers import DRIVERS, Driver
from kinegrade.mechanics.joints import JOINTS, Joint
from kinegrade.numbers.units import SCALES, SHORT
from kinegrade.problem.kinds.signatures import CONSTRUCTIONS, ELEMENTARY, Signature
from kinegrade.problem.quantities.functions import QUANTITIES
from kinegrade.problem.quantities.measures import MEASURES
from kinegrade.problem.template.hints import SHAPES
from kinegrade.problem.template.sections import keys
from kinegrade.problem.template.sections.key_examples import KEY_EXAMPLES
from kinegrade.problem.template.signs import describe_convention
from kinegrade.problem.template.tags import TAGS
from kinegrade.sign_conventions import CONVENTIONS

Group: TypeAlias = Literal[
    "template",
    "parameters",
    "points",
    "joints",
    "inputs",
    "asks",
    "quantities",
    "figure",
    "units",
    "tags",
]
GROUPS: tuple[Group, ...] = get_args(Group)
_FORMULA = re.compile(r"(`[^`]*`)|\$")


@dataclass(frozen=True)
class Word:
    """A word or a sentence as it is written, what it means, and examples of it."""

    text: str
    meaning: Message
    examples: tuple[str, ...] = ()


@dataclass(frozen=True)
class Section:
    """Words that belong together, under their title."""

    title: Message
    words: tuple[Word, ...]


def describe_group(group: Group) -> Message:
    """What the words of a group are for."""
    return Message(f"words.group-{group}")


def list_names(group: Group, language: Language) -> list[str]:
    """What a group is called in a language.

    >>> list_names("joints", Language("en")), list_names("tags", Language("de"))
    (['joints'], ['Stichwörter', 'Schlagwörter'])
    """
    return open_catalogue(language).text(f"words.named-{group}").split("|")


def find_group(name: str) -> Group | None:
    """The group that goes by a name in some language; None where none does.

    >>> find_group("gelenke"), find_group("铰链"), find_group("doors")
    ('joints', 'joints', None)
    """
    for group in GROUPS:
        for language in known_languages():
            if name.casefold() in map(str.casefold, list_names(group, language)):
                return group
    return None


def list_sections(group: Group) -> tuple[Section, ...]:
    """The words of a group."""
    match group:
        case "template":
            optional = (*keys.OPTIONAL, *keys.SHARING, *keys.STATED)
            return _keys("needed", "template", keys.NEEDED), _keys("optional", "template", optional)
        case "parameters":
            return (_keys("keys", "parameter", keys.PARAMETER),)
        case "points":
            return (_constructions(), _branches(), _functions("arithmetic", ELEMENTARY))
        case "joints":
            return _sentences("joint", JOINTS), _parts("of", "inside", "on", "turns with")
        case "inputs":
            return (
                _sentences("input", DRIVERS),
                _parts("relative to"),
                _keys("keys", "input", keys.INPUT),
            )
        case "asks":
            published = _keys("published", "published", keys.PUBLISHED)
            return _keys("keys", "ask", keys.ASK), _signs(), published
        case "quantities":
            motion = _leave_out(QUANTITIES, {*CONSTRUCTIONS, *MEASURES})
            measures = {name: QUANTITIES[name] for name in MEASURES}
            return _functions("motion", motion), _functions("measures", measures)
        case "figure":
            return _list_marks()
        case "units":
            return (_keys("units", "unit", (*SCALES, *SHORT)),)
        case "tags":
            tags = tuple(Word(tag, Message(f"choosing.tag-{tag}")) for tag in TAGS)
            return (Section(Message("words.title-tags"), tags),)
        case _:
            assert_never(group)


def write_meaning(meaning: Message, language: Language) -> str:
    """A meaning as plain text, its formulas without dollar signs.

    >>> write_meaning(describe_convention("+x"), Language("en"))
    'positive to the right (+x)'
    """
    text = open_catalogue(language).write(meaning)
    return _FORMULA.sub(lambda match: match[1] or "", text)


def _keys(title: str, table: str, names: Iterable[str]) -> Section:
    """The keys of a table, each with its entry of the catalogues."""
    examples = {name: (each,) for name, each in KEY_EXAMPLES.get(table, {}).items()}
    words = tuple(
        Word(name, Message(f"words.{table}-{name}"), examples.get(name, ())) for name in names
    )
    return Section(Message(f"words.title-{title}"), words)


def _parts(*beginnings: str) -> Section:
    """Parts of sentences, by the words that they begin with."""
    words = tuple(
        Word(each, Message(f"words.part-{each.replace(' ', '-')}")) for each in beginnings
    )
    return Section(Message("words.title-parts"), words)


def _constructions() -> Section:
    named = _leave_out(CONSTRUCTIONS, {*ELEMENTARY, *SIDES_OF.values()})
    return _functions("constructions", named)


def _branches() -> Section:
    """The words that tell two common points apart."""
    directed = {name: CONSTRUCTIONS[name] for name in SIDES_OF.values()}
    plain = _keys("branches", "branch", BRANCHES)
    return Section(plain.title, (*_functions("branches", directed).words, *plain.words))


def _functions(title: str, functions: Mapping[str, Signature]) -> Section:
    words = tuple(
        Word(
            each.usage(name),
            Message(f"words.function-{name.replace(' ', '-') or 'pair'}"),
            (each.example,),
        )
        for name, each in functions.items()
    )
    return Section(Message(f"words.title-{title}"), words)


def _sentences(table: str, kinds: Iterable[type[Joint] | type[Driver]]) -> Section:
    words = tuple(
        Word(kind.FORM, Message(f"words.{table}-{kind.__name__.lower()}"), kind.EXAMPLES)
        for kind in kinds
    )
    return Section(Message("words.title-sentences"), words)


def _signs() -> Section:
    signs = tuple(Word(each, describe_convention(each)) for each in CONVENTIONS)
    return Section(Message("words.title-signs"), signs)


def _list_marks() -> tuple[Section, ...]:
    """What a figure may mark, with the keys of each mark, and shapes."""
    marks = tuple(
        Word(name, Message(f"words.figure-{name}"), (keys.FIGURE_EXAMPLES[name],))
        for name in keys.FIGURE
    )
    return (
        Section(Message("words.title-marks"), marks),
        _keys("shapes", "shape", SHAPES),
        _keys("lengths", "length", keys.LENGTH),
        _keys("angles", "angle", keys.ANGLE),
        _keys("radii", "radius", keys.RADIUS),
        _keys("circles", "circle", keys.CIRCLE),
        _keys("moving", "moving", keys.MOVING),
        _keys("turning", "turning", keys.TURNING),
        _keys("frames", "frame", keys.FRAME),
    )


def _leave_out(
    functions: Mapping[str, Signature], others: Container[str]
) -> Mapping[str, Signature]:
    """The functions without those whose names are among the others."""
    return {name: each for name, each in functions.items() if name not in others}
