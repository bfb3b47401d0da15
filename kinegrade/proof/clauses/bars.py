"""Claims of bars: that there is one between two points, which of its ends is the upper one, what
lies on it beyond an end, where it is pivoted.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence

from kinegrade.expressions.tree import find_names
from kinegrade.figure.plane import length
from kinegrade.language.message import Message
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.template import Template
from kinegrade.proof.claims.nouns import Nouns
from kinegrade.proof.claims.patterns import write_words
from kinegrade.proof.claims.reading import DIFFERENT, find_points, read_claims

_ENDS: Mapping[str, Vector] = {
    "end-right": Vector(1.0, 0.0),
    "end-left": Vector(-1.0, 0.0),
    "end-above": Vector(0.0, 1.0),
    "end-below": Vector(0.0, -1.0),
}
_Holds = Callable[[Solution], bool]


def find_wrong_bars(template: Template, examples: Sequence[Solution]) -> Iterator[Message]:
    """What is said of bars and is not so in some instance."""
    bodies = _list_bodies(template)
    for claim in read_claims(template, "one-bar"):
        ends = {*find_points(template, claim["start"], claim["end"])}
        if ends and not any(ends <= {*body} for body in bodies):
            yield Message("template.no-such-bar", said=claim["said"])
    for said, holds in _list_claims(template, bodies):
        if not all(map(holds, examples)):
            yield Message("template.lies-otherwise", said=said)


def _list_bodies(template: Template) -> list[frozenset[str]]:
    """The points of each body with those of its joints, and of the ground."""
    nouns = Nouns(template)
    pins = {joint.point for joint in template.scheme.joints if GROUND in joint.bodies}
    lines = [joint.on for joint in template.scheme.joints if joint.on and joint.of == GROUND]
    fixed = pins.union(*map(find_names, lines))
    loose = set(template.scheme.points).difference(
        *(body.points for body in template.scheme.bodies)
    )
    own = [nouns.list_points(body.name) for body in template.scheme.bodies]
    return [*own, frozenset(fixed | loose)]


def _list_claims(
    template: Template, bodies: Sequence[frozenset[str]]
) -> Iterator[tuple[str, _Holds]]:
    """The claims of ends and pivots, each with what tells whether it holds in an instance."""
    for kind, toward in _ENDS.items():
        for claim in read_claims(template, kind):
            for name in find_points(template, claim["point"]):
                own = [body.points for body in template.scheme.bodies if name in body.points]
                yield claim["said"], _hold_end(name, own, toward)
    for claim in read_claims(template, "beyond"):
        names = find_points(template, claim["start"], claim["end"], claim["point"])
        if names and names[2] in names[:2] and not _is_leg(claim["ahead"]):
            yield claim["said"], _hold_beyond(names)
    for claim in read_claims(template, "pivoted"):
        names = find_points(template, claim["start"], claim["end"], claim["point"])
        if names:
            yield claim["said"], _hold_pivot(frozenset(names), bodies)


def _is_leg(ahead: str) -> bool:
    """Whether words lead up to a leg of an angle, as `the angle from the extension`: nothing need
    lie on it.
    """
    return re.search(rf"(?:{write_words('leg')})\s+$", ahead, re.IGNORECASE) is not None


def _hold_pivot(names: frozenset[str], bodies: Sequence[frozenset[str]]) -> _Holds:
    """Whether some body has all of these points, at any instance."""
    return lambda _: any(names <= body for body in bodies)


def _hold_end(name: str, bodies: Sequence[Sequence[str]], toward: Vector) -> _Holds:
    """Whether a point is the end of some body on a side: another point lies farther back."""

    def holds(each: Solution) -> bool:
        at = each.doubles.points
        steps = [at[name] - at[other] for body in bodies for other in body if other != name]
        return not steps or any(step.dot(toward) > 0 for step in steps)

    return holds


def _hold_beyond(names: Sequence[str]) -> _Holds:
    """Whether some point lies on a line beyond one of its ends."""
    start, end, last = names

    def holds(each: Solution) -> bool:
        at = each.doubles.points
        along = at[last] - at[start if last == end else end]
        steps = [point - at[last] for point in at.values()]
        return any(
            step.dot(along) > DIFFERENT * along.squared()
            and abs(step.cross(along)) <= DIFFERENT * length(step) * length(along)
            for step in steps
        )

    return holds
