"""Claims of the sense in which an angle is counted, whatever its line is called: `has turned
{{ theta }} clockwise from the horizontal`.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from itertools import permutations
from math import cos, pi

from kinegrade.figure.plane import angle_of, length
from kinegrade.language.message import Message
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.template import Parameter, Template
from kinegrade.proof.claims.patterns import HAN, SENSES, write_words
from kinegrade.proof.claims.reading import DIFFERENT, list_sentences_of, measure_angle, name_senses
from kinegrade.proof.clauses.parts import is_moving, list_guides

_SLOT = re.compile(r"\{\{\s*(\w+)[^}]*\}\}")
_AXES = (0.0, pi / 2, pi, -pi / 2)
_NEAR, _RIGHT_BEHIND = 40, 6  # characters from the word for counting to the sense, and back


def find_wrong_counts(template: Template, examples: Sequence[Solution]) -> Iterator[Message]:
    """The angles that no line has when they are counted as is said, and some line when they are
    counted the other way.
    """
    for text in template.words.statement.texts:
        for sentence in list_sentences_of(text):
            for givens, turn, said in _list_counts(template, sentence):
                if all(_is_other_way(given, turn, examples) for given in givens):
                    yield Message("template.angle-other-way", said=said, name=givens[0].name)


def _list_counts(template: Template, sentence: str) -> Iterator[tuple[list[Parameter], int, str]]:
    """The angles of a sentence of which one is counted in a sense, 1 for counter-clockwise: the
    last before it, or the next.
    """
    goes = re.compile(write_words("goes"), re.IGNORECASE)
    counted = re.compile(write_words("counted"), re.IGNORECASE)
    words = write_words(SENSES["ccw"], SENSES["cw"])
    slots = [*_SLOT.finditer(sentence)]
    for match in re.finditer(words, sentence, re.IGNORECASE):
        before = [each for each in slots if each.end() <= match.start()]
        behind = slots[len(before) : len(before) + 1]
        angles = [each for each in before if _is_angle(template, each[1])][-1:]
        angles += [each for each in behind if _is_angle(template, each[1])]
        near = counted.search(sentence, max(0, match.start() - _NEAR), match.end() + _RIGHT_BEHIND)
        other = re.search(HAN, sentence) or goes.search(sentence, 0, match.start())
        if not angles or (other and not near):
            continue
        turn = 1 if name_senses(match[0].lower()) | name_senses(match[0]) == {"ccw"} else -1
        start, end = min(angles[0].start(), match.start()), max(angles[0].end(), match.end())
        givens = [template.parameters[each[1]] for each in angles]
        yield givens, turn, " ".join(sentence[start:end].split())


def _is_angle(template: Template, name: str) -> bool:
    """Whether that is a given angle, of at least two values, so that the sense can be told."""
    given = template.parameters.get(name)
    return bool(given and given.unit.angle and not given.unit.time and len(given.choices) > 1)


def _is_other_way(given: Parameter, turn: int, examples: Sequence[Solution]) -> bool:
    """Whether lines have an angle only when it is counted the other way."""
    return not _has_line(given, turn, examples) and _has_line(given, -turn, examples)


def _has_line(given: Parameter, turn: int, examples: Sequence[Solution]) -> bool:
    """Whether some line is turned by an angle from an axis in all instances, or a moving one from
    the same fixed line.
    """
    angles = [turn * measure_angle(each, given) for each in examples]
    fixed = [[*_list_fixed(each)] for each in examples]
    moving = [[*_list_moving(each)] for each in examples]
    if any(len({*map(len, lines)}) != 1 for lines in (fixed, moving)) or len({*angles}) == 1:
        return True  # nothing can be told
    axes = [(axis,) * len(examples) for axis in _AXES]
    still, turning = [*zip(*fixed, strict=True)], [*zip(*moving, strict=True)]
    return any(_leads(line, angles, axis) for line in (*still, *turning) for axis in axes) or any(
        _leads(line, angles, other) for line in turning for other in still
    )


def _leads(line: Sequence[float], angles: Sequence[float], other: Sequence[float]) -> bool:
    """Whether angles lead from one direction to another in every instance."""
    return all(
        1 - cos(one - angle - start) < DIFFERENT**2
        for one, angle, start in zip(line, angles, other, strict=True)
    )


def _list_fixed(each: Solution) -> Iterator[float]:
    """The directions of the lines of the ground, and from any of its points to another."""
    at = each.doubles.points
    names = [name for name in at if not is_moving(each, name)]
    yield from _measure_directions(at[end] - at[start] for start, end in permutations(names, 2))
    for line in list_guides(each):
        yield from _measure_directions((line.direction, -line.direction))


def _list_moving(each: Solution) -> Iterator[float]:
    """The directions from any point to another of which one moves, and along moving lines."""
    at = each.doubles.points
    pairs = permutations(at, 2)
    moving = {name for name in at if is_moving(each, name)}
    yield from _measure_directions(
        at[end] - at[start] for start, end in pairs if moving & {start, end}
    )
    joints = each.assembly.mechanism.map(float).joints
    for sentence, joint in zip(each.template.scheme.joints, joints, strict=True):
        if GROUND not in {sentence.of, sentence.body}:
            for line in joint.list_lines():
                yield from _measure_directions((line.direction, -line.direction))


def _measure_directions(steps: Iterable[Vector]) -> Iterator[float]:
    """The directions of steps; that of none is zero."""
    yield from (angle_of(step) if length(step) > 0 else 0.0 for step in steps)
