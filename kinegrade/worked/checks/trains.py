"""Checks of wheels about axes that do not turn: a train of several is one step from its first wheel
to its last, or to what the rim of that moves.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence, Set
from dataclasses import dataclass
from functools import reduce

from kinegrade.language.message import Message
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.laws import NoSlip, find_rims, find_rolling
from kinegrade.mechanics.rates import Rate, make_turning
from kinegrade.mechanics.relations import Relation
from kinegrade.mechanics.vector_equation import Level
from kinegrade.numbers.number import Number
from kinegrade.worked.case import Case
from kinegrade.worked.checks.check import Check, compare
from kinegrade.worked.checks.forms import state_form
from kinegrade.worked.checks.sides import Side
from kinegrade.worked.findings import Form
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.measures import double
from kinegrade.worked.formulas.numbers import measure
from kinegrade.worked.rates.rims import state_radii
from kinegrade.worked.rates.rolling import find_linked_term, find_slip_sign, state_rolled_radius
from kinegrade.worked.rates.speeds import name_rotation, name_speed
from kinegrade.worked.vectors.known_vectors import find_stated_sense
from kinegrade.worked.vectors.stage import measure_along_direction
from kinegrade.worked.vectors.vectors import UNITS


def list_train_checks(found: Set[Rate], level: Level, case: Case) -> Iterator[Check]:
    """The checks of a train of three wheels or more, or of two of which the last one rolls or moves
    a track, as far as its rates have been found; none where nothing turns at this level.
    """
    links = tuple(_list_links(case))
    train = _find_train(links)
    if not train or not double(case.rates(level)[make_turning(train[-1].driven)]):
        return
    for rim in _list_rims(train[-1].driven, case):
        if find_linked_term(rim.roll, rim.relation, case).rate in found:
            yield _check_speed(train, rim, level, case)
    if len(train) > 1 and make_turning(train[-1].driven) in found:
        yield _check_train(train, level, case)


@dataclass(frozen=True)
class _Link:
    """A wheel that drives another one, with the radii of both; `sense` is -1 where they turn in
    opposite senses.
    """

    driver: str
    driven: str
    radii: tuple[Number, Number]
    letters: tuple[Formula, Formula]
    sense: int


def _list_links(case: Case) -> Iterator[_Link]:
    """The pairs of wheels about axes that do not turn of which one drives the other."""
    for relation in case.motion.frames.relations:
        rims = find_rims(relation.source)
        if rims is not None and _is_steady(rims.carrier, case):
            radii, sense = (rims.circle.radius, rims.on.radius), -1 if rims.is_opposite else 1
            yield _Link(rims.body, rims.of, radii, state_radii(rims, case), sense)


def _find_train(links: Sequence[_Link]) -> tuple[_Link, ...]:
    """The first links that follow one another, each from the wheel that the one before drives."""
    train = list(links[:1])
    for link in links[1:]:
        if link.driver != train[-1].driven:
            break
        train.append(link)
    return tuple(train)


def _is_steady(body: str, case: Case) -> bool:
    """Whether a body does not turn."""
    return body == GROUND or body in case.translating


@dataclass(frozen=True)
class _Rim:
    """A rim of a wheel without slip on a track that does not turn."""

    roll: NoSlip
    relation: Relation


def _list_rims(body: str, case: Case) -> Iterator[_Rim]:
    for relation in case.motion.frames.relations:
        roll = find_rolling(relation.source)
        if roll is not None and roll.body == body and _is_steady(roll.of, case):
            yield _Rim(roll, relation)


@dataclass(frozen=True)
class _Ratio:
    """How often the last wheel of a train turns while the first one turns once; in letters and in
    numbers without its sign.
    """

    value: Number
    letters: tuple[Formula, Formula]
    numbers: tuple[Formula, Formula]

    @staticmethod
    def of(train: Sequence[_Link]) -> _Ratio:
        """The ratio of a train by its radii."""
        value: Number = 1
        for link in train:
            value = value * link.radii[0] / link.radii[1] * link.sense
        lengths = zip(*((measure(one, "m") for one in link.radii) for link in train), strict=True)
        above, below = (reduce(Formula.dot, side) for side in lengths)
        over, under = (
            reduce(Formula.__mul__, side)
            for side in zip(*(link.letters for link in train), strict=True)
        )
        return _Ratio(value, (over, under), (above, below))

    @property
    def sense(self) -> int:
        """-1 where first and last wheel turn in opposite senses, else 1."""
        return 1 if double(self.value) > 0 else -1


def _check_speed(train: Sequence[_Link], rim: _Rim, level: Level, case: Case) -> Check:
    """The speed that goes with the last wheel's rotation by that of the first and all radii."""
    roll, first, ratio = rim.roll, make_turning(train[0].driver), _Ratio.of(train)
    term = find_linked_term(roll, rim.relation, case)
    start, unit = case.rates(level)[first], UNITS[level, False]
    sign = find_slip_sign(roll, rim.relation, case, level)
    sense = sign * ratio.sense
    (over, under), (above, below) = ratio.letters, ratio.numbers
    radius = measure(roll.circle.radius, "m")
    letters = state_rolled_radius(roll, case) * over / under
    turning = name_rotation(train[0].driver, case, level)
    numbers = (radius.dot(above) / below).dot(measure(start, UNITS[level, True]))
    symbol = name_speed(term, case, level)
    found = measure_along_direction(term, case, level) * find_stated_sense(term, case, level)
    found = found * symbol.sign
    moved = state_form(rim.relation)
    turned = moved[make_turning(roll.body)]
    slid = {rate: one for rate, one in moved.items() if rate.kind == "sliding"}
    body, point = case.naming.body(train[0].driver), case.naming.point(term.point)
    return compare(
        Message("solution.speed-in-one-step", first=body, point=point),
        Side(measure(found, unit), found, symbol.size),
        Side(
            numbers.signed(sense * symbol.sign),
            ratio.value * roll.circle.radius * start * sign * symbol.sign,
            (letters * turning).signed(sense * symbol.sign),
        ),
        unit,
        form={**slid, first: turned * double(ratio.value)},
    )


def _check_train(train: Sequence[_Link], level: Level, case: Case) -> Check:
    """The rotation of the last wheel by that of the first and all radii."""
    ends, unit = (train[0].driver, train[-1].driven), UNITS[level, True]
    start, end = (case.rates(level)[make_turning(body)] for body in ends)
    first, last = map(case.naming.body, ends)
    ratio = _Ratio.of(train)
    (over, under), (above, below) = ratio.letters, ratio.numbers
    numbers = (above / below).dot(measure(start, unit)).signed(ratio.sense)
    turned = [name_rotation(body, case, level) for body in ends]
    letters = (over / under * turned[0]).signed(ratio.sense)
    form: Form = {make_turning(ends[1]): 1.0, make_turning(ends[0]): -double(ratio.value)}
    way = Message(f"solution.train-{level}", first=first, last=last)
    return compare(
        way,
        Side(measure(end, unit), end, turned[1]),
        Side(numbers, ratio.value * start, letters),
        unit,
        form=form,
    )
