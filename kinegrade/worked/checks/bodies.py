"""Checks of the points of a body: along the line of two points, whose distance does not change,
their vectors differ by the normal acceleration alone; across it, by the rotation. All of them are
multiplied by the distance, so that no angle is needed.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations
from typing import assert_never

from kinegrade.language.message import Message
from kinegrade.mechanics.rates import make_turning
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Level
from kinegrade.worked.case import Case
from kinegrade.worked.checks.amounts import Amount, add_letters, add_numbers
from kinegrade.worked.checks.arms import point_from
from kinegrade.worked.checks.check import Check, compare
from kinegrade.worked.checks.components import Turned, list_component_checks
from kinegrade.worked.checks.forms import compare_points
from kinegrade.worked.checks.sides import Side
from kinegrade.worked.coincident_points import name_owned_point
from kinegrade.worked.findings import Fact, Piece
from kinegrade.worked.formulas.atoms import AXES, ZERO
from kinegrade.worked.formulas.measures import bearing, double, find_sign, length
from kinegrade.worked.formulas.numbers import measure
from kinegrade.worked.unlettered import is_lettered
from kinegrade.worked.vectors.arms import name_length
from kinegrade.worked.vectors.components import find_heading, name_signed, state_signed
from kinegrade.worked.vectors.facts import make_key
from kinegrade.worked.vectors.slopes.cosines import find_cosine
from kinegrade.worked.vectors.slopes.derived_angles import is_line_found
from kinegrade.worked.vectors.slopes.directions import is_inclination_known, name_along
from kinegrade.worked.vectors.summands import PLACES, name_component
from kinegrade.worked.vectors.vectors import UNITS

_UNITS: Mapping[Level, str] = {"velocity": "m^2/s", "acceleration": "m^2/s^2"}


@dataclass(frozen=True)
class _Pair:
    """Two points of a body whose vectors have been found."""

    body: str
    points: tuple[str, str]
    facts: tuple[Fact, Fact]


def list_new_body_checks(level: Level, case: Case) -> Iterator[Check]:
    """The checks of the points of bodies of which neither has led to the other."""
    for pair in _list_pairs(level, case):
        if _is_new(pair, case):
            yield from _check_pair(pair, level, case)


def list_body_checks(level: Level, case: Case) -> Iterator[Check]:
    """The checks of points and of the base points from which they have been found, then those of
    components.
    """
    pairs = tuple(_list_pairs(level, case))
    aslant = [pair for pair in pairs if _is_found_so(pair)]
    straight = [pair for pair in pairs if pair not in aslant]
    for pair in aslant:
        yield from list_component_checks(_turn(pair), level, case)
    for pair in straight:
        if not _is_new(pair, case) and not aslant:
            yield from _check_pair(pair, level, case)
    for pair in straight:
        yield from list_component_checks(_turn(pair), level, case)


def _turn(pair: _Pair) -> Turned:
    return Turned(pair.body, pair.points, pair.facts)


def _list_pairs(level: Level, case: Case) -> Iterator[_Pair]:
    """The pairs of points of each body, those found last first."""
    frames, facts = case.motion.frames, case.findings.facts
    for body in reversed(tuple(frames.bases)):
        turning = make_turning(body)
        if turning not in case.motion.rates or case.findings.spares(turning, level):
            continue
        found = {
            point: facts[key]
            for point in case.motion.points
            if is_lettered(point, case)
            and (key := make_key(frames.chain(body, point), level)) in facts
        }
        for first, second in reversed(tuple(combinations(found, 2))):
            yield _Pair(body, (first, second), (found[first], found[second]))


def _is_new(pair: _Pair, case: Case) -> bool:
    """Whether neither point is the body's base point, by which the other has been found."""
    return case.motion.frames.bases[pair.body].point not in pair.points


def _is_found_so(pair: _Pair) -> bool:
    """Whether the vector of one point has been found along and across the line of both."""
    return any(_lies_on(fact, {*pair.points}) for fact in pair.facts)


def _lies_on(fact: Fact, ends: set[str]) -> bool:
    """Whether a vector is known by components along a line and across it."""
    terms = [piece.term for piece in fact.pieces]
    return len(terms) > 1 and all(
        term is not None and {term.base, term.point} == ends for term in terms
    )


def _check_pair(pair: _Pair, level: Level, case: Case) -> Iterator[Check]:
    """The checks along and across the line of two points, each vector times that line, without
    those in which nothing is left of the second one's vector.
    """
    start, end = (case.motion.points[point] for point in pair.points)
    first, second = (
        name_owned_point(point, pair.body, fact.symbol, case)
        for point, fact in zip(pair.points, pair.facts, strict=True)
    )
    letters = "".join(map(case.naming.point, pair.points))
    arm = _Arm(pair.points, end - start, case)
    for way, across in (("along", False), ("across", True)):
        before, after = (arm.multiply(fact, across=across) for fact in pair.facts)
        line = arm.vector.turned() if across else arm.vector
        if before is None or not after or not double(line.dot(pair.facts[1].value)):
            continue
        turning = list(_list_turning(pair, arm, level, case, across=across))
        moved = [line.map(double).dot(fact.value.map(double)) for fact in pair.facts]
        check = compare(
            Message(f"solution.check-{way}-{level}", first=first, second=second, line=letters),
            _add(after, moved[1]),
            _add([*before, *turning], moved[0] + _measure_turning(pair, arm, level, across=across)),
            _UNITS[level],
            form=compare_points(pair.body, pair.points, pair.facts, line, case),
        )
        measured = turning or not all(fact.by_components for fact in pair.facts)
        ends = pair.points if measured else None
        yield replace(check, points=frozenset(pair.points), arm=ends)


@dataclass(frozen=True)
class _Arm:
    """From the first point to the second one."""

    ends: tuple[str, str]
    vector: Vector
    case: Case

    @property
    def length(self) -> Amount:
        """Its length."""
        far = measure(length(self.vector, self.case.arithmetic), "m")
        return Amount(name_length(*self.ends, self.case), far)

    def multiply(self, fact: Fact, *, across: bool) -> list[Amount] | None:
        """The product of a vector with the arm, with the arm turned by 90 degrees where `across`:
        by components, else its length times what lies along it; None where a part is slanting to
        it by no angle that is known.
        """
        if fact.by_components:
            return self._multiply_components(fact, across=across)
        line = self.vector.turned() if across else self.vector
        telling = (piece for piece in fact.parts if double(line.dot(piece.value)))
        products = [self._multiply_piece(line, piece) for piece in telling]
        found = [one for one in products if one is not None]
        return found if len(found) == len(products) else None

    def _multiply_piece(self, line: Vector, piece: Piece) -> Amount | None:
        letters = name_signed(piece, self.case)
        number = state_signed(piece, self.case, letters.sign)
        product = self.length.times(Amount(letters.size, number, letters.sign))
        if not double(line.cross(piece.value)):
            return product.signed(find_sign(line.dot(piece.positive)))
        heading = find_heading(piece, self.case)
        along = name_along(bearing(line), self.ends, self.case)
        known = along is not None and is_inclination_known(along, self.ends, self.case)
        cosine = find_cosine(heading, along) if heading and along and known else None
        if cosine is None or not is_line_found(cosine.value, self.case):
            return None
        return product.times(Amount(cosine.state(False), cosine.state(True), cosine.sign))

    def _multiply_components(self, fact: Fact, *, across: bool) -> list[Amount]:
        by = point_from(*self.ends, self.case)
        components = {
            axis: Amount(
                name_component(fact.symbol, axis),
                measure(fact.value[PLACES[axis]], fact.symbol.unit),
            )
            for axis in AXES
        }
        products = (by.turned() if across else by).dot(components)
        return [one for one in products if one.numbers != ZERO]


def _add(amounts: Sequence[Amount], value: float) -> Side:
    """A side in letters and in numbers."""
    return Side(add_numbers(amounts), value, add_letters(amounts) if amounts else None)


def _list_turning(
    pair: _Pair, arm: _Arm, level: Level, case: Case, *, across: bool
) -> Iterator[Amount]:
    """What the rotation about the first point adds: across the line the rate, along it, towards the
    first point, the square of the angular velocity, times the square of the distance.
    """
    square, omega = arm.length.squared(), case.motion.omega(pair.body)
    rate = case.rates(level)[make_turning(pair.body)]
    if across and double(rate):
        turning = measure(rate, UNITS[level, True])
        yield Amount(case.naming.turning(pair.body, level), turning).times(square)
    elif not across and level == "acceleration" and double(omega):
        turning = measure(omega, "rad/s")
        yield Amount(case.naming.omega(pair.body), turning).squared().times(square).signed(-1)


def _measure_turning(pair: _Pair, arm: _Arm, level: Level, *, across: bool) -> float:
    """What that amounts to."""
    case, far = arm.case, double(arm.vector.squared())
    if across:
        return double(case.rates(level)[make_turning(pair.body)]) * far
    match level:
        case "velocity":
            return 0.0  # a rotation adds nothing along the arm
        case "acceleration":
            return -(double(case.motion.omega(pair.body)) ** 2) * far
        case _:
            assert_never(level)
