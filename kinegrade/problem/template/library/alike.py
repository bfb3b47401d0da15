"""The shipped template that is nearest to words of a problem, in any language: names of parts and
machines count in all languages at once, other words as they stand; what few templates have counts
most.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from math import log

from kinegrade.errors import TemplateError
from kinegrade.language import ENGLISH, Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.entries import read_entries
from kinegrade.language.known import known_languages
from kinegrade.language.message import Message, Quoted
from kinegrade.problem.template.library.library import find_template_names, load_template
from kinegrade.problem.template.tags import list_tags
from kinegrade.problem.template.template import Template

_PARTS = frozenset(key.split(".")[1] for key in read_entries(ENGLISH, "alike").entries)
_WORD = re.compile(r"[^\W\d_\u4e00-\u9fff]+")
_IDEOGRAPHS = re.compile(r"[\u4e00-\u9fff]+")
_IN_TITLE = 3.0  # times what a feature counts in the statement
_SHORT = 3  # letters of names that begin other words: radius is no Rad
_OF_A_WORD = 0.5  # of what a part counts
_NOT_WANTED = 0.5  # times what a feature of the title counts against it


@dataclass(frozen=True)
class _Features:
    """What a template has in its title, name, family and tags, and in its statement too."""

    title: frozenset[str]
    all: frozenset[str]
    size: int


def find_alike(words: str) -> str:
    """The shipped template that is nearest to the words; the shortest of several. Raises
    TemplateError where none has any of them.

    >>> find_alike("Schubkurbel mit Pleuel"), find_alike("槽轮")
    ('slider-crank', 'geneva-drive')
    """
    wanted = _list_wanted(words)
    shipped = _read_shipped()
    having = [name for name, each in shipped.items() if wanted & each.all]
    if not having:
        raise TemplateError(Message("template.none-alike", words=Quoted(words)))
    weights = _weigh_features(shipped.values())

    def rate(name: str) -> tuple[float, int]:
        own = shipped[name]
        named = _add(weights, wanted & own.title) * _IN_TITLE + _add(weights, wanted & own.all)
        others = own.title & _PARTS - wanted
        return named - _add(weights, others) * _NOT_WANTED, -own.size

    return max(having, key=rate)


def _weigh_features(shipped: Collection[_Features]) -> Mapping[str, float]:
    """What each feature counts: the more, the fewer templates have it of those in its language."""
    counts = Counter(each for features in shipped for each in features.all)
    return {
        each: log((counts.get(each[:3], len(shipped)) + 1) / count)
        * (1 if each in _PARTS else _OF_A_WORD)
        for each, count in counts.items()
    }


def _add(weights: Mapping[str, float], features: Iterable[str]) -> float:
    return sum(weights[each] for each in features)


def find_unmatched(words: str, name: str) -> list[str]:
    """Those of the words that a shipped template has nothing of.

    >>> find_unmatched("slotted unicorn", "rolling-wheel-pin-slotted-rocker")
    ['unicorn']
    """
    own = _read_shipped()[name].all
    return [word for word in words.split() if not _list_wanted(word) & own]


@cache
def _read_shipped() -> Mapping[str, _Features]:
    """The features of all shipped templates."""
    templates = {name: load_template(name) for name in find_template_names()}
    return {name: _read_features(template) for name, template in templates.items()}


def _read_features(template: Template) -> _Features:
    """What a template is called and tagged, and what its statement says, in all its languages."""
    about = template.about
    named = " ".join((template.name, about.family, *list_tags(template)))
    title = {*_list_parts(named), *_list_words(named, ENGLISH)}
    for language, text in about.title.by_language:
        title |= {*_list_parts(text), *_list_words(text, language)}
    said = set(title)
    for language, text in template.words.statement.by_language:
        said |= {*_list_parts(text), *_list_words(text, language)}
    return _Features(frozenset(title), frozenset(said), len(template.file.text))


def _list_wanted(text: str) -> frozenset[str]:
    """The parts that words name, and the words as ones of each language."""
    words = (each for language in known_languages() for each in _list_words(text, language))
    return frozenset((*_list_parts(text), *words)) - {_mark(each) for each in known_languages()}


def _list_parts(text: str) -> Iterator[str]:
    """The parts and machines that a text names."""
    plain = text.casefold()
    return (part for part in _PARTS if _make_pattern(part).search(plain))


def _list_words(text: str, language: Language) -> Iterator[str]:
    """The words of a text as ones of a language, of Chinese the pairs of its characters, and the
    language.
    """
    plain = text.casefold()
    yield _mark(language)
    yield from (_mark(language) + word for word in _WORD.findall(plain))
    for run in _IDEOGRAPHS.findall(plain):
        pairs = (run[place : place + 2] for place in range(max(len(run) - 1, 1)))
        yield from (_mark(language) + pair for pair in pairs)


def _mark(language: Language) -> str:
    """What stands before the words of a language; no part is called so."""
    return f"{language}:"


@cache
def _make_pattern(part: str) -> re.Pattern[str]:
    """A part's names in all languages: they begin or end a word, as in Zahnstangen and
    Viergelenkgetriebe, short ones end it, but for ideographs.
    """
    spelled = "|".join(open_catalogue(each).text(f"alike.{part}") for each in known_languages())
    return re.compile("|".join(map(_write_name, spelled.split("|"))))


def _write_name(name: str) -> str:
    """A name of a part as a pattern."""
    if _IDEOGRAPHS.match(name):
        return name
    ending = rf"{re.escape(name)}(?:e?s)?\b"
    return ending if len(name) <= _SHORT else rf"\b{re.escape(name)}|{ending}"
