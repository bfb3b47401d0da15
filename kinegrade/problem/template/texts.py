"""The texts of a template: where each stands, which languages have them all, and what one lacks."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from kinegrade.errors import TemplateError
from kinegrade.files.fields.place import Place, key_path
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.message import Fault, Message, Quoted, list_choices, list_first
from kinegrade.problem.template.driven import find_driven
from kinegrade.problem.template.slots import find_slots
from kinegrade.problem.template.template import Template
from kinegrade.problem.template.translated import (
    Translated,
    find_common_languages,
    find_named_languages,
)

_FORMULA = re.compile(r"\$[^$]*\$|\{\{.*?\}\}")
_LATIN = re.compile("[a-z]{3}")
_FIRST, _LAST = 0x3400, 0x9FFF  # of Chinese characters; a pattern of so many takes long to compile
_NAMED = 6  # texts that a message about a whole template names


def list_prose(template: Template) -> Iterator[tuple[Place, Translated]]:
    """The wordings of the texts that depend on values, and the statement, with their places."""
    for name, wordings in template.words.texts.items():
        for number, wording in enumerate(wordings):
            yield ("text", name, number), wording.text
    yield ("statement",), template.words.statement


def find_unsigned_givens(template: Template) -> frozenset[str]:
    """The givens that statements print without their sign, which their words say."""
    driven = find_driven(template.scheme.drivers, template.parameters)
    return frozenset(
        given
        for place, prose in list_prose(template)
        for _, text in prose.list_written(place)
        for slot in find_slots(text)
        if slot.part not in {"", "value"}
        for given in slot.list_givens(driven)
    )


def list_lines(template: Template) -> Iterator[tuple[Place, Translated]]:
    """The texts of one line with their places: the title, what things mean, why lengths are what
    they are, the author's signs and mistakes.
    """
    yield ("title",), template.about.title
    for name, parameter in template.parameters.items():
        yield ("parameters", name, "means"), parameter.means
    for name, ask in template.asks.items():
        yield ("asks", name, "means"), ask.means
        if isinstance(ask.sign, Translated):
            yield ("asks", name, "sign"), ask.sign
    for name, reason in template.words.reasons.items():
        yield ("reasons", name), reason
    for mistake in template.scheme.mistakes:
        yield ("mistakes", mistake.identifier, "means"), mistake.means


def find_languages(template: Template) -> tuple[Language, ...]:
    """The languages in which a template has all its texts."""
    return find_common_languages([text for _, text in _list_texts(template)])


def find_used_languages(template: Template) -> tuple[Language, ...]:
    """The languages that a template names for any of its texts."""
    return find_named_languages([text for _, text in _list_texts(template)])


def is_language_named(template: Template) -> bool:
    """Whether a template says of any of its texts in which language it is."""
    return bool(find_used_languages(template))


def find_missing_texts(template: Template, language: Language) -> tuple[str, ...]:
    """The places of the texts that a template lacks in a language."""
    return tuple(key_path(place) for place, text in _list_texts(template) if not text.has(language))


def find_unstated_texts(template: Template) -> tuple[str, ...]:
    """The places of the texts with words that are in no stated language, where others name one."""
    if not is_language_named(template):
        return ()
    return tuple(
        key_path(place)
        for place, text in _list_texts(template)
        if text.plain is not None and _has_words(text.plain)
    )


def note_other_scripts(template: Template, language: Language) -> Iterator[Message]:
    """A note where texts that are written once for all languages are not in the script of this
    one: a Chinese paper prints an English sentence as it stands. Or where they may not be in this
    language, for others name theirs.
    """
    chinese = open_catalogue(language).text("language.page.script") == "chinese"
    found = [
        key_path(place)
        for place, text in _list_texts(template)
        if text.plain is not None and _is_in_another_script(text.plain, chinese)
    ]
    if found:
        listed = list_first(found, _NAMED)
        name = template.name
        yield Message("texts.in-another-script", template=name, language=language, names=listed)
    elif unstated := find_unstated_texts(template):
        names = {"template": template.name, "names": list_first(unstated, _NAMED)}
        yield Message("texts.in-no-stated-language", language=language, **names)


def _is_in_another_script(text: str, chinese: bool) -> bool:
    """Whether the words of a text, formulas left out, are Latin ones for Chinese, or Chinese."""
    words = _FORMULA.sub("", text)
    written_in_chinese = _is_chinese(words)
    return not written_in_chinese and bool(_LATIN.search(words)) if chinese else written_in_chinese


def _is_chinese(words: str) -> bool:
    return any(_FIRST <= ord(character) <= _LAST for character in words)


def _has_words(text: str) -> bool:
    """Whether there is more to a text than formulas."""
    words = _FORMULA.sub("", text)
    return _is_chinese(words) or bool(_LATIN.search(words))


def find_unfinished_translations(template: Template) -> list[Fault]:
    """A fault for each text that is missing in a language which other texts have."""
    named = find_used_languages(template)
    return [
        Fault(place, Message("template.unfinished", language=Quoted(language)))
        for language in named
        for place in find_missing_texts(template, language)
    ]


def require_language(templates: Iterable[Template], language: Language) -> None:
    """Raises TemplateError, with a line for each template that lacks texts in a language."""
    faults = find_language_faults(templates, language)
    if faults:
        raise TemplateError(*faults)


def find_language_faults(templates: Iterable[Template], language: Language) -> tuple[Fault, ...]:
    """A fault for each template that lacks texts in a language."""
    lacking = {each.name: each for each in templates if find_missing_texts(each, language)}
    return tuple(_explain_missing(template, language) for template in lacking.values())


def _explain_missing(template: Template, language: Language) -> Fault:
    missing = find_missing_texts(template, language)
    return Fault(
        template.name,
        Message("texts.lacks", language=language, names=list_first(missing, _NAMED)),
        Message("texts.all-in", language=language),
        _advise(template, language),
    )


def _advise(template: Template, language: Language) -> Message:
    complete = find_languages(template)
    if not template.scheme.has_mechanism:
        if not complete:
            return Message("texts.write-there")
        return Message("texts.write-there-or", languages=list_choices(complete))
    file = f"{template.name}.{language}.toml"
    if not complete:
        return Message("texts.write-file", file=file)
    languages = list_choices(complete)
    return Message("texts.write-file-or", file=file, languages=languages, language=language)


def _list_texts(template: Template) -> Iterator[tuple[Place, Translated]]:
    yield from list_lines(template)
    yield from list_prose(template)
