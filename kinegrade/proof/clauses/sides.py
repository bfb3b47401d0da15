"""Claims of where parts lie that are named by letters or nouns: `the load hangs on the left of the
drum`, `the guide passes a distance {{ e }} below $O$`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache

from kinegrade.expressions.tree import find_names
from kinegrade.figure.plane import length
from kinegrade.language.message import Message
from kinegrade.mechanics.shapes import Line
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.floats import Floats
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.template import Parameter, Template
from kinegrade.proof.claims.patterns import NO_SUBJECT, write_words
from kinegrade.proof.claims.reading import DIFFERENT, read_claims
from kinegrade.proof.clauses.parts import Part, list_guides
from kinegrade.proof.clauses.sentences import Mention, Sentence, has_condition, list_sentences
from kinegrade.proof.clauses.subjects import (
    find_neighbour,
    find_subject,
    list_other_readings,
)

_SIDES: Mapping[str, Vector] = {
    "above": Vector(0.0, 1.0),
    "below": Vector(0.0, -1.0),
    "right": Vector(1.0, 0.0),
    "left": Vector(-1.0, 0.0),
}
_KNOWN = (
    "above",
    "below",
    "right",
    "left",
    "level-above",
    "level-below",
)  # read by whole sentences


@dataclass(frozen=True)
class Side:
    """Words that say on which side of a part something lies, `upright` where right above it, with
    the length that is said to be between.
    """

    sentence: Sentence
    start: int
    said: str
    toward: Vector
    upright: bool
    given: str
    reference: Mention


def find_wrong_sides(template: Template, examples: Sequence[Solution]) -> Iterator[Message]:
    """What is said of sides that is so in no way in which the words can be read."""
    claims = [claim for kind in _KNOWN for claim in read_claims(template, kind, NO_SUBJECT)]
    known = [_squeeze(claim["ahead"] + claim["said"]) for claim in claims]
    for sentence in list_sentences(template):
        for side in _list_sides(sentence):
            yield from _find_wrong_chain(side, examples)
            words = _squeeze(sentence.text[: side.reference.end])
            if any(words.endswith(each) or each.endswith(words) for each in known):
                continue
            subject = _find_subject(side)
            given = _find_length(template, side.given)
            if _is_false_of_all(subject, side, examples) or (
                given and _is_nowhere(given, side, examples)
            ):
                within = subject and subject in sentence.mentions
                start = subject.start if subject and within else side.start
                said = sentence.text[start : side.start] + side.said
                yield Message("template.lies-otherwise", said=" ".join(said.split()))


def _squeeze(text: str) -> str:
    """A text without room."""
    return "".join(text.split())


def _find_wrong_chain(side: Side, examples: Sequence[Solution]) -> Iterator[Message]:
    """`$A$ above $O$ and to its left`: another side of the same part."""
    text, subject = side.sentence.text, find_neighbour(side.sentence, side.start)
    for kind, toward in _SIDES.items():
        pattern = rf"\s*,?\s*(?:{write_words('or')})\s+(?:{write_words(f'chain-{kind}')})"
        match = re.compile(pattern, re.IGNORECASE).match(text, side.reference.end)
        if match and subject:
            said = " ".join(text[side.start : match.end()].split())
            other = replace(side, toward=toward, upright=False, given="", said=said)
            if _is_false(subject, other, examples):
                yield Message("template.lies-otherwise", said=f"{subject.said} {said}")


def _find_subject(side: Side) -> Mention | None:
    """What is said to lie on a side; None where that may be the place of a contact."""
    subject = find_subject(side.sentence, side.start)
    contact = re.compile(write_words("contact-verb"), re.IGNORECASE)
    start = subject.end if subject and subject.end <= side.start else 0
    return None if contact.search(side.sentence.text[start : side.start]) else subject


def _list_sides(sentence: Sentence) -> Iterator[Side]:
    """The sides of known parts of which a sentence speaks."""
    if has_condition(sentence.text):
        return
    for match in _write_side().finditer(sentence.text):
        [kind] = [kind for kind in _SIDES if match[kind]]
        reference = _find_behind(sentence, match.end())
        if reference is None or not reference.is_known:
            continue
        said = " ".join(sentence.text[match.start() : reference.end].split())
        upright = match["upright"] is not None
        given = match["given"] or ""
        yield Side(sentence, match.start(), said, _SIDES[kind], upright, given, reference)


def _find_behind(sentence: Sentence, place: int) -> Mention | None:
    """What is named at a place, or whose level is."""
    behind = re.compile(rf"\s*(?:(?:{write_words('level-of')})\s*)?", re.IGNORECASE)
    match = behind.match(sentence.text, place)
    start = match.end() if match else place
    return next((each for each in sentence.mentions if each.start == start), None)


@cache
def _write_side() -> re.Pattern[str]:
    """A side, with the length before it."""
    sides = "|".join(
        rf"(?P<{kind}>{write_words(f'side-{kind}')}" + rf"|{_write_upright(kind)})"
        for kind in _SIDES
    )
    given = r"(?:\{\{\s*(?P<given>\w+)[^}]*\}\}\s*(?:\(\$[^$]*\$\)\s*)?)"
    return re.compile(
        rf"{given}?(?:(?P<upright>{write_words('upright')})\s+)?(?:{sides})", re.IGNORECASE
    )


def _write_upright(kind: str) -> str:
    """A preposition that says a side with an adverb before it alone, as German `über`."""
    if kind not in {"above", "below"}:
        return r"(?!)"
    return rf"(?<=[a-z]\s)(?(upright)(?:{write_words(f'side-{kind}-upright')})|(?!))"


def _is_false_of_all(subject: Mention | None, side: Side, examples: Sequence[Solution]) -> bool:
    """Whether nothing of which a side may be said lies there in some instance: what the sentence
    speaks of, or what it names last.
    """
    readings = [] if subject is None else [subject]
    readings += list_other_readings(side.sentence, side.start)
    return subject is not None and all(_is_false(each, side, examples) for each in readings)


def _is_false(subject: Mention, side: Side, examples: Sequence[Solution]) -> bool:
    """Whether nothing that may be meant lies on that side in some instance."""
    others = [part for parts in side.reference.things for part in parts]
    return not all(
        all(
            any(_lies(part, other, side, each) for part in parts for other in others)
            for parts in subject.things
        )
        for each in examples
    )


def _lies(part: Part, other: Part, side: Side, each: Solution) -> bool:
    """Whether some place of a part lies on a side of some place of another one."""
    if set(part.points) & set(other.points) and len(part.points) == len(other.points) == 1:
        return True  # the drum and its axis: what is meant is not known
    steps = [
        place - other_place
        for place in part.list_places(each)
        for other_place in other.list_places(each)
    ]
    steps += [step for step, _ in _list_guide_steps(part, other, side, each)]
    return any(_is_toward(step, side) for step in steps) or not steps


def _list_guide_steps(
    part: Part, other: Part, side: Side, each: Solution
) -> Iterator[tuple[Vector, Line]]:
    """How far guides are from the places of another part, or it from these, along a side."""
    for guide, places, turn in ((part, other, 1.0), (other, part, -1.0)):
        for line in list_guides(each) if guide.is_guide else ():
            for place in places.list_places(each):
                step = _measure_step(line, place, side.toward)
                if step is not None:
                    yield step * turn, line


def _measure_step(line: Line, place: Vector, toward: Vector) -> Vector | None:
    """From a place to a line, straight to one side or the other; None where it is parallel."""
    along = line.direction
    across = toward.cross(along)
    if abs(across) <= DIFFERENT * length(along):
        return None
    return toward * float((line.point - place).cross(along) / across)


def _is_toward(step: Vector, side: Side) -> bool:
    """Whether a step leads to a side, straight where that is said; by a given length it may lead
    nowhere, as that may be drawn as zero.
    """
    room, along = DIFFERENT * length(step), step.dot(side.toward)
    straight = not side.upright or abs(step.cross(side.toward)) <= room
    return straight and bool(along > room or (side.given and along >= -room))


def _find_length(template: Template, name: str) -> Parameter | None:
    """A given length on which the mechanism depends."""
    given = template.parameters.get(name)
    if given is None or not given.unit.is_length:
        return None
    scheme = template.scheme
    shapes = [shape for joint in scheme.joints for shape in (joint.circle, joint.on) if shape]
    stated = [*scheme.points.values(), *scheme.lengths.values(), *shapes]
    return given if any(name in find_names(each) for each in stated) else None


def _is_nowhere(given: Parameter, side: Side, examples: Sequence[Solution]) -> bool:
    """Whether in some instance nothing lies on a side at the distance that is given."""
    others = [part for parts in side.reference.things for part in parts]
    if any(part.is_guide or not part.points for part in others):
        return False
    return not all(
        any(_is_at(each, given, side, place) for part in others for place in part.list_places(each))
        for each in examples
    )


def _is_at(each: Solution, given: Parameter, side: Side, place: Vector) -> bool:
    """Whether some point or line lies at the given distance on the side of a place."""
    value = abs(each.parameters[given.name].value) * Floats().scale(given.unit.scale)
    steps = [point - place for point in each.doubles.points.values()]
    for joint in each.assembly.mechanism.map(float).joints:
        found = (_measure_step(line, place, side.toward) for line in joint.list_lines())
        steps += [step for step in found if step is not None]
    measures: tuple[Callable[[Vector], float], ...] = (side.toward.dot, length)
    return any(
        _is_toward(step, side) and abs(measure(step) - value) <= DIFFERENT * max(value, DIFFERENT)
        for step in steps
        for measure in measures
    )
