"""The claims that the sentences of a statement make, read by those that the catalogues know."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from math import radians

from kinegrade.problem.solution import Solution
from kinegrade.problem.template.notation import write_point_symbol
from kinegrade.problem.template.template import Parameter, Template
from kinegrade.proof.claims.patterns import SENSES, list_words, make_pattern, write_words
from kinegrade.sign_conventions import Convention

_ENDS = re.compile(r"[;。；]|(?<!\b\w)[.](?=\s|$)")  # of a sentence; i.e. is none
DIFFERENT = 1e-6  # of a length: less is what doubles leave


def read_claims(template: Template, kind: str, before: str = "") -> Iterator[dict[str, str]]:
    """What the sentences of a kind name, in whatever language they are; as `said` what they say."""
    return read_texts(template.words.statement.texts, kind, before)


def read_texts(texts: Iterable[str], kind: str, before: str = "") -> Iterator[dict[str, str]]:
    """The same of any texts."""
    for text in texts:
        for sentence in list_words(kind):
            for match in make_pattern(sentence, before).finditer(text):
                if before and _ends_between(text[: match.start()]):
                    continue  # $M$ lies between $O$ and this one
                ahead = _ENDS.split(text[: match.start()])[-1]
                if is_of_another_case(ahead + match[0] + _ENDS.split(text[match.end() :])[0]):
                    continue
                said = " ".join(match[0].split())
                yield {**match.groupdict(""), "said": said, "ahead": ahead}


def list_sentences_of(text: str) -> Iterator[str]:
    """The sentences of a text that speak of the instant at hand."""
    yield from (each for each in _ENDS.split(text) if not is_of_another_case(each))


def is_of_another_case(sentence: str) -> bool:
    """Whether a sentence speaks of another instant or of what would be: half a turn later."""
    return re.search(write_words("another-case"), sentence, re.IGNORECASE) is not None


def _ends_between(text: str) -> bool:
    """Whether the next letter is the second of two between which something else lies."""
    return any(
        re.search(rf"{make_pattern(words, '').pattern}\s*$", text, re.ASCII)
        for words in list_words("between")
    )


def name_senses(said: str) -> set[Convention]:
    """The senses that words name: "to the right of" a point is none, and counter-clockwise is not
    clockwise.
    """
    return {sense for sense in SENSES if re.search(write_words(SENSES[sense]), said, re.ASCII)}


def find_points(template: Template, *letters: str) -> list[str]:
    """The points that go by these letters; none where one of them is no point's."""
    labels = template.figure.labels
    named = {
        _plain(labels.get(name) or write_point_symbol(name)): name
        for name in template.scheme.points
    }
    found = [named.get(_plain(letter), "") for letter in letters]
    return found if all(found) else []


def _plain(symbol: str) -> str:
    """O_{1} is O_1."""
    return symbol.replace("{", "").replace("}", "")


def measure_angle(each: Solution, given: Parameter) -> float:
    """The value of an angle in radians."""
    value = each.parameters[given.name].value
    return radians(value) if given.unit.degrees else float(value)
