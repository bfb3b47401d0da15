"""Claims of the way in which guides lie: `a horizontal guide`, `is guided vertically`."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence

from kinegrade.figure.plane import length
from kinegrade.language.message import Message
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.template import Template
from kinegrade.proof.claims.patterns import write_words
from kinegrade.proof.claims.reading import DIFFERENT
from kinegrade.proof.clauses.parts import STILL
from kinegrade.proof.clauses.sentences import Sentence, has_condition, list_sentences
from kinegrade.proof.clauses.subjects import find_subject

_LIE: Mapping[str, Vector] = {
    "is-horizontal": Vector(1.0, 0.0),
    "is-vertical": Vector(0.0, 1.0),
}
_GUIDED: Mapping[str, Vector] = {
    "guided-horizontally": Vector(1.0, 0.0),
    "guided-vertically": Vector(0.0, 1.0),
}


def find_wrong_guides(template: Template, examples: Sequence[Solution]) -> Iterator[Message]:
    """The guides of which none lies as is said, and the parts that move otherwise."""
    for sentence in list_sentences(template):
        if has_condition(sentence.text):
            continue
        for kind, along in _LIE.items():
            pattern = rf"(?:{write_words(kind)})\s+(?:{write_words('guiding-thing')})"
            for match in re.finditer(pattern, sentence.text, re.IGNORECASE):
                if not _has_guide(template, along, examples):
                    yield Message("template.lies-otherwise", said=" ".join(match[0].split()))
        for kind, along in _GUIDED.items():
            for match in re.finditer(write_words(kind), sentence.text, re.IGNORECASE):
                if _moves_otherwise(sentence, match.start(), along, examples):
                    yield Message("template.lies-otherwise", said=" ".join(match[0].split()))


def _has_guide(template: Template, along: Vector, examples: Sequence[Solution]) -> bool:
    """Whether some point or wheel runs on a line along an axis in every instance, or none runs on a
    line at all.
    """
    guided = [
        [
            line.direction
            for line in joint.list_lines()
            if abs(line.direction.cross(along)) <= DIFFERENT * length(line.direction)
        ]
        for each in examples
        for joint in each.assembly.mechanism.map(float).joints
    ]
    grounded = [joint for joint in template.scheme.joints if joint.on and joint.of == GROUND]
    return any(guided) or not grounded


def _moves_otherwise(
    sentence: Sentence, place: int, along: Vector, examples: Sequence[Solution]
) -> bool:
    """Whether all that the sentence may speak of moves across an axis in an instance."""
    subject = find_subject(sentence, place)
    if subject is None:
        return False
    for each in examples:
        for parts in subject.things:
            moves = [step for part in parts for step in part.list_velocities(each)]
            across = [abs(step.cross(along)) for step in moves]
            if across and min(across) > STILL:
                return True
    return False
