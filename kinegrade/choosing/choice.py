"""Choosing among templates by what they ask and what they take: `kinegrade list`."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import TypeAlias

from kinegrade.choosing.demands import APPROACHES, Demands, find_demands
from kinegrade.errors import OptionError, Problem, suggest
from kinegrade.language.message import Fault, Message, Quoted, list_first
from kinegrade.mechanics.joints import JOINTS
from kinegrade.problem.quantities.motion_functions import MOTION_FUNCTIONS
from kinegrade.problem.template.tags import KINDS, TAGS, list_tags
from kinegrade.problem.template.template import Template

Bounds: TypeAlias = tuple[int, int]  # the least and the most


_NAMED = 3  # of the templates that the last wish takes


@dataclass(frozen=True)
class Entry:
    """A template with its tags and what it takes."""

    template: Template
    tags: frozenset[str]
    demands: Demands

    @property
    def family(self) -> str:
        """The kind of mechanism."""
        return self.template.about.family


Test: TypeAlias = Callable[[Entry], bool]


@dataclass(frozen=True)
class Wishes:
    """What templates are to be like, in the words of the options of `kinegrade list`: all of it
    together.
    """

    family: tuple[str, ...] = ()
    tag: tuple[str, ...] = ()
    without_tag: tuple[str, ...] = ()
    joint: tuple[str, ...] = ()
    without_joint: tuple[str, ...] = ()
    asks: tuple[str, ...] = ()
    method: tuple[str, ...] = ()
    difficulty: Bounds | None = None
    minutes: Bounds | None = None


@dataclass(frozen=True)
class _Words:
    """An option that takes words: which were wished, which a template has, which are known beside
    those of the templates, and whether a wished word must be there or must not.
    """

    option: str
    wished: Callable[[Wishes], tuple[str, ...]]
    find: Callable[[Entry], frozenset[str]]
    known: frozenset[str] = frozenset()
    must_have: bool = True

    def make_test(self, word: str) -> Test:
        """Whether a template fulfils the wish for a word."""
        return lambda entry: (word in self.find(entry)) is self.must_have


_JOINTS = frozenset(joint.__name__.lower() for joint in JOINTS)
_WORDS = (
    _Words("--family", lambda wishes: wishes.family, lambda entry: frozenset({entry.family})),
    _Words("--tag", lambda wishes: wishes.tag, lambda entry: entry.tags, frozenset(TAGS)),
    _Words(
        "--without-tag",
        lambda wishes: wishes.without_tag,
        lambda entry: entry.tags,
        frozenset(TAGS),
        must_have=False,
    ),
    _Words("--joint", lambda wishes: wishes.joint, lambda entry: entry.demands.joints, _JOINTS),
    _Words(
        "--without-joint",
        lambda wishes: wishes.without_joint,
        lambda entry: entry.demands.joints,
        _JOINTS,
        must_have=False,
    ),
    _Words(
        "--asks",
        lambda wishes: wishes.asks,
        lambda entry: entry.demands.asked,
        frozenset({*KINDS, *MOTION_FUNCTIONS}),
    ),
    _Words(
        "--method",
        lambda wishes: wishes.method,
        lambda entry: entry.demands.methods,
        frozenset(APPROACHES),
    ),
)


@dataclass(frozen=True)
class _Filter:
    """One wish: how it was stated, and which templates fulfil it."""

    stated: str
    keeps: Test


@dataclass(frozen=True)
class Choice:
    """The templates that are left, and what took the last of them."""

    entries: tuple[Entry, ...]
    complaints: tuple[Problem, ...]


def read_entries(templates: Iterable[Template]) -> tuple[Entry, ...]:
    """What there is to choose from.

    Raises MechanismError where a template cannot be solved at its default values.
    """
    return tuple(make_entry(template) for template in templates)


def make_entry(template: Template) -> Entry:
    """A template with what it takes. Raises as `read_entries`."""
    return Entry(template, list_tags(template), find_demands(template))


def choose(entries: Sequence[Entry], wishes: Wishes) -> Choice:
    """The entries that fulfil all wishes.

    Raises OptionError with every word that no template knows, and the nearest known ones.
    """
    _require_known(entries, wishes)
    left = tuple(entries)
    for each in _list_filters(wishes):
        kept = tuple(filter(each.keeps, left))
        if not kept:
            return Choice((), (_explain_none(each, left),))
        left = kept
    return Choice(left, ())


def count_tags(entries: Iterable[Entry]) -> dict[str, int]:
    """How many entries have each tag: the known tags in their order, then those of authors."""
    found = Counter(tag for entry in entries for tag in entry.tags)
    own = sorted(found.keys() - set(TAGS))
    return {tag: found[tag] for tag in (*TAGS, *own)}


def _explain_none(last: _Filter, left: Sequence[Entry]) -> Message:
    names = list_first([entry.template.name for entry in left], _NAMED)
    return Message("choosing.none-left", option=last.stated, count=len(left), names=names)


def _list_filters(wishes: Wishes) -> Iterator[_Filter]:
    """The wishes one by one."""
    for each in _WORDS:
        for word in each.wished(wishes):
            yield _Filter(f"{each.option} {word}", each.make_test(word))
    for option, bounds, measure in (
        ("--difficulty", wishes.difficulty, _measure_difficulty),
        ("--minutes", wishes.minutes, _measure_minutes),
    ):
        if bounds:
            yield _Filter(f"{option} {_write_bounds(bounds)}", _make_between(measure, bounds))


def _make_between(measure: Callable[[Entry], int], bounds: Bounds) -> Test:
    least, most = bounds
    return lambda entry: least <= measure(entry) <= most


def _measure_difficulty(entry: Entry) -> int:
    return entry.demands.difficulty


def _measure_minutes(entry: Entry) -> int:
    return entry.demands.minutes


def _write_bounds(bounds: Bounds) -> str:
    least, most = bounds
    return str(least) if least == most else f"{least}..{most}"


def _require_known(entries: Sequence[Entry], wishes: Wishes) -> None:
    """Raises OptionError with every word that is not known."""
    faults = []
    for each in _WORDS:
        known = each.known.union(*map(each.find, entries))
        faults += [
            Fault(
                each.option, Message("grammar.unknown", name=Quoted(word)), do=suggest(word, known)
            )
            for word in each.wished(wishes)
            if word not in known
        ]
    if faults:
        raise OptionError(*faults)
