"""Claims of where points lie: the length beside two of them, the midpoint of a line, the side of
another one.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence

from kinegrade.figure.plane import length
from kinegrade.language.message import Message
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.floats import Floats
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.template import Template
from kinegrade.proof.claims.patterns import NO_SUBJECT
from kinegrade.proof.claims.reading import DIFFERENT, find_points, read_claims

_SIDES: Mapping[str, Callable[[Vector, float], bool]] = {
    "above": lambda step, room: abs(step.x) <= room < step.y,
    "below": lambda step, room: abs(step.x) <= room < -step.y,
    "right": lambda step, room: step.x > room,
    "left": lambda step, room: step.x < -room,
}
_OF_ANOTHER = (
    "(?<!above )(?<!below )(?<!of )(?<!über )(?<!unter )(?<!von )"  # which has the distance
)


def find_wrong_places(template: Template, examples: Sequence[Solution]) -> Iterator[Message]:
    """What is said of lengths, midpoints, distances and sides, and is not so."""
    yield from _find_wrong_lengths(template, examples)
    yield from _find_wrong_midpoints(template, examples)
    yield from _find_wrong_distances(template, examples)
    yield from _find_wrong_sides(template, examples)


def _find_wrong_lengths(template: Template, examples: Sequence[Solution]) -> Iterator[Message]:
    """`$AB$ of length {{ l }}` where the points are at another distance."""
    for claim in read_claims(template, "length"):
        ends = find_points(template, claim["start"], claim["end"])
        yield from _compare(template, claim, ends, claim["start"] + claim["end"], examples)


def _compare(
    template: Template,
    claim: Mapping[str, str],
    ends: Sequence[str],
    line: str,
    examples: Sequence[Solution],
) -> Iterator[Message]:
    """That a given of a claim is not the distance of its points."""
    given = template.parameters.get(claim["given"])
    if not ends or given is None or not given.unit.is_length:
        return
    scale = Floats().scale(given.unit.scale)
    values = [
        (abs(each.parameters[given.name].value), _measure(each, *ends) / scale) for each in examples
    ]
    wrong = [pair for pair in values if abs(pair[0] - pair[1]) > DIFFERENT * pair[0]]
    for stated, shown in wrong[:1]:
        yield Message(
            "template.length-contradicted",
            line=line,
            name=given.name,
            shown=f"{shown:.4g} {given.unit.printed}",
            stated=f"{stated:.4g} {given.unit.printed}",
        )


def _find_wrong_midpoints(template: Template, examples: Sequence[Solution]) -> Iterator[Message]:
    """`the midpoint $D$ of $AB$` where D is elsewhere."""
    for claim in read_claims(template, "midpoint"):
        names = find_points(template, claim["point"], claim["start"], claim["end"])
        for each in examples if names else ():
            middle, start, end = (each.doubles.points[name] for name in names)
            if length(middle + middle - start - end) > DIFFERENT * length(end - start):
                line = claim["start"] + claim["end"]
                yield Message("template.no-midpoint", point=claim["point"], line=line)
                break


def _find_wrong_distances(template: Template, examples: Sequence[Solution]) -> Iterator[Message]:
    """`$C$ at the distance {{ d }} from $A$` where it is at another one."""
    for claim in read_claims(template, "distance", NO_SUBJECT + _OF_ANOTHER):
        ends = find_points(template, claim["point"], claim["other"])
        yield from _compare(template, claim, ends, claim["point"] + claim["other"], examples)


def _find_wrong_sides(template: Template, examples: Sequence[Solution]) -> Iterator[Message]:
    """`$C$, vertically above $O$` where it is elsewhere."""
    for side, holds in _SIDES.items():
        for claim in read_claims(template, side, NO_SUBJECT):
            names = find_points(template, claim["point"], claim["other"])
            for each in examples if names else ():
                point, other = (each.doubles.points[name] for name in names)
                if not holds(point - other, DIFFERENT * length(point - other)):
                    named = {"point": claim["point"], "other": claim["other"]}
                    yield Message(f"template.not-{side}", **named)
                    break


def _measure(solution: Solution, start: str, end: str) -> float:
    """The distance of two points in metres."""
    return length(solution.doubles.points[end] - solution.doubles.points[start])
