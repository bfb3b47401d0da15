"""What an author has to add to the statements of a template before students can be given them."""

from __future__ import annotations

from kinegrade.errors import TemplateError
from kinegrade.files.fields.place import key_path
from kinegrade.language import Language
from kinegrade.language.message import Fault, Message
from kinegrade.problem.statement import list_statement_languages, list_written_texts
from kinegrade.problem.template.driven import find_driven
from kinegrade.problem.template.slots import (
    find_slots,
    find_slots_in_formulas,
    find_units_behind,
)
from kinegrade.problem.template.template import Template


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
        faults += _find_second_units(template, language)
    return faults


def _find_left_out(template: Template, language: Language) -> list[Fault]:
    """The parameters that a statement does not give to the student, whatever wordings apply."""
    statement = template.words.statement
    place = statement.find_place(("statement",), language)
    given = _find_givens(template, statement.in_language(language))
    for name in given & set(template.words.texts):
        wordings = template.words.texts[name]
        given |= frozenset.intersection(
            *(_find_givens(template, one.text.in_language(language)) for one in wordings)
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
        for where, text in list_written_texts(template, language)
        for slot in find_slots_in_formulas(text)
    ]


def _find_second_units(template: Template, language: Language) -> list[Fault]:
    """The units that are typed behind givens, which are printed with theirs."""
    return [
        _make_fault(
            template, key_path(where), Message("template.unit-behind", name=slot.name, unit=unit)
        )
        for where, text in list_written_texts(template, language)
        for slot, unit in find_units_behind(text)
        if slot.name in template.parameters
    ]


def _find_unused_texts(template: Template) -> list[Fault]:
    """The texts that no statement, or only that of another language, uses."""
    faults = []
    statements = dict(template.words.statement.list_written(("statement",)))
    for name in template.words.texts:
        lacking = [
            place for place, text in statements.items() if name not in _find_givens(template, text)
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


def _find_givens(template: Template, text: str) -> frozenset[str]:
    """What the slots of a text print: parameters, and texts."""
    driven = find_driven(template.scheme.drivers, template.parameters)
    return frozenset().union(*(slot.list_givens(driven) for slot in find_slots(text)))
