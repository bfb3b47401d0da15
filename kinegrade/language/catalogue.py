r"""A catalogue writes in one language what messages say.

A place in a text is `<name>`; `<Name>` begins with a capital letter; `<name:dative>` takes that
form of a noun. (Braces are LaTeX's.) Whatever fills a place is inserted as it is, but for a first
word that the language writes together with the one before: "von" and "dem Rad" are "vom Rad".
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from decimal import Decimal
from fractions import Fraction
from functools import cache, cached_property
from typing import assert_never

from kinegrade.language import Language
from kinegrade.language.entries import NOUN, Entries, Entry, read_entries
from kinegrade.language.lines import shorten, show_in_one_line
from kinegrade.language.message import ByLanguage, Fault, Listing, Message, Noun, Part, Quoted

PLACE = re.compile(r"<([A-Za-z][a-z_]*)(?::([a-z]+))?>")
FORM_SEPARATOR = "|"
_PLACE_AFTER_WORD = re.compile(rf"(?:\b(\w+) )?{PLACE.pattern}")
_LONGEST_PART = 300  # characters of each part of a fault


@cache
def open_catalogue(language: Language) -> Catalogue:
    """The catalogue of a language; its files are read when they are needed."""
    return Catalogue(language)


class Catalogue:
    """The words of one language.

    >>> english = open_catalogue(Language("en"))
    >>> english.write(Message("grammar.expected", expected="a number"))
    'expected a number'
    """

    def __init__(self, language: Language) -> None:
        self.language = language

    def text(self, key: str, /, **parts: Part) -> str:
        """An entry with its places filled. Raises LookupError where there is no such entry or a
        part is missing, which is a fault of the program.
        """
        return self.write(Message(key, **parts))

    def write(self, part: Part, form: str = "") -> str:
        """What a part says; nouns in one of their forms, by default the first."""
        match part:
            case str():
                return part
            case Message():
                return self._write_message(part, form)
            case Fault():
                return self._write_fault(part)
            case Listing():
                return self._write_listing(part, form)
            case Noun(forms):
                return forms[self.forms.index(form) if form else 0]
            case ByLanguage(words, otherwise):
                return self.write(dict(words).get(self.language, otherwise), form)
            case Quoted():
                return f'"{show_in_one_line(part.text)}"'
            case int() | Decimal() | Fraction():
                return self.write_number(part)
            case _:
                assert_never(part)

    def write_number(self, number: int | Decimal | Fraction) -> str:
        """A number with the decimal mark of the language.

        >>> open_catalogue(Language("en")).write_number(Fraction(1, 8))
        '0.125'
        """
        if isinstance(number, Fraction):
            number = Decimal(f"{float(number):.15g}")
        written = f"{number:f}" if isinstance(number, Decimal) else str(number)
        return written.replace(".", self.decimal_mark)

    @property
    def decimal_mark(self) -> str:
        """What stands before the decimals: "." or ","."""
        return self.text("language.decimal-mark")

    def raw(self, domain: str, beginning: str = "") -> Mapping[str, str]:
        """The texts of a file whose keys begin so, by the rest of their keys, with their places
        unfilled: for a layout, which fills them.
        """
        start = f"{domain}.{beginning}"
        entries = read_entries(self.language, domain).entries
        return {
            key.removeprefix(start): entry.texts[0]
            for key, entry in entries.items()
            if key.startswith(start)
        }

    def has(self, key: str) -> bool:
        """Whether there is such an entry."""
        return key in self._entries(key).entries

    def _entries(self, key: str) -> Entries:
        return read_entries(self.language, key.partition(".")[0])

    def _write_message(self, message: Message, form: str) -> str:
        entries = self._entries(message.key)
        entry = entries.entries.get(message.key)
        if entry is None:
            raise LookupError(f"no entry {message.key} in the catalogue {self.language}")
        text = self._choose_form(_choose_number(entry, entries, message), entry, form)
        return _PLACE_AFTER_WORD.sub(lambda place: self._fill(place, message), text)

    def _choose_form(self, text: str, entry: Entry, form: str) -> str:
        if NOUN not in entry.flags:
            return text
        forms = text.split(FORM_SEPARATOR)
        return forms[self.forms.index(form) if form else 0]

    @property
    def forms(self) -> tuple[str, ...]:
        """The names of the forms of nouns, in order."""
        return tuple(self.text("language.forms").split())

    def _fill(self, place: re.Match[str], message: Message) -> str:
        before, name, form = place.groups(default="")
        written = self.write(_find_part(message, name.lower()), form)
        if not name.islower():
            written = written[:1].upper() + written[1:]
        return self._join(before, written) if before else written

    def _join(self, before: str, after: str) -> str:
        """A word and what fills the place behind it."""
        first, blank, rest = after.partition(" ")
        contraction = self._contractions.get(f"{before} {first}")
        return f"{contraction}{blank}{rest}" if contraction else f"{before} {after}"

    @cached_property
    def _contractions(self) -> Mapping[str, str]:
        """What two words are together: "von dem" is "vom"."""
        pairs = self.text("language.contractions").split(FORM_SEPARATOR)
        return dict(pair.split("=") for pair in pairs if "=" in pair)

    def _write_fault(self, fault: Fault) -> str:
        where, what = self.write(fault.where), self.write(fault.what)
        expected, do = self.write(fault.expected), self.write(fault.do)
        place = f"{where}: " if where else ""
        if not isinstance(fault.what, Fault):  # whose parts are short already
            what = shorten(what, _LONGEST_PART)
        remedies = (expected and self.text("grammar.expected", expected=expected), do)
        advice = (shorten(part, 2 * _LONGEST_PART) for part in remedies)
        return " - ".join(filter(None, (f"{show_in_one_line(place)}{what}", *advice)))

    def _write_listing(self, listing: Listing, form: str) -> str:
        items = [self.write(item, form) for item in listing.items]
        comma = self.text("grammar.comma")
        first, last = comma.join(items[:-1]), items[-1] if items else ""
        if not first:
            return last
        match listing.joint:
            case "and":
                return self.text("grammar.and", first=first, last=last)
            case "or":
                return self.text("grammar.or", first=first, last=last)
            case "comma":
                return comma.join(items)
            case "semicolon":
                return self.text("grammar.semicolon").join(items)
            case _:
                assert_never(listing.joint)


def _choose_number(entry: Entry, entries: Entries, message: Message) -> str:
    if len(entry.texts) == 1:
        return entry.texts[0]
    count = message.parts.get("count")
    return entry.texts[entries.plural(count) if isinstance(count, int) else -1]


def _find_part(message: Message, name: str) -> Part:
    if name not in message.parts:
        raise LookupError(f"{message.key} is said without its part {name}")
    return message.parts[name]
