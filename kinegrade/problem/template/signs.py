"""The sign convention of an ask: a usual one, by its keyword, or the author's own in words."""

from __future__ import annotations

from collections.abc import Mapping

from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.message import Message
from kinegrade.problem.template.translated import Translated
from kinegrade.sign_conventions import Convention

Sign = Convention | Translated

_WORDS: Mapping[Convention, Message] = {
    "magnitude": Message("texts.sign-magnitude"),
    "ccw": Message("texts.sign-counter-clockwise"),
    "cw": Message("texts.sign-clockwise"),
    "+x": Message("texts.sign-right"),
    "-x": Message("texts.sign-left"),
    "+y": Message("texts.sign-up"),
    "-y": Message("texts.sign-down"),
    "unsigned": Message("texts.sign-unsigned"),
    "signed": Message("texts.sign-signed"),
}


def write_sign(sign: Sign, language: Language) -> str:
    """A sign convention in words.

    >>> write_sign("ccw", Language("en"))
    'counter-clockwise positive'
    """
    if isinstance(sign, Translated):
        return sign.in_language(language)
    return open_catalogue(language).write(describe_convention(sign))


def describe_convention(sign: Convention) -> Message:
    """What a usual sign convention says."""
    return _WORDS[sign]
