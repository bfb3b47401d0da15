"""Words that are read from what people type: each entry lists its spellings, separated by "|", and
those of all languages are read alike.
"""

from __future__ import annotations

import re
from functools import cache

from kinegrade.language import ENGLISH
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.known import known_languages
from kinegrade.language.message import Message

_SEPARATOR = "|"


@cache
def list_spellings(entry: Message) -> tuple[str, ...]:
    """The spellings of an entry in all languages, the longest first.

    >>> list_spellings(Message("typing.unit-km"))[-2:]
    ('公里', '千米')
    """
    spellings = list_preferred_spellings(entry)
    return tuple(sorted(spellings, key=lambda spelling: (-len(spelling), spelling)))


@cache
def list_preferred_spellings(entry: Message) -> tuple[str, ...]:
    """The spellings of an entry in the order of the catalogues, the best first: those of English,
    then those of all other languages.
    """
    languages = dict.fromkeys((ENGLISH, *known_languages()))
    texts = [open_catalogue(language).write(entry) for language in languages]
    return tuple(dict.fromkeys(spelling for text in texts for spelling in text.split(_SEPARATOR)))


@cache
def match_spellings(entry: Message) -> str:
    """A regular expression for any of them."""
    return f"(?:{'|'.join(map(re.escape, list_spellings(entry)))})"


def is_written_apart(word: str) -> bool:
    """Whether blanks separate a word from the next: in scripts with capitals, such as Latin.

    >>> is_written_apart("per"), is_written_apart("每")
    (True, False)
    """
    return word.upper() != word.lower()
