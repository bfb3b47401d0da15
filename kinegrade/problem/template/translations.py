"""Readers of texts that a file gives by language, `{ en = "...", zh = "..." }`, or once for all."""

from __future__ import annotations

from kinegrade.errors import FieldError
from kinegrade.files.fields.values import text
from kinegrade.language.known import read_language
from kinegrade.language.message import Message
from kinegrade.problem.template.translated import Translated

BY_LANGUAGE = Message("texts.by-language", example='{ en = "..." }')
_EXPECTED = Message("texts.one-or-by-language", texts=BY_LANGUAGE)


def translated(value: object) -> Translated:
    """A text in the languages that are given, without blanks around it.

    >>> translated({"en": "crank ", "zh": "曲柄"}).in_language("en")
    'crank'
    """
    if isinstance(value, dict):
        return translated_by_language(value)
    try:
        return Translated(plain=text(value).strip())
    except FieldError as error:
        raise FieldError(error.what, _EXPECTED) from error


def translated_by_language(texts: dict[str, object]) -> Translated:
    """The same from a table of languages. Raises FieldError where it names none, or an unknown
    one.
    """
    if not texts:
        raise FieldError(Message("texts.of-no-language"), _EXPECTED)
    return Translated(
        tuple((read_language(code), text(words).strip()) for code, words in texts.items())
    )
