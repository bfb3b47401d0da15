"""The statement of an instance: the template's text with this student's numbers in it.

Statements are Markdown with LaTeX math between dollar signs. `{{ r }}` becomes `$r =
0.25\\,\\unit{m}$`, `{{ OA.turning }}` says how the body OA turns, and `{{ place }}` becomes the
wording of `[[text.place]]` that applies at these values. Nothing else is filled in: a template
from a stranger can print its parameters and its own texts, and nothing more.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from flint import fmpq

from kinegrade.errors import TemplateError
from kinegrade.files.fields.place import Place
from kinegrade.language import ENGLISH, Language
from kinegrade.language.decimal_mark import write_decimals_of_prose
from kinegrade.language.message import Fault, Message
from kinegrade.problem.filling import Filling
from kinegrade.problem.given import list_givens
from kinegrade.problem.holding import choose_wording
from kinegrade.problem.needs import find_needs
from kinegrade.problem.printed_givens import is_needed
from kinegrade.problem.quantity import Quantity
from kinegrade.problem.template.driven import find_driven
from kinegrade.problem.template.slots import find_slots_in_formulas
from kinegrade.problem.template.template import Template, Wording
from kinegrade.problem.template.texts import list_prose
from kinegrade.problem.template.translated import (
    Translated,
    find_common_languages,
    find_named_languages,
)

_LONGEST = 20_000  # characters of a statement as it is printed: a page has 3,000


def write_statement(
    template: Template,
    parameters: Mapping[str, Quantity],
    language: Language,
    asks: Iterable[str] | None = None,
) -> str:
    """The statement in one language at these parameters, with what these asks need, or all asks.

    Raises TemplateError where no wording of a text applies, and for a statement of more than
    LONGEST characters.
    """
    needs = find_needs(template, template.asks if asks is None else asks)
    filling = _make_filling(template, parameters, language, changes=needs.changes)
    texts = {
        name: filling.fill(text.in_language(language), {})
        if is_needed(template, name, needs, filling.driven)
        else ""
        for name, text in _choose_wordings(template, parameters)
    }
    text = filling.fill(template.words.statement.in_language(language), texts)
    if len(text) > _LONGEST:
        what = Message("template.statement-too-long", count=len(text), most=_LONGEST)
        raise TemplateError(Fault(f"{template.name}.toml: statement.{language}", what))
    return write_decimals_of_prose(text, language)


def _make_filling(
    template: Template, parameters: Mapping[str, Quantity], language: Language, *, changes: bool
) -> Filling:
    driven = find_driven(template.scheme.drivers, template.parameters)
    return Filling(list_givens(template, parameters), driven, changes, language)


def _choose_wordings(
    template: Template, parameters: Mapping[str, Quantity]
) -> Iterator[tuple[str, Translated]]:
    """The texts that depend on values, by name, each in the wording that applies. Raises
    TemplateError.
    """
    for name, found in list_wordings(template, parameters).items():
        if found is None:
            given = _write_given(parameters)
            values = ", ".join(f"{parameter} = {text}" for parameter, text in given.items())
            what = Message("template.no-wording-applies", values=values)
            raise TemplateError(Fault(f"{template.name}.toml: text.{name}", what))
        yield name, found.text


def list_wordings(
    template: Template, parameters: Mapping[str, Quantity]
) -> Mapping[str, Wording | None]:
    """The wording that applies of each text that depends on values; None where none does."""
    given = _write_given(parameters)
    return {name: choose_wording(template, name, given) for name in template.words.texts}


def _write_given(parameters: Mapping[str, Quantity]) -> Mapping[str, str]:
    return {name: quantity.exact or quantity.certified for name, quantity in parameters.items()}


def write_specimens(template: Template, language: Language) -> Iterator[tuple[Place, str]]:
    """The statement and every wording in it, with their places: filled in as they are printed, at a
    value of 1.

    Without those that `find_statement_faults` reports for a slot inside a formula.
    """
    ones = {
        name: Quantity(name, fmpq(1), given.unit) for name, given in template.parameters.items()
    }
    filling = _make_filling(template, ones, language, changes=True)
    first = {
        name: filling.fill(wordings[0].text.in_language(language), {})
        for name, wordings in template.words.texts.items()
    }
    for where, text in list_written_texts(template, language):
        if not find_slots_in_formulas(text):
            yield where, filling.fill(text, first)


def list_written_texts(template: Template, language: Language) -> Iterator[tuple[Place, str]]:
    """The statement and the wordings of its texts, as the author wrote them, with their places."""
    for place, text in list_prose(template):
        yield text.find_place(place, language), text.in_language(language)


def list_statement_languages(template: Template) -> tuple[Language, ...]:
    """The languages that are named in the statement or in a wording of it, and have both in full;
    English where none is.
    """
    texts = [text for _, text in list_prose(template)]
    named = find_named_languages(texts)
    if not named:
        return (ENGLISH,)
    return tuple(each for each in find_common_languages(texts) if each in named)
