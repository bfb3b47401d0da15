"""Claims of the side on which a rope leaves a circle that is named by a noun: `is wound on the hub,
on its left side`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence

from kinegrade.language.message import Message
from kinegrade.mechanics.joints.touching_pair import TouchingPair
from kinegrade.mechanics.shapes import Line
from kinegrade.numbers.floats import Floats
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.template import Parameter, Template
from kinegrade.proof.claims.patterns import list_words, write_words
from kinegrade.proof.claims.reading import DIFFERENT, list_sentences_of, read_texts

_SIDES = {"rope-right": 1.0, "rope-left": -1.0}
_SHARES = (0.5, 1.0)  # of a diameter or a radius
_NEAR = 24  # characters between a noun and the side


def find_wrong_ropes(template: Template, examples: Sequence[Solution]) -> Iterator[Message]:
    """The sides of a circle on which it touches nothing straight, though it does elsewhere."""
    nouns = {
        noun: given
        for given in template.parameters.values()
        if given.unit.is_length and any(_names_circle(text) for text in given.means.texts)
        for noun in _list_nouns(given)
    }
    for text in template.words.statement.texts:
        for sentence in list_sentences_of(text):
            for noun, said, side in _list_ropes(sentence, nouns):
                found = [_list_contacts(each, nouns[noun]) for each in examples]
                if any(found) and not any(side * each > 0 for sides in found for each in sides):
                    yield Message("template.lies-otherwise", said=said)


def _names_circle(text: str) -> bool:
    """Whether words name a radius or a diameter."""
    known = [*list_words("a-radius"), *list_words("a-diameter")]
    return any(word in text.lower() for word in known)


def _list_nouns(given: Parameter) -> Iterator[str]:
    """The nouns of what a given is the radius of."""
    for claim in read_texts(given.means.texts, "of-noun"):
        yield claim["noun"].split()[-1]


def _list_ropes(sentence: str, nouns: Mapping[str, Parameter]) -> Iterator[tuple[str, str, float]]:
    """The nouns of a sentence with a side, behind words for a rope that runs there."""
    runs = re.search(write_words("rope-runs"), sentence, re.IGNORECASE)
    for noun in nouns if runs else ():
        for kind, side in _SIDES.items():
            words = rf"(?:{write_words(kind)})"
            name = re.escape(noun)
            before = rf"(?<!\w){name}(?!\w)[^.;。；$]{{0,{_NEAR}}}?{words}"
            of_noun = "|".join(map(re.escape, list_words(kind)))
            behind = rf"(?:{of_noun})\s+of\s+the\s+{name}(?!\w)"
            for match in re.finditer(rf"{before}|{behind}", sentence, re.IGNORECASE):
                yield noun, " ".join(match[0].split()), side


def _list_contacts(each: Solution, given: Parameter) -> list[float]:
    """How far to the right of their centres circles of a given size touch straight lines."""
    mechanism = each.assembly.mechanism.map(float)
    value = abs(each.parameters[given.name].value) * Floats().scale(given.unit.scale)
    found = []
    for joint in mechanism.joints:
        if isinstance(joint, TouchingPair) and isinstance(joint.on, Line):
            sizes = [abs(joint.circle.radius - share * value) for share in _SHARES]
            if min(sizes) <= DIFFERENT * value:
                along, step = (
                    joint.on.direction,
                    joint.on.point - each.doubles.points[joint.circle.centre],
                )
                found.append(float((step - along * (along.dot(step) / along.squared())).x))
    return found
