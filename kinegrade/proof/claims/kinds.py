"""The kinds of quantities that words name, "angular velocity", against those that units have."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import assert_never

from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.known import known_languages
from kinegrade.language.message import Fault, Message, Quoted
from kinegrade.mechanics.vector_equation import Level
from kinegrade.numbers.units import Unit
from kinegrade.problem.template.hints import FigureHints, Moving, Turning
from kinegrade.problem.template.meaning.senses import find_positive
from kinegrade.problem.template.template import Ask, Parameter, Template
from kinegrade.problem.template.translated import Translated
from kinegrade.proof.claims.patterns import begins_a_word, list_words
from kinegrade.proof.claims.reading import name_senses, read_claims
from kinegrade.sign_conventions import OPPOSITE

_Powers = tuple[int, int, int]
_NUMBER: _Powers = (0, 0, 0)  # a factor stands for the size that it gives
_POWERS_OF_TIME: Mapping[Level, int] = {"velocity": -1, "acceleration": -2}

# Rates by the powers of length, time and angle of their units; words of the first contain others
_KINDS = {
    (0, -2, 1): "angular-acceleration",
    (0, -1, 1): "angular-velocity",
    (1, -2, 0): "acceleration",
    (1, -1, 0): "velocity",
}
_CHANGES = {"angular-velocity": "angular-acceleration", "velocity": "acceleration"}


def note_other_kinds(template: Template) -> Iterator[Message]:
    """A remark for each ask and given whose words name another kind of rate than its unit has:
    "angular velocity" in rad/s^2.
    """
    stated: tuple[Parameter | Ask, ...] = (
        *template.asks.values(),
        *template.parameters.values(),
    )
    for each in stated:
        own = _KINDS.get(_list_powers(each.unit))
        named = ({*name_kinds(text)} for text in each.means.texts)
        fitting = {own, "velocity"} if each.unit.counts_turns else {own}  # "speed" in r/min
        if own and any(kinds and not kinds & fitting for kinds in named):
            yield Message("template.another-kind", name=each.name, unit=each.unit.printed)


def note_kinds_said(template: Template) -> Iterator[Message]:
    """A remark for each given behind the word for another kind of rate than its unit has: `the
    acceleration {{ v }}` of one in m/s.
    """
    claims = [*read_claims(template, "named")]
    for claim in claims:
        longer = (each["said"] for each in claims if each["said"] != claim["said"])
        if any(said.endswith(claim["said"]) for said in longer):
            continue  # the velocity of an angular velocity
        given = template.parameters.get(claim["given"])
        own = _KINDS.get(_list_powers(given.unit)) if given else None
        change = [word for word in list_words("rate-of-change") if word in claim["ahead"].lower()]
        named = {*list(name_kinds(" ".join((*change, claim["said"]))))[-1:]}
        fitting = {own, "velocity"} if given and given.unit.counts_turns else {own}
        if given and own and named and not named & fitting:
            said, unit = claim["said"], given.unit.printed
            yield Message("template.other-kind-said", said=said, unit=unit)


def find_wrong_signs(template: Template) -> Iterator[Fault]:
    """A fault for each sign in words that names the sense opposite to the one in which its quantity
    is positive: "positive clockwise" of omega(AB).
    """
    for name, ask in template.asks.items():
        if isinstance(ask.sign, Translated):
            positive = find_positive(ask)
            for said in ask.sign.texts:
                if positive and name_senses(said) == {OPPOSITE[positive]}:
                    what = Message("template.sign-other-way", said=said, sign=Quoted(positive))
                    yield Fault(f"asks.{name}.sign", what)


def find_marks_of_other_kinds(template: Template) -> Iterator[Fault]:
    """A fault for each mark of the figure that carries the symbol of a given of another kind: an
    angle at a dimension, a speed at an arrow that turns.
    """
    givens = {each.symbol: each for each in template.parameters.values()}
    for symbol, powers in _list_marks(template.figure):
        given = givens.get(symbol)
        if given is not None and _list_powers(given.unit) not in {powers, _NUMBER}:
            what = Message(
                "template.mark-of-another-kind", name=given.name, unit=given.unit.printed
            )
            yield Fault("figure", what, do=Message("template.mark-its-own"))


def _list_marks(figure: FigureHints) -> Iterator[tuple[str, _Powers]]:
    """The symbols of the marks of a figure, with the kind of value that each stands for."""
    yield from ((each.symbol, (1, 0, 0)) for each in figure.lengths)
    yield from ((each.symbol, (1, 0, 0)) for each in figure.radii)
    yield from ((each.symbol, (0, 0, 1)) for each in figure.angles)
    for arrow in figure.arrows:
        match arrow:
            case Turning():
                yield arrow.symbol, (0, _POWERS_OF_TIME[arrow.level], 1)
            case Moving():
                yield arrow.symbol, (1, _POWERS_OF_TIME[arrow.level], 0)
            case _:
                assert_never(arrow)


def _list_powers(unit: Unit) -> _Powers:
    """The powers of length, time and angle in a unit."""
    return unit.length, unit.time, unit.angle


def name_kinds(said: str) -> Iterator[str]:
    """The kinds of rates that a text names; an angular velocity is no velocity besides, and the
    rate of change of a speed is an acceleration.
    """
    text = said.lower()
    kinds = [*_name_kinds_apart(text)]
    if any(word in text for word in list_words("rate-of-change")):
        kinds = [_CHANGES[kind] for kind in kinds if kind in _CHANGES]
    elif any(word in text for word in list_words("changing")):
        kinds += [_CHANGES[kind] for kind in kinds if kind in _CHANGES]  # by how much it grows
    yield from kinds


def _name_kinds_apart(text: str) -> Iterator[str]:
    """The kinds that a text names, those first whose words contain others."""
    for word in list_words("rate-of-change"):
        text = text.replace(word, "")  # which may end in the word for a speed
    for kind in _KINDS.values():
        for language in known_languages():
            for word in open_catalogue(language).text(f"template.kind-{kind}").split("|"):
                if begins_a_word(word, text, language):
                    yield kind
                    text = text.replace(word, "")
