"""What an author has to add to the statements of a template before students can be given them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import chain, combinations

from kinegrade.errors import TemplateError
from kinegrade.files.fields.place import key_path
from kinegrade.language import Language
from kinegrade.language.message import Fault, Message
from kinegrade.numbers.rounded_text import write_decimal
from kinegrade.problem.holding import choose_wording, condition_holds
from kinegrade.problem.statement import list_statement_languages, list_written_texts
from kinegrade.problem.template.domain import find_doubles
from kinegrade.problem.template.driven import find_driven
from kinegrade.problem.template.slots import find_slots, find_slots_in_formulas, find_units_behind
from kinegrade.problem.template.template import Parameter, Template

_TRIED = 6  # values of all givens at which the words for either sense are compared
_HALF_TURN, _DIGITS = 180, 12


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
        faults += _find_lost_senses(template, language)
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


def _find_lost_senses(template: Template, language: Language) -> list[Fault]:
    """The givens of both senses that are printed without their sign, in words that are the same for
    either: a student cannot know which is meant.
    """
    places = {
        slot.name: key_path(where)
        for where, text in list_written_texts(template, language)
        for slot in find_slots(text)
        if slot.part == "size"
    }
    printed = _list_unsigned(template, language, places)
    alike: dict[str, str] = {}
    for number in range(_TRIED if printed else 0):
        values = {
            name: _choose(printed.get(name, given.choices), number)
            for name, given in template.parameters.items()
        }
        for name in _find_alike(template, values, sorted(printed)):
            alike.setdefault(name, values[name])
    return [
        _make_fault(
            template,
            places[name],
            Message("template.sense-lost", name=name, value=value, other=_reverse(value)),
        )
        for name, value in alike.items()
    ]


def _list_unsigned(
    template: Template, language: Language, sizes: Iterable[str]
) -> Mapping[str, Sequence[str]]:
    """The reversed values of those givens of both senses that nothing prints with their sense."""
    driven = find_driven(template.scheme.drivers, template.parameters)
    told = {
        name
        for _, text in list_written_texts(template, language)
        for slot in find_slots(text)
        if slot.part != "size"
        for name in slot.list_givens(driven)
    }
    found = {}
    for name in sizes:
        given = template.parameters[name]
        values = [text for text in given.choices if _is_reversed(given, text)]
        others = [text for text in given.choices if text not in values and _find_value(text)]
        if values and others and name not in told:
            found[name] = values
    return found


def _find_alike(
    template: Template, values: Mapping[str, str], names: Sequence[str]
) -> Iterator[str]:
    """Those of the names whose senses may all be the other one in the same words."""
    words = _list_wordings(template, values)
    several = chain.from_iterable(combinations(names, size + 1) for size in range(len(names)))
    for some in several:
        others = {**values, **{name: _reverse(values[name]) for name in some}}
        if words is not None and words == _list_wordings(template, others):
            yield from some


def _list_wordings(template: Template, values: Mapping[str, str]) -> Sequence[object] | None:
    """The wordings that apply at these values; None where they are not drawn."""
    if not all(condition_holds(template, each, values) for each in template.scheme.conditions):
        return None
    wordings = [choose_wording(template, name, values) for name in template.words.texts]
    return None if None in wordings else wordings


def _choose(texts: Sequence[str], number: int) -> str:
    return texts[number % len(texts)]


def _is_reversed(given: Parameter, text: str) -> bool:
    """Whether a value is printed without its sign as another one of the other sense."""
    value = _find_value(text)
    return value < 0 or (given.unit.degrees and value > _HALF_TURN)


def _reverse(text: str) -> str:
    """The value of the other sense that is printed alike."""
    value = _find_value(text)
    return write_decimal(-value if value < 0 else 2 * _HALF_TURN - value, _DIGITS)


def _find_value(text: str) -> float:
    (value,) = find_doubles((text,))
    return value


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
