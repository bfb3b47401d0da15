"""Claims of the sense in which an angle is counted."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from math import cos, pi, radians

from kinegrade.figure.plane import angle_of
from kinegrade.language.message import Message
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.template import Template
from kinegrade.proof.claims.patterns import LETTER, list_words
from kinegrade.proof.claims.reading import DIFFERENT, find_points, read_claims

_LINE = re.compile(rf"\$({LETTER})({LETTER})\$")


def find_wrong_angles(template: Template, examples: Sequence[Solution]) -> Iterator[Message]:
    """`$OA$ makes an angle {{ phi }} with the $x$ axis, measured clockwise` where it is so only
    when counted the other way round.
    """
    for sense, turn in (("counterclockwise", 1), ("clockwise", -1)):
        for claim in read_claims(template, f"angle-{sense}"):
            ends = find_points(template, claim["start"], claim["end"])
            given = template.parameters.get(claim["given"])
            if not ends or given is None or not given.unit.angle or given.unit.time:
                continue
            for each in examples:
                value = each.parameters[given.name].value
                stated = radians(value) if given.unit.degrees else value
                stated = turn * (abs(stated) if claim["part"] == "size" else stated)
                start = _find_reference(template, claim["between"], each)
                if start is None:
                    break
                shown = _find_direction(each, *ends) - start
                if not _is_same(shown, stated) and _is_same(shown, -stated):
                    yield Message("template.angle-other-way", said=claim["said"], name=given.name)
                    break


def _find_reference(template: Template, said: str, example: Solution) -> float | None:
    """The direction from which an angle is said to be counted; None where it is not known."""
    line = _LINE.search(said)
    if line:
        ends = find_points(template, *line.groups())
        return _find_direction(example, *ends) if ends else None
    if any(word in said for word in list_words("another-way")):
        return None
    axes = {"$x$": 0.0, "$y$": pi / 2}
    return next((angle for axis, angle in axes.items() if axis in said), None)


def _find_direction(example: Solution, start: str, end: str) -> float:
    """The direction from a point to another one."""
    at = example.doubles.points
    return angle_of(at[end] - at[start])


def _is_same(angle: float, other: float) -> bool:
    """Whether two rotations lead to the same direction."""
    return 1 - cos(angle - other) < DIFFERENT**2
