"""Options that are one of a few words: what a type checker sees, a notebook is told in one line."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import fields
from types import NoneType
from typing import TYPE_CHECKING, Literal, get_args, get_origin, get_type_hints

from kinegrade.errors import OptionError, suggest
from kinegrade.language import Language
from kinegrade.language.known import known_languages
from kinegrade.language.message import Fault, Message, Quoted

if TYPE_CHECKING:
    from _typeshed import DataclassInstance


def require_known(options: DataclassInstance) -> None:
    """Raises OptionError with every field that holds a word which its type does not name."""
    hints = get_type_hints(type(options))
    faults = [
        fault
        for field in fields(options)
        for fault in _find_faults(field.name, getattr(options, field.name), hints[field.name])
    ]
    if faults:
        raise OptionError(*faults)


def require_word(name: str, value: str, words: Iterable[str]) -> None:
    """Raises OptionError where the value of the option `name` is none of the words."""
    if value not in (known := list(words)):
        raise OptionError(_explain_unknown(name, value, known))


def find_language(name: str) -> Language:
    """The language of that name. Raises OptionError for one that has no catalogues.

    >>> find_language("xx")
    Traceback (most recent call last):
    kinegrade.errors.OptionError: language: unknown: "xx" - known here: ...
    """
    require_word("language", name, known_languages())
    return Language(name)


def _find_faults(name: str, value: object, hint: object) -> Iterator[Fault]:
    words = [str(word) for word in _list_words(hint)]
    for each in value if isinstance(value, tuple) else (value,):
        if words and str(each) not in words and not (each is None and NoneType in get_args(hint)):
            yield _explain_unknown(name, str(each), words)


def _list_words(hint: object) -> Iterator[object]:
    """The words that a type names, alone or beside None, or as the items of a tuple."""
    if get_origin(hint) is Literal:
        yield from get_args(hint)
        return
    for part in get_args(hint):
        yield from _list_words(part)


def _explain_unknown(name: str, value: str, words: Iterable[str]) -> Fault:
    what = Message("grammar.unknown", name=Quoted(value))
    return Fault(name, what, do=suggest(value, words))
