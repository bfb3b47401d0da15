"""Checks of wheels about fixed axes: a train of several is one step from its first wheel to its
last.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import reduce

from kinegrade.language.message import Message
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.laws import find_rims
from kinegrade.mechanics.rates import make_turning
from kinegrade.mechanics.vector_equation import Level
from kinegrade.numbers.number import Number
from kinegrade.worked.case import Case
from kinegrade.worked.checks.check import Check, compare
from kinegrade.worked.checks.sides import Side
from kinegrade.worked.findings import Form
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.measures import double
from kinegrade.worked.formulas.numbers import measure
from kinegrade.worked.rates.rims import state_radii
from kinegrade.worked.rates.speeds import name_rotation
from kinegrade.worked.vectors.vectors import UNITS


def list_train_checks(level: Level, case: Case) -> Iterator[Check]:
    """The check of a train of three wheels or more, unless nothing turns at this level."""
    links = tuple(_list_links(case))
    train = _find_train(links)
    if len(train) > 1 and double(case.rates(level)[make_turning(train[-1].driven)]):
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
    """The pairs of wheels about fixed axes of which one drives the other."""
    for relation in case.motion.frames.relations:
        rims = find_rims(relation.source)
        if rims is not None and rims.carrier == GROUND:
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


def _check_train(train: Sequence[_Link], level: Level, case: Case) -> Check:
    """The rotation of the last wheel by that of the first and all radii."""
    ends, unit = (train[0].driver, train[-1].driven), UNITS[level, True]
    start, end = (case.rates(level)[make_turning(body)] for body in ends)
    first, last = map(case.naming.body, ends)
    lengths = zip(*((measure(one, "m") for one in link.radii) for link in train), strict=True)
    above, below = (reduce(Formula.dot, side) for side in lengths)
    ratio: Number = 1
    for link in train:
        ratio = ratio * link.radii[0] / link.radii[1] * link.sense
    sense = 1 if double(ratio) > 0 else -1
    numbers = (above / below).dot(measure(start, unit)).signed(sense)
    over, under = (
        reduce(Formula.__mul__, side)
        for side in zip(*(link.letters for link in train), strict=True)
    )
    turned = [name_rotation(body, case, level) for body in ends]
    letters = (over / under * turned[0]).signed(sense)
    form: Form = {make_turning(ends[1]): 1.0, make_turning(ends[0]): -double(ratio)}
    way = Message(f"solution.train-{level}", first=first, last=last)
    return compare(
        way,
        Side(measure(end, unit), end, turned[1]),
        Side(numbers, ratio * start, letters),
        unit,
        form=form,
    )
