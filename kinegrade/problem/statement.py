"""The statement of an instance: the template's text with this student's numbers in it.

Statements are Markdown with LaTeX math between dollar signs. `{{ r }}` becomes `$r =
0.25\\,\\unit{m}$`, `{{ r.value }}` the number with its unit alone, and `{{ turning }}` the wording
of `[[text.turning]]` that applies at these values. Nothing else is filled in: a template from a
stranger can print its parameters and its own texts, and nothing more.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from kinegrade.errors import TemplateError
from kinegrade.files.fields.place import Place, key_path
from kinegrade.language import Language
from kinegrade.language.decimal_mark import write_decimals_of_prose
from kinegrade.language.message import Fault, Message
from kinegrade.numbers.angle import Angle
from kinegrade.numbers.text import LATEX, write_angle
from kinegrade.problem.holding import choose_wording
from kinegrade.problem.quantity import Quantity
from kinegrade.problem.template.slots import Slot, find_slots_in_formulas, split_slots
from kinegrade.problem.template.template import Template
from kinegrade.problem.template.texts import list_prose
from kinegrade.problem.template.translated import Translated, find_common_languages

_LONGEST = 20_000  # characters of a statement as it is printed: a page has 3,000


@dataclass(frozen=True)
class Given:
    """A parameter as a statement prints it."""

    symbol: str
    text: str

    @property
    def value(self) -> str:
        """The number with its unit, without the symbol."""
        return f"${self.text}$"

    def __str__(self) -> str:
        return f"${self.symbol} = {self.text}$"


def write_with_unit(quantity: Quantity) -> str:
    """A quantity in LaTeX math: number and upright unit."""
    unit = quantity.measure
    if isinstance(quantity.number, Angle) and quantity.number.parts:
        return write_angle(quantity.number, degrees=False, form=LATEX)
    if unit.degrees:
        return f"{quantity.given_text}^\\circ"
    return (
        quantity.given_text if unit.text == "1" else rf"{quantity.given_text}\,\unit{{{unit.text}}}"
    )


def write_statement(
    template: Template, parameters: Mapping[str, Quantity], language: Language
) -> str:
    """The statement in one language at these parameters.

    Raises TemplateError where no wording of a text applies, and for a statement of more than
    LONGEST characters.
    """
    givens = {
        name: Given(template.parameters[name].symbol, write_with_unit(quantity))
        for name, quantity in parameters.items()
    }
    texts = {
        name: _fill_slots(text.in_language(language), givens, {})
        for name, text in _choose_wordings(template, parameters)
    }
    text = _fill_slots(template.words.statement.in_language(language), givens, texts)
    if len(text) > _LONGEST:
        what = Message("template.statement-too-long", count=len(text), most=_LONGEST)
        raise TemplateError(Fault(f"{template.name}.toml: statement.{language}", what))
    return write_decimals_of_prose(text, language)


def _choose_wordings(
    template: Template, parameters: Mapping[str, Quantity]
) -> Iterator[tuple[str, Translated]]:
    """The texts that depend on values, by name, each in the wording that applies. Raises
    TemplateError.
    """
    given = {name: quantity.exact or quantity.certified for name, quantity in parameters.items()}
    for name in template.words.texts:
        found = choose_wording(template, name, given)
        if found is None:
            values = ", ".join(f"{parameter} = {text}" for parameter, text in given.items())
            what = Message("template.no-wording-applies", values=values)
            raise TemplateError(Fault(f"{template.name}.toml: text.{name}", what))
        yield name, found.text


def _fill_slots(text: str, givens: Mapping[str, Given], texts: Mapping[str, str]) -> str:
    """A text with its slots filled in; the template was read, so every slot names a given or a
    text.
    """
    return "".join(
        one if isinstance(one, str) else _write_slot(one, givens, texts)
        for one in split_slots(text)
    )


def write_specimens(template: Template, language: Language) -> Iterator[tuple[Place, str]]:
    """The statement and every wording in it, with their places: filled in as they are printed, at a
    value of 1.

    Without those that `find_statement_faults` reports for a slot inside a formula.
    """
    givens = {name: Given(given.symbol, "1") for name, given in template.parameters.items()}
    first = {
        name: _fill_slots(wordings[0].text.in_language(language), givens, {})
        for name, wordings in template.words.texts.items()
    }
    for where, text in _list_written_texts(template, language):
        if not find_slots_in_formulas(text):
            yield where, _fill_slots(text, givens, first)


def _write_slot(slot: Slot, givens: Mapping[str, Given], texts: Mapping[str, str]) -> str:
    """The text that replaces a slot."""
    if slot.name in texts:
        return texts[slot.name]
    given = givens[slot.name]
    return given.value if slot.value else str(given)


def check_statements(template: Template) -> None:
    """Raises TemplateError for all of `find_statement_faults`."""
    faults = find_statement_faults(template)
    if faults:
        raise TemplateError(*faults)


def find_statement_faults(template: Template) -> list[Fault]:
    """What an author has to add to the statements before students can be given them."""
    faults = _find_unused_texts(template)
    for language in list_statement_languages(template):
        faults += _find_left_out(template, language)
        faults += _find_cutting_slots(template, language)
    return faults


def list_statement_languages(template: Template) -> tuple[Language, ...]:
    """The languages that differ in the statement or in a wording of it, and have both in full."""
    texts = [text for _, text in list_prose(template)]
    named = {language for text in texts for language in text.languages}
    common = find_common_languages(texts)
    return tuple(each for each in common if each in named) or common[:1]


def _find_left_out(template: Template, language: Language) -> list[Fault]:
    """The parameters that a statement does not give to the student, whatever wordings apply."""
    statement = template.words.statement
    place = statement.find_place(("statement",), language)
    given = _find_slot_names(statement.in_language(language))
    for name in given & set(template.words.texts):
        wordings = template.words.texts[name]
        given |= frozenset.intersection(
            *(_find_slot_names(one.text.in_language(language)) for one in wordings)
        )
    return [
        _make_fault(template, key_path(place), Message("template.not-given", name=name))
        for name in template.parameters
        if name not in given
    ]


def _find_cutting_slots(template: Template, language: Language) -> list[Fault]:
    """The slots between dollar signs, which would cut a formula in two."""
    return [
        _make_fault(template, key_path(where), Message("template.in-formula", name=slot.name))
        for where, text in _list_written_texts(template, language)
        for slot in find_slots_in_formulas(text)
    ]


def _list_written_texts(template: Template, language: Language) -> Iterator[tuple[Place, str]]:
    """The statement and the wordings of its texts, as the author wrote them, with their places."""
    for place, text in list_prose(template):
        yield text.find_place(place, language), text.in_language(language)


def _find_unused_texts(template: Template) -> list[Fault]:
    """The texts that no statement, or only that of another language, uses."""
    faults = []
    statements = dict(template.words.statement.list_written(("statement",)))
    for name in template.words.texts:
        lacking = [
            place for place, text in statements.items() if name not in _find_slot_names(text)
        ]
        if len(lacking) == len(statements):
            what = Message("template.in-no-statement", name=name)
            faults.append(_make_fault(template, f"text.{name}", what))
        else:
            faults += [
                _make_fault(template, key_path(place), Message("template.not-in-it", name=name))
                for place in lacking
            ]
    return faults


def _make_fault(template: Template, place: str, what: Message) -> Fault:
    return Fault(f"{template.name}.toml: {place}", what)


def _find_slot_names(text: str) -> frozenset[str]:
    """What the slots of a text name."""
    return frozenset(one.name for one in split_slots(text) if isinstance(one, Slot))
