"""Checks of trains that are driven at a rotational speed: by counting turns, without any angular
velocity.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from kinegrade.language.message import Message
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.laws import find_imposed_rotation, find_rims, find_rolling
from kinegrade.mechanics.shapes import Line
from kinegrade.numbers.number import Number
from kinegrade.worked.case import Case
from kinegrade.worked.checks.amounts import Amount
from kinegrade.worked.checks.check import Check, compare
from kinegrade.worked.checks.sides import Side
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.measures import double, length, size
from kinegrade.worked.formulas.numbers import measure
from kinegrade.worked.rates.driven import state_turned
from kinegrade.worked.rates.rims import state_radii
from kinegrade.worked.rates.rolled_motion import find_linked_term, state_rolled_radius
from kinegrade.worked.rates.speeds import name_speed
from kinegrade.worked.unlettered import is_lettered
from kinegrade.worked.vectors.facts import make_key
from kinegrade.worked.vectors.known_vectors import find_stated_sense
from kinegrade.worked.vectors.stage import measure_along_direction


def list_turn_checks(case: Case) -> Iterator[Check]:
    """The checks of what the last wheel of a train moves by its rim, and of points of that rim."""
    for relation in case.motion.frames.relations:
        law = find_imposed_rotation(relation.source)
        turned = state_turned(law, relation, case) if law else None
        if law is not None and turned is not None:
            train = tuple(_list_links(law.body, case))
            if train:
                counted = _Counted(Amount(*turned), abs(double(relation.velocity)), train)
                yield from _list_moved(counted, case)
                yield from _list_rim_points(counted, case)


@dataclass(frozen=True)
class _Link:
    """A wheel that drives another one, with the radii of both, in letters too."""

    driver: str
    driven: str
    radii: tuple[Number, Number]
    letters: tuple[Formula, Formula]


def _list_links(first: str, case: Case) -> Iterator[_Link]:
    """The pairs of wheels on carriers that do not turn, each from the one that was driven last."""
    rims = [find_rims(relation.source) for relation in case.motion.frames.relations]
    left = [one for one in rims if one is not None and _is_level(one.carrier, case)]
    last = first
    while True:
        found = next((one for one in left if last in (one.body, one.of)), None)
        if found is None:
            return
        left.remove(found)
        radii, letters = (found.circle.radius, found.on.radius), state_radii(found, case)
        if found.body == last:
            link = _Link(last, found.of, radii, letters)
        else:
            link = _Link(last, found.body, radii[::-1], letters[::-1])
        last = link.driven
        yield link


def _is_level(carrier: str, case: Case) -> bool:
    """Whether a carrier does not turn."""
    return carrier == GROUND or carrier in case.translating


@dataclass(frozen=True)
class _Counted:
    """What turns the first wheel of a train, 2 pi n, with its value, and the wheels after it."""

    turned: Amount
    value: float
    train: tuple[_Link, ...]

    @property
    def last(self) -> str:
        """The last wheel."""
        return self.train[-1].driven

    def follow(self, links: Sequence[_Link], radius: tuple[Formula, Number]) -> Side:
        """The speed of the rim of a radius, by the ratios of wheels."""
        letters, numbers, value = self.turned.letters, self.turned.numbers, self.value
        for link in links:
            over, under = (measure(one, "m") for one in link.radii)
            letters = letters * (link.letters[0] / link.letters[1])
            numbers = numbers.dot(over / under)
            value *= double(link.radii[0]) / double(link.radii[1])
        far = measure(radius[1], "m")
        return Side(numbers.dot(far), value * double(radius[1]), letters * radius[0])


def _list_moved(counted: _Counted, case: Case) -> Iterator[Check]:
    """The checks of a centre that rolls along a fixed track, or of what runs with the rim."""
    for relation in case.motion.frames.relations:
        roll = find_rolling(relation.source)
        if roll is not None and roll.body == counted.last and isinstance(roll.on, Line):
            term = find_linked_term(roll, relation, case)
            speed = measure_along_direction(term, case, "velocity")
            letters = name_speed(term, case, "velocity")
            radius = state_rolled_radius(roll, case), roll.circle.radius
            found = _Speed(letters, speed, find_stated_sense(term, case, "velocity"))
            side = counted.follow(counted.train, radius)
            yield _compare(found, side, _name_way(counted, counted.last, radius[0], case))


def _list_rim_points(counted: _Counted, case: Case) -> Iterator[Check]:
    """The checks of points of the rim about which the last belt runs."""
    *before, last = counted.train
    frames, centre = case.motion.frames, case.motion.frames.bases[counted.last].point
    for point, place in case.motion.points.items():
        fact = case.findings.facts.get(make_key(frames.chain(counted.last, point), "velocity"))
        far = size(place - case.motion.points[centre])
        if (
            not before
            or fact is None
            or not is_lettered(point, case)
            or double(far - double(last.radii[1]))
        ):
            continue
        side = counted.follow(before, (last.letters[0], last.radii[0]))
        way = _name_way(counted, last.driver, last.letters[0], case)
        found = _Speed(fact.symbol, length(fact.value, case.arithmetic), 1)
        yield _compare(found, side, way)


@dataclass(frozen=True)
class _Speed:
    """A speed that has been found: its letters, its value, and the sense in which it is stated."""

    letters: Formula
    value: Any
    sense: int


def _name_way(counted: _Counted, wheel: str, radius: Formula, case: Case) -> Message:
    """How a wheel's turns move the rim of a radius."""
    first, last = map(case.naming.body, (counted.train[0].driver, wheel))
    letters = case.text(radius)
    return Message("solution.counted-turns", first=first, last=last, radius=letters)


def _compare(found: _Speed, side: Side, way: Message) -> Check:
    """Both speeds by their sizes."""
    value = found.value * found.sense
    letters = abs(found.letters) if double(value) < 0 else found.letters
    speed = -value if double(value) < 0 else value
    return compare(way, Side(measure(speed, "m/s"), speed, letters), side, "m/s")
