"""Why a velocity pole moves on a circle: proofs by Thales' theorem, for mechanisms that have
one.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import asdict, dataclass
from itertools import chain, combinations
from typing import assert_never

from kinegrade.language.message import Message, Text
from kinegrade.mechanics.shapes import Line
from kinegrade.worked.case import Case
from kinegrade.worked.formulas.atoms import Symbol
from kinegrade.worked.formulas.equation import Equation, Link, equate
from kinegrade.worked.formulas.measures import bearing, length
from kinegrade.worked.formulas.numbers import measure, state_number
from kinegrade.worked.steps.poles.poles import name_pole
from kinegrade.worked.vectors.arms import name_length
from kinegrade.worked.vectors.slopes.cosines import Cosine, find_cosine
from kinegrade.worked.vectors.slopes.directions import name_along

_RIGHT = 90.0


@dataclass(frozen=True)
class TwoGuides:
    """Two points of the body are on fixed straight guides, which meet at the point `corner`."""

    first: str
    second: str
    corner: str


@dataclass(frozen=True)
class CrankAndSleeve:
    """The body is pinned at `pin` to a crank about the fixed `pivot`, and slides through a sleeve
    that turns about the fixed point `sleeve`, as far from the pivot as the pin.
    """

    pivot: str
    pin: str
    sleeve: str


Proof = TwoGuides | CrankAndSleeve


def find_proof(body: str, case: Case) -> Proof | None:
    """The proof that applies to the fixed centrode of a body, None where none does."""
    return next(chain[Proof](_find_guides(body, case), _find_sleeves(body, case)), None)


def _find_guides(body: str, case: Case) -> Iterator[TwoGuides]:
    """Pairs of fixed straight guides of points of a body, which meet at a named point."""
    mechanism = case.motion.frames.mechanism
    for (first, one), (second, other) in combinations(mechanism.find_guides(body), 2):
        if case.arithmetic.is_zero(one.direction.cross(other.direction)):
            continue
        for name in mechanism.points:
            if _lies_on(name, one, case) and _lies_on(name, other, case):
                yield TwoGuides(first, second, name)


def _lies_on(point: str, line: Line, case: Case) -> bool:
    """Whether a point lies on a line."""
    away = case.motion.points[point] - line.point
    return bool(case.arithmetic.is_zero(away.cross(line.direction)))


def _find_sleeves(body: str, case: Case) -> Iterator[CrankAndSleeve]:
    """Pins of a body on a crank, with a sleeve as far from the fixed point of the crank."""
    mechanism, points = case.motion.frames.mechanism, case.motion.points
    pivots = mechanism.find_pivots()
    for holder, line in mechanism.find_sleeves(body):
        for pivot, pin in _find_cranks(body, case):
            sleeve = pivots.get(holder)
            if sleeve is None or not _lies_on(pin, line, case) or not _lies_on(sleeve, line, case):
                continue
            reach, away = points[pin] - points[pivot], points[sleeve] - points[pivot]
            if case.arithmetic.is_zero(reach.squared() - away.squared()):
                yield CrankAndSleeve(pivot, pin, sleeve)


def _find_cranks(body: str, case: Case) -> Iterator[tuple[str, str]]:
    """The fixed points of the bodies to which a body is pinned, and the pins."""
    mechanism = case.motion.frames.mechanism
    pivots = mechanism.find_pivots()
    for shared in mechanism.shared_points:
        if body in shared.bodies:
            yield from ((pivots[other], shared.point) for other in shared.bodies if other in pivots)


def describe_proof(proof: Proof, body: str, case: Case) -> Message:
    """The proof in words."""
    places: dict[str, Text] = {
        "body": case.naming.body(body),
        "pole": case.naming.point(name_pole(body, case)),
        **{role: case.naming.point(point) for role, point in asdict(proof).items()},
    }
    match proof:
        case TwoGuides():
            return Message("solution.centrode-of-guides", **places)
        case CrankAndSleeve():
            return Message("solution.centrode-of-sleeve", **places)
        case _:
            assert_never(proof)


def state_radius(symbol: Symbol, proof: Proof, body: str, case: Case) -> Equation:
    """The radius of the fixed centrode, by what the proof says of it."""
    match proof:
        case TwoGuides(corner=centre):
            links = _state_diameter(proof, case)
        case CrankAndSleeve(pivot=centre, pin=pin):
            links = equate(name_length(centre, pin, case))
        case _:
            assert_never(proof)
    pole = case.motion.pole(body, case.arithmetic)
    radius = length(pole - case.motion.points[centre], case.arithmetic)
    return Equation(symbol, (*links, *state_number(radius, "m")))


def _state_diameter(guides: TwoGuides, case: Case) -> tuple[Link, ...]:
    """The distance of the guided points over the sine of the angle between the guides."""
    points = case.motion.points
    chord = points[guides.second] - points[guides.first]
    symbols = name_length(guides.first, guides.second, case)
    sine = _find_sine(guides, case)
    if sine is None:
        return equate(symbols)
    numbers = measure(length(chord, case.arithmetic), "m")
    return equate(symbols / sine.state(False), numbers / sine.state(True))


def _find_sine(guides: TwoGuides, case: Case) -> Cosine | None:
    """The sine of the angle between the guides, None where it is a right one."""
    points, corner = case.motion.points, guides.corner
    along = bearing(points[guides.first] - points[corner])
    normal = bearing(points[guides.second] - points[corner]) + _RIGHT
    heading = name_along(along, (corner, guides.first), case)
    axis = name_along(normal, (corner, guides.second), case)
    return find_cosine(heading, axis) if heading and axis else None
