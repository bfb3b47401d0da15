"""Claims of how wheels touch: where a rope leaves a drum, outside or inside which gears mesh."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kinegrade.language.message import Message
from kinegrade.mechanics.joints.belt import Belt
from kinegrade.mechanics.joints.touching_pair import TouchingPair
from kinegrade.mechanics.shapes import Line
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.template import Template
from kinegrade.proof.claims.patterns import list_words
from kinegrade.proof.claims.reading import find_points, read_claims


def find_wrong_wheels(template: Template, examples: Sequence[Solution]) -> Iterator[Message]:
    """What is said of wheels that touch, and is not so."""
    for side, sign in (("right", 1), ("left", -1)):
        for claim in read_claims(template, f"leaves-{side}"):
            for centre in find_points(template, claim["point"]):
                sides = [_measure_sides(each, centre) for each in examples]
                if any(found and max(found) < 0 for found in _turn(sides, sign)):
                    yield Message("template.lies-otherwise", said=claim["said"])
    yield from _find_too_many_external(template)
    yield from _find_other_belts(template)


def _turn(sides: Sequence[Sequence[float]], sign: int) -> list[list[float]]:
    """How far what touches is to a side, from how far it is to the right."""
    return [[sign * each for each in found] for found in sides]


def _measure_sides(example: Solution, centre: str) -> list[float]:
    """How far to the right of a centre the lines are that its circles touch."""
    mechanism = example.assembly.mechanism.map(float)
    found = []
    for joint in mechanism.joints:
        if not isinstance(joint, TouchingPair) or joint.circle.centre != centre:
            continue
        if isinstance(joint.on, Line):
            along = joint.on.direction
            step = joint.on.point - mechanism.points[centre]
            foot = step - along * (along.dot(step) / along.squared())
            found.append(float(foot.x))
    return found


def _find_too_many_external(template: Template) -> Iterator[Message]:
    """That gears are said to mesh externally more often than they do, and never internally."""
    meshings = [
        "inside" in joint.options
        for joint in template.scheme.joints
        if joint.circle and joint.on and joint.on.function == "circle"
    ]
    external = meshings.count(False)
    for text in template.words.statement.texts:
        said = text.lower()
        number = sum(map(said.count, list_words("external")))
        if number > external < len(meshings) and not any(
            word in said for word in list_words("internal")
        ):
            yield Message("template.external-too-often", number=number, external=external)


def _find_other_belts(template: Template) -> Iterator[Message]:
    """`an open belt` where all belts are crossed, or the other way round."""
    belts = {
        "crossed" in joint.options
        for joint in template.scheme.joints
        if issubclass(joint.stated, Belt)
    }
    words = {True: [*list_words("crossed-belt")], False: [*list_words("open-belt")]}
    for text in template.words.statement.texts:
        for crossed, said in words.items():
            named = [each for each in said if each in text]
            if belts == {not crossed} and named and not any(map(text.count, words[not crossed])):
                yield Message("template.belt-otherwise", said=named[0])
