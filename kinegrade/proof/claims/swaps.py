"""Givens that stand where others are meant: two that have changed places, and an answer printed as
a number.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations

from kinegrade.errors import MechanismError
from kinegrade.language.message import Message
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.template import Parameter, Template
from kinegrade.proof.claims.nouns import Nouns
from kinegrade.proof.claims.patterns import list_words, write_words

_SLOT = re.compile(r"\{\{\s*(\w+)[^}]*\}\}")
_NAME = re.compile(  # of a part: gear 2, wheel A, the bar $AB$
    r"(?<![\wÀ-ÿ{\\])(\d|[A-Z]{1,2}(?:_?\{?\d\}?)?)(?![\wÀ-ÿ}])", re.ASCII
)
_WITH_UNIT = re.compile(
    r"(?<![\w.,^{])(\d+(?:[.,]\d+)?)\s*(?:\\[,;: ]\s*)?"
    r"(?:\\mathrm\{([^{}]+)\}|\$?\s?([a-z]+/[a-z]+))"
)
_SAME = 5e-3  # of an answer: a number on paper has few figures


def find_swapped_givens(template: Template) -> Iterator[Message]:
    """Two givens of one unit, each at the part that the other one means: `gear 2, with {{ z3 }}
    teeth, and gear 3, with {{ z2 }}`.
    """
    letters = {name: _find_only_name(template, each) for name, each in template.parameters.items()}
    groups = {name: _find_group(each) for name, each in template.parameters.items()}
    sides = {name: _find_only_side(each) for name, each in template.parameters.items()}
    for text in template.words.statement.texts:
        yield from _find_swapped(template, letters, dict(_list_slots(text)))
        yield from _find_swapped(template, groups, dict(_list_groups(text)))
        yield from _find_swapped(template, sides, dict(_list_sides(text)))


def _find_swapped(
    template: Template, meant: Mapping[str, str | None], said: Mapping[str, str]
) -> Iterator[Message]:
    """Two givens of one unit that a text has at the parts that the other one means."""
    for one, other in combinations(said, 2):
        names = (meant.get(one), meant.get(other))
        units = {template.parameters[name].unit for name in (one, other) if name in meant}
        if all(names) and len(units) == 1 and (said[other], said[one]) == names != names[::-1]:
            yield Message("template.swapped", one=one, other=other)


def _find_only_name(template: Template, given: Parameter) -> str | None:
    """The part that a given means, a letter or number, where all its texts name that one alone; a
    noun stands for the body whose letter is behind it.
    """
    texts = given.means.texts
    named = {name.replace("_", "") for text in texts for name in _NAME.findall(text)}
    if not named:
        nouns = [noun for text in texts for noun in Nouns(template).read_nouns(text)]
        named = {thing.body for _, things in nouns for thing in things}
    return next(iter(named)) if len(named) == 1 else None


def _find_group(given: Parameter) -> str | None:
    """The parts that a given means, where they are several: 1 2 of the module of gears 1 and 2."""
    named = {" ".join(sorted({*_NAME.findall(text)})) for text in given.means.texts}
    return next(iter(named)) if len(named) == 1 and " " in next(iter(named)) else None


def _list_groups(text: str) -> Iterator[tuple[str, str]]:
    """The givens of a text, each with the parts named between it and the one before, in its
    sentence.
    """
    start = 0
    for slot in _SLOT.finditer(text):
        before = re.split(r"[.;。；]", text[start : slot.start()])[-1]
        yield slot[1], " ".join(sorted({*_NAME.findall(before)}))
        start = slot.end()


def _find_only_side(given: Parameter) -> str | None:
    """Which one of two things a given means: upper."""
    named = {*_name_ones_of_two(" ".join(given.means.texts))}
    return next(iter(named)) if len(named) == 1 else None


def _list_sides(text: str) -> Iterator[tuple[str, str]]:
    """The givens of a text, each with the last word between it and the one before, in its
    sentence, that tells one of two things.
    """
    start = 0
    for slot in _SLOT.finditer(text):
        before = re.split(r"[.;。；]", text[start : slot.start()])[-1]
        yield from ((slot[1], said) for said in [*_name_ones_of_two(before)][-1:])
        start = slot.end()


def _name_ones_of_two(text: str) -> Iterator[str]:
    """The words of a text that tell one of two things from the other, in their order: upper."""
    words = [one for pair in list_words("one-of-two") for one in pair.split("/")]
    pattern = "|".join(rf"(?<![^\W\d_]){one}" if one.isascii() else one for one in words)
    yield from (match[0].lower() for match in re.finditer(pattern, text, re.IGNORECASE))


def _list_slots(text: str) -> Iterator[tuple[str, str]]:
    """The givens of a text, each with its part: `{{ z }} of $A$`, or else the part named last
    before it, in its sentence.
    """
    start = 0
    whose = re.compile(
        rf"\s*(?:{write_words('whose')})\s+(?:[^\W\d_]+\s+){{0,2}}\$?{_NAME.pattern}"
    )
    for slot in _SLOT.finditer(text):
        behind = whose.match(text, slot.end())
        before = re.split(r"[.;。；]", text[start : slot.start()])[-1]
        named = [behind[1]] if behind else _NAME.findall(before)
        if named:
            yield slot[1], named[-1].replace("_", "")
        start = slot.end()


def note_printed_answers(template: Template, asks: Sequence[str]) -> Iterator[Message]:
    """A remark for each number with a unit in the statement that is an answer at the source's
    values: it stands on every paper, whatever the values.
    """
    if not any(map(_WITH_UNIT.search, template.words.statement.texts)):
        return
    try:
        source = solve_template(template, {}, asks)
    except MechanismError:
        return  # the source's values are refused elsewhere
    for text in template.words.statement.texts:
        for number, unit, plain in _WITH_UNIT.findall(text):
            value = float(number.replace(",", "."))
            for name, answer in source.answers.items():
                same_unit = template.asks[name].unit.text == (unit or plain)
                if value and same_unit and abs(abs(answer.value) - value) <= _SAME * value:
                    said = f"{number} {unit or plain}"
                    yield Message("template.printed-answer", said=said, name=name)
