"""What the words of a sentence are said of: which of the parts named before them is the subject."""

from __future__ import annotations

import re
from dataclasses import replace
from functools import cache

from kinegrade.proof.claims.patterns import write_words
from kinegrade.proof.clauses.sentences import Mention, Sentence


def find_subject(sentence: Sentence, place: int) -> Mention | None:
    """What the words at a place are said of; None where that is not certain."""
    named = _list_before(sentence, place)
    between = sentence.text[named[-1].end : place] if named else ""
    if re.match(rf"\s*,\s*(?:{write_words('relative-pronoun')})", between, re.IGNORECASE):
        return _keep_known(named[-1])
    restricting = rf"(?:{write_words('restricting-pronoun')})\s*$"
    restricted = re.search(restricting, sentence.text[:place], re.IGNORECASE)
    if restricted:
        right_before = sentence.text[named[-1].end : restricted.start()] if named else ""
        return _keep_known(named[-1]) if right_before.isspace() else None
    for resumed in (_find_behind_insertion, _find_of_two_verbs):
        subject = resumed(sentence, place)
        if subject is not None:
            return _keep_known(subject)
    return _find_latest(sentence, place)


def find_neighbour(sentence: Sentence, place: int) -> Mention | None:
    """What the words at a place stand right behind, as `with $A$ above`, or are said of."""
    named = [each for each in sentence.mentions if sentence.text[each.end : place].isspace()]
    return next(iter(named), None) or find_subject(sentence, place)


def list_other_readings(sentence: Sentence, place: int) -> list[Mention]:
    """What the words at a place may be said of as well as of the subject: what is named last, with
    no verb between (`about the pin $G$, to the right of $C$`), or the last of several, which may
    begin a clause (`at $O$, and $B$ lies to the right of $C$`).
    """
    named = _list_before(sentence, place)
    if not named or not named[-1].is_known:
        return []
    last, between = named[-1], sentence.text[named[-1].end : place]
    verbs = [match.start() for match in _write_verb().finditer(between)]
    if not verbs:
        return [last]
    begins = len(last.things) > 1 and not re.search(rf",|{write_words('or')}", between[: verbs[0]])
    return [_keep_last(last)] if begins else []


def _list_before(sentence: Sentence, place: int) -> list[Mention]:
    return [each for each in sentence.mentions if each.end <= place]


def _find_behind_insertion(sentence: Sentence, place: int) -> Mention | None:
    """What stands before an insertion that a comma closes before the verb: `the load $A$, which
    balances the load $B$, hangs`.
    """
    named = _list_before(sentence, place)
    closing = [*_write_resumed(",").finditer(sentence.text, named[-1].end if named else 0)]
    closing = [match for match in closing if match.start() < place]
    if not named or not closing:
        return None
    ahead = sentence.text[: closing[-1].start()]
    opened = [
        _keep_last(each) if each.attached else each
        for each in named
        if re.match(r"\s*,", ahead[each.end :])
        and (not each.attached or len(each.things) > 1)  # at $O$, and $B$, the slider, lies
    ]
    return opened[-1] if opened else None


def _find_of_two_verbs(sentence: Sentence, place: int) -> Mention | None:
    """What two verbs are said of that `and` joins: `the load $A$ balances $B$ and hangs`."""
    named = _list_before(sentence, place)
    joined = _write_resumed(rf"(?:{write_words('or')})")
    joints = [*joined.finditer(sentence.text, named[-1].end if named else 0)]
    if not joints or joints[-1].start() >= place:
        return None
    start = _find_clause(sentence, joints[-1].start())
    free = [each for each in named if not each.attached and each.start >= start]
    pronoun = _write_pronoun().search(sentence.text, start, joints[-1].start())
    if pronoun and (not free or pronoun.start() < free[0].start):
        return _find_antecedent(sentence, pronoun.start())
    return free[0] if free else None


def _find_clause(sentence: Sentence, place: int) -> int:
    """Where the clause of a place begins: behind a comma with a conjunction, or with the noun of
    which a pronoun behind a comma speaks.
    """
    start = 0
    for match in _write_opening().finditer(sentence.text, 0, place):
        nouns = [each for each in sentence.mentions if each.start <= match.start("word") < each.end]
        before = [each for each in sentence.mentions if each.end == match.start()]
        if before and match["pronoun"] and not nouns:
            start = before[0].start
        elif match["pronoun"] is None:
            start = match.end()
    return start


def _find_latest(sentence: Sentence, place: int) -> Mention | None:
    """What is named last without a preposition, or that for which a later pronoun stands."""
    free = [each for each in _list_before(sentence, place) if not each.attached]
    said = [match.start() for match in _write_pronoun().finditer(sentence.text, 0, place)]
    if said and (not free or free[-1].end <= said[-1]):
        return _keep_known(_find_antecedent(sentence, said[-1]))
    return _keep_known(free[-1] if free else None)


def _find_antecedent(sentence: Sentence, place: int) -> Mention | None:
    """What a pronoun stands for: what its sentence began with, or else the one before."""
    before = sentence.before.mentions if sentence.before else ()
    for named in (_list_before(sentence, place), before):
        free = [each for each in named if not each.attached]
        if free:
            return free[0]
    return None


def _keep_last(mention: Mention) -> Mention:
    """The last of several things that are named together."""
    return replace(mention, things=mention.things[-1:])


def _keep_known(mention: Mention | None) -> Mention | None:
    return mention if mention and mention.is_known else None


@cache
def _write_pronoun() -> re.Pattern[str]:
    return re.compile(rf"(?:{write_words('personal-pronoun')})", re.IGNORECASE)


@cache
def _write_verb() -> re.Pattern[str]:
    return re.compile(write_words("finite-verb"), re.IGNORECASE)


@cache
def _write_resumed(behind: str) -> re.Pattern[str]:
    """A verb right behind a comma or a conjunction."""
    return re.compile(rf"{behind}\s*(?:{write_words('finite-verb')})", re.IGNORECASE)


@cache
def _write_opening() -> re.Pattern[str]:
    """What opens a clause: a comma with a conjunction or with a relative pronoun."""
    pronoun = rf"(?P<pronoun>{write_words('relative-pronoun')})"
    return re.compile(rf"\s*,\s*(?P<word>{pronoun}|{write_words('opens-clause')})", re.IGNORECASE)
