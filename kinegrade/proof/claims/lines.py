"""Claims of how points and lines lie: above another point or a line, horizontal, at an angle with
the vertical, so many times as long as another line, the lowest of a rim.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from math import cos, pi, radians, sin

from kinegrade.figure.plane import angle_of, length
from kinegrade.language.message import Message
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.template import Parameter, Template
from kinegrade.proof.claims.patterns import LETTER, NO_SUBJECT
from kinegrade.proof.claims.reading import DIFFERENT, find_points, read_claims

_Claim = Mapping[str, str]
_Holds = Callable[[Solution], bool]
_FACTOR = r"\\sqrt\s*\{?(?P<root>\d+)\}?|(?P<number>\d+(?:\.\d+)?)|"
_RATIO = re.compile(
    rf"(?=[$=]\s*(?P<start>{LETTER})(?P<end>{LETTER})\s*=\s*(?:{_FACTOR})(?:\\[,;:! ])?\s*"
    rf"(?P<from>{LETTER})(?P<to>{LETTER})\s*[$=])"
)
_PLACES: Mapping[str, Callable[..., bool]] = {
    "level-above": lambda point, other: bool(point.y > other.y),
    "level-below": lambda point, other: bool(point.y < other.y),
    "line-above": lambda point, start, end: _measure_height(point, start, end) >= 0,
    "line-below": lambda point, start, end: _measure_height(point, start, end) <= 0,
    "level-with": lambda point, other: _is_along(other - point, 0),
    "upright-with": lambda point, other: _is_along(other - point, pi / 2),
    "right-of-vertical": lambda start, end: bool(end.x > start.x),
    "left-of-vertical": lambda start, end: bool(end.x < start.x),
    "farther": lambda point, other, than: length(point - other) > length(than - other),
    "nearer": lambda point, other, than: length(point - other) < length(than - other),
    "line-horizontal": lambda start, end: _is_along(end - start, 0),
    "line-vertical": lambda start, end: _is_along(end - start, pi / 2),
}
_PARTS = ("point", "other", "than", "start", "end")
_BEYOND: Mapping[str, int] = {"farthest": 1, "nearest": -1}
_UPRIGHT: Mapping[str, float] = {"horizontal": 0.0, "vertical": pi / 2}
_EXTREMES: Mapping[str, float] = {"right": 0.0, "top": pi / 2, "left": pi, "bottom": -pi / 2}


def find_wrong_lines(template: Template, examples: Sequence[Solution]) -> Iterator[Message]:
    """What is said of how points and lines lie, and is not so in some instance."""
    wrong = (
        claim["said"]
        for claim, holds in _list_claims(template)
        if not all(holds(each) for each in examples)
    )
    yield from (Message("template.lies-otherwise", said=said) for said in dict.fromkeys(wrong))


def _list_claims(template: Template) -> Iterator[tuple[_Claim, _Holds]]:
    """The claims, each with what tells whether it holds in an instance."""
    for kind, holds in _PLACES.items():
        for claim, names in _read_named(template, kind):
            yield claim, _hold_place(names, holds)
    for kind, upright in _UPRIGHT.items():
        for claim, names in _read_named(template, f"angle-with-{kind}"):
            given = template.parameters.get(claim["given"])
            if given is not None and given.unit.angle and not given.unit.time:
                yield claim, _hold_angle(names, given, upright)
    for side, direction in _EXTREMES.items():
        for claim, names in _read_named(template, f"extreme-{side}"):
            yield claim, _hold_extreme(names[0], direction)
    for kind, sign in _BEYOND.items():
        for claim, names in _read_named(template, kind):
            yield claim, _hold_beyond(names, sign)
    yield from _list_ratios(template)


def _read_named(template: Template, kind: str) -> Iterator[tuple[_Claim, Sequence[str]]]:
    """The claims of a kind whose letters are points, with these."""
    for claim in read_claims(template, kind, NO_SUBJECT):
        names = find_points(template, *(claim[part] for part in _PARTS if part in claim))
        if names:
            yield claim, names


def _list_ratios(template: Template) -> Iterator[tuple[_Claim, _Holds]]:
    """The claims of lines that are so many times as long as others."""
    for text in template.words.statement.texts:
        for match in _RATIO.finditer(text):
            names = find_points(template, *match.group("start", "end", "from", "to"))
            if names:
                said = text[match.start() :].split("$")[text[match.start()] == "$"]
                yield {"said": f"${said}$"}, _hold_ratio(names, match)


def _hold_place(names: Sequence[str], holds: Callable[..., bool]) -> _Holds:
    """Whether points lie in a way."""
    return lambda each: holds(*_place(each, names))


def _hold_angle(names: Sequence[str], given: Parameter, upright: float) -> _Holds:
    """Whether a line has an angle with the horizontal or vertical, on whatever side it is."""

    def holds(each: Solution) -> bool:
        start, end = _place(each, names)
        value = each.parameters[given.name].value
        stated = radians(value) if given.unit.degrees else value
        shown = angle_of(end - start) - upright
        return abs(abs(sin(shown)) - abs(sin(stated))) <= DIFFERENT

    return holds


def _hold_extreme(name: str, direction: float) -> _Holds:
    """Whether a point lies from some other one in exactly that direction."""

    def holds(each: Solution) -> bool:
        at = each.doubles.points
        steps = [at[name] - at[other] for other in at if other != name]
        return any(
            length(step) > 0 and 1 - cos(angle_of(step) - direction) < DIFFERENT**2
            for step in steps
        )

    return holds


def _hold_beyond(names: Sequence[str], side: int) -> _Holds:
    """Whether a point lies right behind some third one as seen from the other, or right before."""

    def holds(each: Solution) -> bool:
        point, other = _place(each, names)
        steps = [(at - other, point - at) for at in each.doubles.points.values()]
        return any(
            length(there) > 0 < length(on)
            and abs(there.cross(on)) <= DIFFERENT * length(there) * length(on)
            and side * there.dot(on) > 0
            for there, on in steps
        )

    return holds


def _hold_ratio(names: Sequence[str], match: re.Match[str]) -> _Holds:
    """Whether a line is so many times as long as another one."""
    factor = float(match["root"]) ** 0.5 if match["root"] else float(match["number"] or 1)

    def holds(each: Solution) -> bool:
        start, end, first, last = _place(each, names)
        whole, part = length(end - start), length(last - first)
        return abs(whole - factor * part) <= DIFFERENT * max(whole, part)

    return holds


def _place(each: Solution, names: Sequence[str]) -> list[Vector]:
    """Where points are in an instance."""
    return [each.doubles.points[name] for name in names]


def _is_along(step: Vector, direction: float) -> bool:
    """Whether a line is parallel to a direction."""
    return abs(sin(angle_of(step) - direction)) <= DIFFERENT


def _measure_height(point: Vector, start: Vector, end: Vector) -> float:
    """How far a point is above a line; nothing where the line is vertical."""
    along = end - start
    side = along.cross(point - start)
    room = DIFFERENT * along.squared()
    if abs(along.x) <= DIFFERENT * length(along) or abs(side) <= room:
        return 0.0
    return float(side if along.x > 0 else -side)
