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
from kinegrade.exact.angle import Angle
from kinegrade.exact.text import LATEX, angle_text
from kinegrade.language import LANGUAGES, Language
from kinegrade.problem.holding import wording
from kinegrade.problem.quantity import Quantity
from kinegrade.problem.slots import Slot, pieces, slots_in_formulas
from kinegrade.problem.template import Template, Translated

LONGEST = 20_000  # characters of a statement as it is printed: a page has 3,000


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


def with_unit(quantity: Quantity) -> str:
    """A quantity in LaTeX math: number and upright unit."""
    unit = quantity.measure
    if isinstance(quantity.number, Angle) and quantity.number.parts:
        return angle_text(quantity.number, degrees=False, form=LATEX)
    if unit.degrees:
        return f"{quantity.given_text}^\\circ"
    return (
        quantity.given_text if unit.text == "1" else rf"{quantity.given_text}\,\unit{{{unit.text}}}"
    )


def statement(template: Template, parameters: Mapping[str, Quantity], language: Language) -> str:
    """The statement in one language at these parameters.

    Raises TemplateError where no wording of a text applies, and for a statement of more than
    LONGEST characters.
    """
    givens = {
        name: Given(template.parameters[name].symbol, with_unit(quantity))
        for name, quantity in parameters.items()
    }
    texts = {
        name: filled(text.in_language(language), givens, {})
        for name, text in applying(template, parameters)
    }
    text = filled(template.words.statement.in_language(language), givens, texts)
    if len(text) > LONGEST:
        raise TemplateError(
            f"{template.name}.toml: statement.{language}: {len(text)} characters once it is "
            f"filled in: at most {LONGEST} are printed: shorten it"
        )
    return text


def applying(
    template: Template, parameters: Mapping[str, Quantity]
) -> Iterator[tuple[str, Translated]]:
    """The texts that depend on values, by name, each in the wording that applies. Raises
    TemplateError.
    """
    given = {name: quantity.exact or quantity.certified for name, quantity in parameters.items()}
    for name in template.words.texts:
        found = wording(template, name, given)
        if found is None:
            values = ", ".join(f"{parameter} = {text}" for parameter, text in given.items())
            raise TemplateError(
                f"{template.name}.toml: text.{name}: no wording applies at {values}: "
                'add one without "if", or a condition that keeps such values out'
            )
        yield name, found.text


def filled(text: str, givens: Mapping[str, Given], texts: Mapping[str, str]) -> str:
    """A text with its slots filled in; the template was read, so every slot names a given or a
    text.
    """
    return "".join(
        one if isinstance(one, str) else in_slot(one, givens, texts) for one in pieces(text)
    )


def specimens(template: Template, language: Language) -> Iterator[tuple[str, str]]:
    """The statement and every wording in it, with their places: filled in as they are printed, at a
    value of 1.

    Without those that `statement_faults` reports for a slot inside a formula.
    """
    givens = {name: Given(given.symbol, "1") for name, given in template.parameters.items()}
    first = {
        name: filled(wordings[0].text.in_language(language), givens, {})
        for name, wordings in template.words.texts.items()
    }
    for where, text in written(template, language):
        if not slots_in_formulas(text):
            yield where, filled(text, givens, first)


def in_slot(slot: Slot, givens: Mapping[str, Given], texts: Mapping[str, str]) -> str:
    """The text that replaces a slot."""
    if slot.name in texts:
        return texts[slot.name]
    given = givens[slot.name]
    return given.value if slot.value else str(given)


def check_statements(template: Template) -> None:
    """Raises TemplateError for all of `statement_faults`."""
    faults = statement_faults(template)
    if faults:
        raise TemplateError(*faults)


def statement_faults(template: Template) -> list[str]:
    """What an author has to add to the statements before students can be given them."""
    faults = unused_texts(template)
    for language in LANGUAGES:
        faults += left_out(template, language)
        faults += in_formulas(template, language)
    return faults


def left_out(template: Template, language: Language) -> list[str]:
    """The parameters that a statement does not give to the student, whatever wordings apply."""
    given = named(template.words.statement.in_language(language))
    for name in given & set(template.words.texts):
        wordings = template.words.texts[name]
        given |= frozenset.intersection(
            *(named(one.text.in_language(language)) for one in wordings)
        )
    return [
        f"{template.name}.toml: statement.{language}: the parameter {name} is not given to the "
        f"student: write {{{{ {name} }}}}"
        for name in template.parameters
        if name not in given
    ]


def in_formulas(template: Template, language: Language) -> list[str]:
    """The slots between dollar signs, which would cut a formula in two."""
    return [
        f"{template.name}.toml: {where}: {{{{ {slot.name} }}}} stands inside a formula: it brings "
        "dollar signs of its own, so write it outside"
        for where, text in written(template, language)
        for slot in slots_in_formulas(text)
    ]


def written(template: Template, language: Language) -> Iterator[tuple[str, str]]:
    """The statement and the wordings of its texts, as the author wrote them, with their places."""
    for name, wordings in template.words.texts.items():
        for index, one in enumerate(wordings):
            yield f"text.{name}[{index}].{language}", one.text.in_language(language)
    yield f"statement.{language}", template.words.statement.in_language(language)


def unused_texts(template: Template) -> list[str]:
    """The texts that no statement, or only that of the other language, uses."""
    faults = []
    for name in template.words.texts:
        lacking = [
            language
            for language in LANGUAGES
            if name not in named(template.words.statement.in_language(language))
        ]
        if len(lacking) == len(LANGUAGES):
            faults.append(f"text.{name}: stands in no statement: write {{{{ {name} }}}} there")
        else:
            faults += [
                f"statement.{language}: the text {name} does not stand in it: write {{{{ {name} "
                f"}}}}"
                for language in lacking
            ]
    return [f"{template.name}.toml: {fault}" for fault in faults]


def named(text: str) -> frozenset[str]:
    """What the slots of a text name."""
    return frozenset(one.name for one in pieces(text) if isinstance(one, Slot))
