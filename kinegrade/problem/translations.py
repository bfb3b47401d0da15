"""Readers of texts that a file gives in all languages: `{ en = "...", zh = "..." }`."""

from __future__ import annotations

from kinegrade.errors import FieldError
from kinegrade.fields.values import found, text
from kinegrade.language import LANGUAGES
from kinegrade.problem.template import Translated

_EXAMPLE = "{ " + ", ".join(f'{language} = "..."' for language in LANGUAGES) + " }"


def translated(value: object) -> Translated:
    """A text in every language, without blanks around it.

    >>> translated({"en": "crank ", "zh": "曲柄"})
    Translated(en='crank', zh='曲柄')
    """
    if not isinstance(value, dict):
        raise FieldError(found(value), f"texts in all languages, {_EXAMPLE}")
    if set(value) != set(LANGUAGES):
        named = ", ".join(map(str, value)) or "no language"
        raise FieldError(f"a table of {named}", f"texts in all languages, {_EXAMPLE}")
    return Translated(text(value["en"]).strip(), text(value["zh"]).strip())


def translated_or_one(value: object) -> Translated:
    """A text in every language, or one text that serves for all."""
    if isinstance(value, dict):
        return translated(value)
    try:
        one = text(value).strip()
    except FieldError as error:
        raise FieldError(error.what, f"a text, or texts {_EXAMPLE}") from error
    return Translated(one, one)
