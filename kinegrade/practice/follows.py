"""What follows for one ask from a student's value for another: a quadratic in that value, or the
root of one.

The plan is linear in each rate, and normal accelerations are quadratic in velocities, so that most
of what students carry on from is a quadratic; the magnitude of a vector that is linear in a rate is
the root of one. What is neither is said to be so.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import chain
from math import sqrt

from kinegrade.exam.setting.setting import SetQuestion
from kinegrade.mechanics.plan import Plan
from kinegrade.problem.template.template import Template
from kinegrade.sign_conventions import UNSIGNED
from kinegrade.students.following.connections import (
    find_connections,
    find_generic_plan,
    find_stages,
)
from kinegrade.students.following.followers import AnyFollower, make_follower
from kinegrade.students.mistaking.mistakes import convert_parameter

# Times the right answer: three values determine a quadratic, at the others it has to hold, as far
# as values are that students carry on from
_TRIED, _PROVED = (1.3, -0.7, 1.9), (0.6, 2.7, -1.6, 0.06, 40.0)
_OF_ITS_SIGN = (1.3, 0.7, 1.9), (0.6, 2.7, 1.6, 0.06, 40.0)  # where there are magnitudes on the way
_BESIDE = _TRIED[:2]  # a size and a sign that differ: either may change what follows
_SAME = 1e-8
_DIGITS = 9
_NEW = 1e-4  # of a value: nearer ones are not told apart
Points = Sequence[tuple[float, float]]
Coefficients = tuple[float, float, float]


@dataclass(frozen=True)
class FollowTable:
    """A question's asks, and which of them depend on which, in all draws."""

    template: Template
    asks: tuple[str, ...]

    @cached_property
    def stages(self) -> tuple[int, ...]:
        """For each ask the number of its stage: none depends on a later one."""
        number = {
            ask: place
            for place, stage in enumerate(find_stages(self.template, self.asks))
            for ask in stage
        }
        return tuple(number[ask] for ask in self.asks)

    @cached_property
    def plan(self) -> Plan | None:
        """The plan of all draws."""
        return find_generic_plan(self.template) if self.template.scheme.drivers else None

    @cached_property
    def pairs(self) -> tuple[tuple[str, str], ...]:
        """Each ask from which another follows, with that one."""
        found = find_connections(self.template, self.asks)
        return tuple((earlier, later) for later in found for earlier in found[later])

    def write(self, question: SetQuestion) -> tuple[str, ...]:
        """For each way of following in a draw the places of the two asks and the coefficients, none
        where nothing of the kind does; an "r" behind those of what is the root of a quadratic, a
        "+" where they hold for values of the right sign alone. Of what is unsigned they give the
        value but for its sign. Behind the first place and "&" is that of an ask with whose right
        answer something else follows, without coefficients.
        """
        follower = self._make_follower(question.drawn.values)
        fits = (
            _Fit(follower, earlier, later, self.template.asks[later].sign in UNSIGNED)
            for earlier, later in self.pairs
        )
        return tuple(chain.from_iterable(self._write_ways(fit) for fit in fits))

    def _write_ways(self, fit: _Fit) -> Iterator[str]:
        """The ways of following for one ask from another one."""
        start, end = map(self.asks.index, (fit.earlier, fit.later))
        for numbers in fit.list_ways():
            yield " ".join(map(str, (start, end, *numbers)))
        for other in fit.list_beside(self._list_others(fit)):
            yield f"{start}&{self.asks.index(other)} {end}"

    def _list_others(self, fit: _Fit) -> tuple[str, ...]:
        """The asks whose answers may have been taken together with the earlier one."""
        stage = dict(zip(self.asks, self.stages, strict=True))
        return tuple(
            ask
            for ask in self.asks
            if ask not in (fit.earlier, fit.later) and stage[ask] <= stage[fit.later]
        )

    def _make_follower(self, texts: Mapping[str, str]) -> AnyFollower:
        values = {
            name: convert_parameter(parameter, texts[name])
            for name, parameter in self.template.parameters.items()
        }
        return make_follower(self.template, values, self.plan)


@dataclass(frozen=True)
class _Fit:
    """What follows for the ask `later`, which may be `unsigned`, from values of an earlier one."""

    follower: AnyFollower
    earlier: str
    later: str
    unsigned: bool

    def list_beside(self, others: tuple[str, ...]) -> Iterator[str]:
        """The asks whose right answers make something else follow than the earlier one alone."""
        right, key = self.follower.right(self.earlier), self.follower.right(self.later)
        if not right or key is None:
            return
        wrong = tuple({self.earlier: right * share} for share in _BESIDE)
        for other in others:
            if any(self._matters(other, beside, key) for beside in wrong):
                yield other

    def _matters(self, other: str, wrong: Mapping[str, float], key: float) -> bool:
        """Whether the right answer to another ask, taken together with a wrong one, leads neither
        to the `key` nor to what follows from the wrong one alone.
        """
        known = key, *self.follower.consequences(wrong, self.later)
        both = {**wrong, other: self.follower.right(other) or 0.0}
        together = self.follower.consequences(both, self.later)
        return any(not _is_near(each, known) for each in together)

    def list_ways(self) -> tuple[tuple[str, ...], ...]:
        """The coefficients of each way of going on, with a "+" where they hold for values of the
        right sign alone; an empty one where there are none.
        """
        for tried in (_TRIED, _OF_ITS_SIGN[0]):  # the second for magnitudes of what changes sign
            everywhere = tuple(self._find(tried, _PROVED))
            if all(everywhere):
                return everywhere
        fitted = self._find(*_OF_ITS_SIGN)
        return tuple(dict.fromkeys((*numbers, "+") if numbers else () for numbers in fitted))

    def _find(self, *shares: tuple[float, ...]) -> Iterator[tuple[str, ...]]:
        """The coefficients of each way, found and proved at shares of the right answer."""
        right = self.follower.right(self.earlier)
        if not right:
            return
        tried, proved = ([self._follow(right * share) for share in each] for each in shares)
        count = len(tried[0][1])
        if any(len(ways) != count for _, ways in (*tried, *proved)):
            yield ()
            return
        for way in range(count):
            known = [(value, ways[way]) for value, ways in tried]
            others = [(value, ways[way]) for value, ways in proved]
            yield self._fit_quadratic(known, others) or _fit_root(known, others)

    def _follow(self, value: float) -> tuple[float, Sequence[float]]:
        return value, self.follower.consequences({self.earlier: value}, self.later)

    def _fit_quadratic(self, tried: Points, proved: Points) -> tuple[str, ...]:
        """The coefficients of the quadratic through the tried points, if it has the others too."""
        coefficients = _interpolate(tried)
        holds = all(self._holds(coefficients, value, follows) for value, follows in proved)
        return _write_numbers(coefficients) if holds else ()

    def _holds(self, coefficients: Coefficients, value: float, follows: float) -> bool:
        constant, linear, square = coefficients
        terms = (constant, linear * value, square * value**2)
        found = abs(sum(terms)) if self.unsigned else sum(terms)
        return abs(found - follows) <= _SAME * max(map(abs, terms))


def _fit_root(tried: Points, proved: Points) -> tuple[str, ...]:
    """The coefficients, and an "r", of the quadratic through the squares at the tried points, if
    its root has the others too.
    """
    squares = [(value, follows**2) for value, follows in tried]
    coefficients = constant, linear, square = _interpolate(squares)
    for value, follows in (*tried, *proved):
        terms = (constant, linear * value, square * value**2)
        room = _SAME * sqrt(max(map(abs, terms)))
        if abs(sqrt(max(sum(terms), 0.0)) - follows) > room:
            return ()
    return *_write_numbers(coefficients), "r"


def _write_numbers(coefficients: Coefficients) -> tuple[str, ...]:
    return tuple(f"{each:.{_DIGITS}g}" for each in coefficients)


def _is_near(value: float, others: Sequence[float]) -> bool:
    """Whether a value cannot be told from one of others."""
    return any(abs(value - other) <= _NEW * max(abs(value), abs(other)) for other in others)


def _interpolate(points: Points) -> Coefficients:
    """The quadratic through three points."""
    (x1, y1), (x2, y2), (x3, y3) = points
    first, second = (y2 - y1) / (x2 - x1), (y3 - y2) / (x3 - x2)
    square = (second - first) / (x3 - x1)
    linear = first - square * (x1 + x2)
    size = max(abs(y1), abs(y2), abs(y3))
    terms = (y1 - linear * x1 - square * x1**2, linear, square)
    reach = (1.0, abs(x1), x1**2)
    kept = [
        term if abs(term) * far > _SAME * size else 0.0
        for term, far in zip(terms, reach, strict=True)
    ]
    return kept[0], kept[1], kept[2]
