"""A text in the languages in which its author gives it: some, one, or a plain one for all."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from msgspec import Struct

from kinegrade.errors import TemplateError
from kinegrade.files.fields.place import Place
from kinegrade.language import Language
from kinegrade.language.known import known_languages
from kinegrade.language.message import Fault, Message, list_choices


class Translated(Struct, frozen=True):
    """A text by language; a `plain` one is the same in every language.

    >>> crank = Translated((("en", "crank"), ("zh", "曲柄")))
    >>> crank.in_language("zh"), Translated(plain="AB").in_language("zh")
    ('曲柄', 'AB')
    """

    by_language: tuple[tuple[Language, str], ...] = ()
    plain: str | None = None

    @property
    def languages(self) -> tuple[Language, ...]:
        """The languages that the author names; none for a plain text."""
        return tuple(language for language, _ in self.by_language)

    @property
    def texts(self) -> tuple[str, ...]:
        """Every text that the author wrote, a plain one as well."""
        return tuple(text for _, text in self.list_written(()))

    def has(self, language: Language) -> bool:
        """Whether there is a text in a language."""
        return self.plain is not None or language in self.languages

    def in_language(self, language: Language) -> str:
        """The text in one language. Raises TemplateError where there is none."""
        text = dict(self.by_language).get(language, self.plain)
        if text is None:
            what = Message("texts.none-in", language=language)
            expected = Message("texts.one-of", languages=list_choices(self.languages))
            raise TemplateError(Fault("", what, expected))
        return text

    def find_place(self, place: Place, language: Language) -> Place:
        """Where the text in a language stands, if the whole stands at that place."""
        return (*place, language) if language in self.languages else place

    def list_written(self, place: Place) -> Iterator[tuple[Place, str]]:
        """Every text that the author wrote, with its place, if the whole stands at that place."""
        if self.plain is not None:
            yield place, self.plain
        for language, text in self.by_language:
            yield (*place, language), text


def find_named_languages(texts: Collection[Translated]) -> tuple[Language, ...]:
    """The languages that at least one text names."""
    named = {language for text in texts for language in text.languages}
    return tuple(language for language in known_languages() if language in named)


def find_common_languages(texts: Collection[Translated]) -> tuple[Language, ...]:
    """The languages in which there are all of these texts."""
    return tuple(
        language for language in known_languages() if all(text.has(language) for text in texts)
    )
