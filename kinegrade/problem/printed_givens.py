"""Which givens the statement of a question prints, by what is asked, and so what its figure marks:
the same in all languages and at all values.
"""

from __future__ import annotations

from collections.abc import Collection

from kinegrade.expressions.tree import find_names
from kinegrade.problem.needs import Needs, find_needs
from kinegrade.problem.template.driven import Drives, drop_accelerations, find_driven
from kinegrade.problem.template.given_marks import mark_givens
from kinegrade.problem.template.hints import FigureHints
from kinegrade.problem.template.slots import find_slots
from kinegrade.problem.template.template import Template
from kinegrade.problem.template.translated import Translated


def mark_question(template: Template, asks: Collection[str]) -> FigureHints:
    """What the figure of a question marks that asks for these: what its statement prints."""
    return mark_givens(template, find_printed_givens(template, asks), asks)


def find_printed_givens(template: Template, asks: Collection[str]) -> frozenset[str]:
    """The parameters that a statement prints where these are asked, in any of its wordings."""
    needs = find_needs(template, asks)
    driven = find_driven(template.scheme.drivers, template.parameters)
    said = driven if needs.changes else drop_accelerations(driven)
    statement = template.words.statement
    printed = set(_find_slot_names(statement, said))
    for name, wordings in template.words.texts.items():
        if is_needed(template, name, needs, driven):
            for wording in wordings:
                printed |= _find_slot_names(wording.text, said)
    return frozenset(printed & template.parameters.keys())


def is_needed(template: Template, name: str, needs: Needs, driven: Drives) -> bool:
    """Whether the text of that name is printed: not where all givens in it, or else those that
    choose between its wordings, are needed by nothing that is asked.
    """
    printed: set[str] = set()
    choosing: set[str] = set()
    for wording in template.words.texts[name]:
        printed |= _find_slot_names(wording.text, driven)
        if wording.condition is not None:
            choosing.update(find_names(wording.condition.left), find_names(wording.condition.right))
    named = printed or choosing & template.parameters.keys()
    return not named or bool(named & needs.givens)


def _find_slot_names(text: Translated, driven: Drives) -> frozenset[str]:
    """What the slots of a text print, however written: givens, and names of other texts."""
    return frozenset(
        name
        for written in text.texts
        for slot in find_slots(written)
        for name in slot.list_givens(driven)
    )
