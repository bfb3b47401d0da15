"""The sentences of a statement, and the words in them that name parts of the mechanism."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache

from kinegrade.problem.template.template import Template
from kinegrade.proof.claims.patterns import HAN, LETTER, list_words, write_words
from kinegrade.proof.claims.reading import find_points, is_of_another_case
from kinegrade.proof.clauses.parts import Kind, Part, Parts

_ENDS = re.compile(r"[;。；!?]|(?<!\b\w)[.](?=\s|$)|:\s")  # of a sentence; i.e. is none
_NAMED = rf"\$\s*(?-i:(?:{LETTER})+)\s*\$"
_LETTERS = re.compile(LETTER)
_WORD = r"[^\W\d_](?:[^\W\d_]|-)*"
_KINDS: tuple[Kind, ...] = ("wheel", "slider", "guide", "load", "crank")
_LEAST = 3  # letters of a German noun that ends its phrase


@dataclass(frozen=True)
class Mention:
    """Words of a sentence that name something, from `start` to `end`: for each of several things
    (`$B$ and $C$`) what it may be; nothing where that is not known.

    What is `attached` by a preposition is not what the sentence speaks of.
    """

    start: int
    end: int
    said: str
    things: tuple[tuple[Part, ...], ...]
    attached: bool

    @property
    def is_known(self) -> bool:
        """Whether it is known what all of it may be."""
        return bool(self.things) and all(self.things)


@dataclass(frozen=True)
class Sentence:
    """A sentence with what it names, behind the one `before` it."""

    text: str
    mentions: tuple[Mention, ...]
    before: Sentence | None = None


def list_sentences(template: Template) -> Iterator[Sentence]:
    """The sentences of a statement that speak of the instant at hand, in all languages."""
    parts = Parts(template)
    for text in template.words.statement.texts:
        if re.search(HAN, text):
            continue  # its subjects stand in no article, and are often left out
        before = None
        for words in _ENDS.split(text):
            sentence = Sentence(words, tuple(_list_mentions(parts, words)), before)
            before = sentence
            if not is_of_another_case(words):
                yield sentence


def list_named(template: Template, text: str) -> Iterator[tuple[Part, ...]]:
    """What the letters and numbers of a text may be, nothing that a noun alone says."""
    for mention in _list_mentions(Parts(template), text):
        if re.search(r"[\d$]", mention.said):
            yield from mention.things


def has_condition(text: str) -> bool:
    """Whether words speak of a condition, of a sign or of what is relative or not so."""
    return re.search(write_words("condition"), text, re.IGNORECASE) is not None


def _list_mentions(parts: Parts, text: str) -> Iterator[Mention]:
    """The words of a sentence that name something, one behind the other."""
    end = 0
    for match in _write_mention().finditer(text):
        words = [*re.findall(_WORD, match["words"] or match["phrase"] or "")]
        last = match.end()
        if match["letters"]:
            things = [*_read_letters(parts, match["letters"])]
        elif match["numbers"]:
            numbers = re.findall(r"\d+", match["numbers"])
            things = [tuple(parts.find_numbered(each)) for each in numbers]
        else:
            words = _cut_noun(words)
            if words[-1] in {*list_words("generic-distance")} or _is_pronoun(match):
                continue
            last = match.start("phrase") + match["phrase"].index(words[-1]) + len(words[-1])
            things = [_read_noun(parts, words)]
        said = " ".join(text[match.start() : last].split())
        article = (match["det"] or match["article"] or "").strip()
        attached = _is_attached(text[: match.start()], text[end : match.start()], article)
        yield Mention(match.start(), last, said, tuple(things), attached)
        end = last


@cache
def _write_mention() -> re.Pattern[str]:
    """Letters behind a noun, a noun behind an article, or a noun with numbers."""
    stop = rf"(?!(?:{write_words('no-noun', 'determiner', 'attaching')}))"
    word = rf"(?:{stop}{_WORD})"
    more = rf"(?:\s*(?:{write_words('listed')}|, and)\s*(?:the\s+)?{_NAMED})*"
    numbers = rf"\d+(?:\s*(?:{write_words('listed')}|, and)\s*\d+)*"
    return re.compile(
        rf"(?<![\w$\\-])(?:(?P<det>(?:{write_words('determiner')})\s+)?"
        rf"(?:(?P<words>(?:{word}\s+){{0,4}})(?P<letters>{_NAMED}{more})"
        rf"|(?P<noun>{word})\s+(?P<numbers>{numbers})(?!\w))"
        rf"|(?P<article>(?:{write_words('determiner')})\s+)"
        rf"(?P<phrase>{word}(?:\s+{word}){{0,4}}))",
        re.IGNORECASE,
    )


def _cut_noun(words: Sequence[str]) -> list[str]:
    """The words of a phrase up to its noun, where a capital tells which it is."""
    for place, word in enumerate(words):
        if word[0].isupper() and len(word) >= _LEAST:
            return [*words[: place + 1]]
    return [*words]


def _read_letters(parts: Parts, named: str) -> Iterator[tuple[Part, ...]]:
    """What letters between dollar signs are: a point, two of a line, a body."""
    for said in re.findall(_NAMED, named):
        letters = said.strip("$ ")
        points = find_points(parts.template, *_LETTERS.findall(letters))
        bodies = [each.name for each in parts.template.scheme.bodies if each.name == letters]
        found = [parts.find_body(name) for name in bodies if len(points) != 1]
        yield tuple(found or ([parts.find_points(points)] if points else []))


def _read_noun(parts: Parts, words: Sequence[str]) -> tuple[Part, ...]:
    """What a noun may be, by the statement or by its kind, with as many words before it as help."""
    for start in range(len(words)):
        things = [*parts.nouns.find_things(" ".join(words[start:]))]
        lettered = [each for each in things if each.points]
        if things:
            return tuple(dict.fromkeys(map(parts.find_part, lettered or things)))
    for kind in _KINDS:
        known = {word.lower() for word in list_words(f"kind-{kind}")}
        if words[-1].lower() in known or " ".join(words[-3:]).lower() in known:
            return tuple(parts.find_kind(kind))
    return ()


def _is_pronoun(match: re.Match[str]) -> bool:
    """Whether what seems an article is one of German pronouns, as no noun is behind it."""
    pronouns = {*list_words("relative-pronoun")}
    return match["article"].strip() in pronouns and match["phrase"] == match["phrase"].lower()


def _is_attached(before: str, between: str, article: str) -> bool:
    """Whether a preposition stands right before or in the article, or whether that is a genitive
    right behind another noun.
    """
    attaching = write_words("attaching")
    if re.search(rf"(?:{attaching})\s*$", before, re.IGNORECASE):
        return True
    if re.fullmatch(attaching, article, re.IGNORECASE):
        return True
    return bool(article and before.strip() and not between.strip() and between != before)
