"""Claims of the way in which parts go that are named by letters or nouns: `the drum turns
clockwise`, `load $A$ is ascending`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache

from kinegrade.language.message import Message
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.template import Template
from kinegrade.proof.claims.patterns import SENSES, list_words, write_words
from kinegrade.proof.claims.reading import name_senses
from kinegrade.proof.clauses.parts import STILL, Part
from kinegrade.proof.clauses.sentences import Mention, Sentence, has_condition, list_sentences
from kinegrade.proof.clauses.subjects import find_subject
from kinegrade.sign_conventions import Convention

_TURNS: Mapping[Convention, float] = {"ccw": 1.0, "cw": -1.0}
_MOVES: Mapping[Convention, Vector] = {
    "+x": Vector(1.0, 0.0),
    "-x": Vector(-1.0, 0.0),
    "+y": Vector(0.0, 1.0),
    "-y": Vector(0.0, -1.0),
}
_IN_VERBS: tuple[tuple[Convention, str], ...] = (("+y", "goes-up"), ("-y", "goes-down"))


@dataclass(frozen=True)
class _Going:
    """What is said to go in a sense."""

    said: str
    subject: Mention
    sense: Convention


def find_wrong_goings(template: Template, examples: Sequence[Solution]) -> Iterator[Message]:
    """The senses that nothing has that may be meant, in all instances or in some."""
    for sentence in list_sentences(template):
        if has_condition(sentence.text):
            continue
        for going in _list_goings(sentence):
            wrong = [_is_backwards(going, each) for each in examples]
            if wrong and all(wrong):
                yield Message("template.other-sense", said=going.said)
            elif any(wrong):
                yield Message("template.other-sense-in-some", said=going.said)


def _list_goings(sentence: Sentence) -> Iterator[_Going]:
    """The senses in which a sentence says that known parts go."""
    for sense, kind in _IN_VERBS:
        for verb in _find_words(kind).finditer(sentence.text):
            if _is_slope(sentence, verb):
                continue
            yield from _make_going(sentence, verb, verb.end(), sense)
    verbs = [*_find_words("goes").finditer(sentence.text)]
    for match in _find_words(*SENSES.values()).finditer(sentence.text):
        before = [verb for verb in verbs if verb.end() <= match.start()]
        senses = name_senses(match[0]) or name_senses(match[0].lower())
        if before and len(senses) == 1 and not _is_open(sentence, match):
            yield from _make_going(sentence, before[-1], match.end(), next(iter(senses)))


def _make_going(
    sentence: Sentence, verb: re.Match[str], end: int, sense: Convention
) -> Iterator[_Going]:
    """That the subject of a verb goes in a sense, where nothing else is spoken of before that."""
    subject = find_subject(sentence, verb.start())
    if _find_words("another-matter", "no-going").search(sentence.text, verb.end(), end):
        return
    another_clause = rf"[(:]|,\s*(?:{'|'.join(list_words('relative-pronoun'))})\b"
    if re.search(another_clause, sentence.text[verb.end() : end], re.IGNORECASE):
        return
    between = (each for each in sentence.mentions if verb.end() <= each.start < end)
    if subject is not None and all(each.attached for each in between):
        start = subject.start if subject in sentence.mentions else verb.start()
        yield _Going(" ".join(sentence.text[start:end].split()), subject, sense)


def _is_slope(sentence: Sentence, verb: re.Match[str]) -> bool:
    """Whether a verb may say how a line slopes: `rises from $O$ to the right`."""
    way = re.compile(rf"\s+(?:{write_words('way-of-slope')})", re.IGNORECASE)
    return way.match(sentence.text, verb.end()) is not None


def _is_open(sentence: Sentence, match: re.Match[str]) -> bool:
    """Whether the words of a sense say how the pace is, or leave it open between two senses."""
    before, behind = sentence.text[: match.start()], sentence.text[match.end() :]
    senses = write_words(*SENSES.values())
    joined = write_words("or")
    return any(
        (
            re.search(rf"(?:{write_words('pace-word')})\s*$", before, re.IGNORECASE),
            re.search(rf"(?:{senses})\s*,?\s*(?:{joined})\s*$", before, re.IGNORECASE),
            re.match(rf"\s*,?\s*(?:{joined})\s*(?:{senses})", behind, re.IGNORECASE),
        )
    )


@cache
def _find_words(*kinds: str) -> re.Pattern[str]:
    return re.compile(write_words(*kinds), re.IGNORECASE)


def _is_backwards(going: _Going, each: Solution) -> bool:
    """Whether all that some part of the subject may be goes the other way in an instance."""
    return any(
        all(_goes_back(part, going.sense, each) for part in parts) for parts in going.subject.things
    )


def _goes_back(part: Part, sense: Convention, each: Solution) -> bool:
    """Whether a part goes the other way, all its points or bodies."""
    if sense in _TURNS:
        rates = [rate * _TURNS[sense] for rate in part.list_rates(each)]
    else:
        rates = [float(each.dot(_MOVES[sense])) for each in part.list_velocities(each)]
    return bool(rates) and max(rates) < -STILL
