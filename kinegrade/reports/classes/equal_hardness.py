"""Whether papers were equally hard: versions compared with each other, drawn numbers compared with
points.

Two rank tests, with p-values from permutations that are always the same. They assume nothing about
the distribution, and the same marks give the same report. `PCG64` promises a stable stream; a
permutation is the sorting order of its numbers.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from kinegrade.reports.classes.item_statistics import Points, correlate

_MOST_PERMUTATIONS, _FEWEST_PERMUTATIONS = 9999, 199
# Most numbers to shuffle: a class of 60 gets 9,999 permutations, one of 100,000 only 199
_WORK = 10_000_000
SIGNIFICANT = 0.05
ENOUGH = 30  # students: with fewer, nothing can be said
_AT_ONCE = 1_000_000  # numbers in memory
_SEED = 20_260_501

_Orders = npt.NDArray[np.intp]  # one permutation per row


@dataclass(frozen=True)
class Test:
    """`p` is the share of `permutations` shuffles of the students in which chance alone does at
    least as much.
    """

    statistic: float
    p: float
    permutations: int


@dataclass(frozen=True)
class Third:
    """The students with the lowest, middle or highest numbers: the range of their numbers and their
    mean share of points.
    """

    lowest: float
    highest: float
    count: int
    share: float


@dataclass(frozen=True)
class ParameterTrend:
    """How the share of a question's points varies with a number drawn for it; `adjusted` is p by
    Holm's method.
    """

    question: str
    parameter: str
    correlation: float
    test: Test
    adjusted: float
    thirds: tuple[Third, ...]


@dataclass(frozen=True)
class _Claim:
    """A statistic that was observed; `reaches` says for each order whether it gives at least as
    much.
    """

    observed: float
    reaches: Callable[[_Orders], Any]


@dataclass(frozen=True)
class _Suspicion:
    """A drawn number of a question that `count` students have, with which points may vary."""

    question: str
    name: str
    count: int
    claim: _Claim
    thirds: tuple[Third, ...]


def rank_values(values: Points) -> Points:
    """Ranks from 1; equal values share the mean of their ranks.

    >>> rank_values(np.array([7.0, 5.0, 7.0])).tolist()
    [2.5, 1.0, 2.5]
    """
    _, place, counts = np.unique(values, return_inverse=True, return_counts=True)
    highest = np.cumsum(counts)
    means: Points = highest - (counts - 1) / 2
    return means[place]


def compare_groups(values: Points, groups: Sequence[str]) -> Test | None:
    """Whether groups differ in location: H with its correction for ties. None for a single group,
    or if all values are equal.
    """
    names, place = np.unique(np.asarray(groups), return_inverse=True)
    count = len(values)
    if len(names) < 2 or count < 3 or np.ptp(values) == 0:
        return None
    ranked, members = (
        rank_values(values),
        np.equal.outer(place, np.arange(len(names))).astype(np.float64),
    )
    _, ties = np.unique(values, return_counts=True)
    tied = 1 - float((ties.astype(float) ** 3 - ties).sum()) / (count**3 - count)
    scale, shift = 12 / (count * (count + 1)) / tied, 3 * (count + 1) / tied

    def statistic(order: Points) -> Points:
        """H for each row of ranks."""
        heights: Points = (
            scale * ((order @ members) ** 2 / members.sum(axis=0)).sum(axis=-1) - shift
        )
        return heights

    observed = float(statistic(ranked))
    claim = _Claim(observed, lambda orders: statistic(ranked[orders]) >= observed - 1e-9)
    (test,) = _test(count, [claim])
    return test


def _claim_correlation(first: Points, second: Points) -> _Claim | None:
    """Rank correlation, to be tested two-sided; None if either of the two does not vary."""
    one, other = rank_values(first), rank_values(second)
    observed = correlate(one, other)
    if observed is None:
        return None
    one, other = one - one.mean(), other - other.mean()
    reached = abs(float(one @ other)) - 1e-9
    return _Claim(observed, lambda orders: np.abs(one[orders] @ other) >= reached)


def find_parameter_trends(
    parameters: Mapping[tuple[str, str], Points], shares: Mapping[str, Points]
) -> tuple[ParameterTrend, ...]:
    """The trend of each drawn number that varies, the clearest first; NaN stands for a student
    without that number.
    """
    suspected = [
        suspicion
        for (question, name), numbers in parameters.items()
        if (suspicion := _suspect(question, name, numbers, shares[question])) is not None
    ]
    found = list(zip(suspected, _test_together(suspected), strict=True))
    found.sort(key=lambda pair: (pair[1].p, -abs(pair[1].statistic)))
    adjusted = adjust_p_values([test.p for _, test in found])
    return tuple(
        ParameterTrend(each.question, each.name, test.statistic, test, p, each.thirds)
        for (each, test), p in zip(found, adjusted, strict=True)
    )


def _suspect(question: str, name: str, numbers: Points, shares: Points) -> _Suspicion | None:
    """A drawn number against the shares of those who have it; None where it does not vary, or fewer
    than three have it.
    """
    known = np.isfinite(numbers) & np.isfinite(shares)
    numbers, shares = numbers[known], shares[known]
    claim = _claim_correlation(numbers, shares) if len(numbers) >= 3 else None
    if claim is None:
        return None
    return _Suspicion(question, name, len(numbers), claim, split_in_thirds(numbers, shares))


def _test_together(suspected: Sequence[_Suspicion]) -> list[Test]:
    """A test for each; those of equally many students share their shuffles."""
    tests: dict[int, Test] = {}
    for count in {each.count for each in suspected}:
        places = [place for place, each in enumerate(suspected) if each.count == count]
        claims = [suspected[place].claim for place in places]
        tests.update(zip(places, _test(count, claims), strict=True))
    return [tests[place] for place in range(len(suspected))]


def split_in_thirds(numbers: Points, shares: Points) -> tuple[Third, ...]:
    """Students in up to three groups by a drawn number, equal numbers in one group; shares are
    means.
    """
    lower, upper = np.quantile(numbers, (1 / 3, 2 / 3))
    masks = (numbers <= lower, (numbers > lower) & (numbers <= upper), numbers > upper)
    return tuple(
        Third(
            float(numbers[mask].min()),
            float(numbers[mask].max()),
            int(mask.sum()),
            float(shares[mask].mean()),
        )
        for mask in masks
        if mask.any()
    )


def adjust_p_values(ascending: Sequence[float]) -> tuple[float, ...]:
    """p-values, given in ascending order, adjusted for their number.

    >>> adjust_p_values([0.01, 0.02, 0.5])
    (0.03, 0.04, 0.5)
    """
    adjusted, highest = [], 0.0
    for place, p in enumerate(ascending):
        highest = max(highest, min(1.0, p * (len(ascending) - place)))
        adjusted.append(highest)
    return tuple(adjusted)


def _test(count: int, claims: Sequence[_Claim]) -> list[Test]:
    """The tests of statistics for `count` students, by the same shuffles."""
    permutations = min(_MOST_PERMUTATIONS, max(_FEWEST_PERMUTATIONS, _WORK // count))
    as_much = [0] * len(claims)
    for orders in _shuffle(count, permutations):
        for place, claim in enumerate(claims):
            as_much[place] += int(np.count_nonzero(claim.reaches(orders)))
    return [
        Test(claim.observed, (1 + reached) / (1 + permutations), permutations)
        for claim, reached in zip(claims, as_much, strict=True)
    ]


def _shuffle(count: int, permutations: int) -> Iterator[_Orders]:
    """The same shuffles at every call, as many at once as memory should hold."""
    generator = np.random.PCG64(_SEED)
    at_once = max(1, _AT_ONCE // count)
    for start in range(0, permutations, at_once):
        rows = min(at_once, permutations - start)
        drawn = generator.random_raw(rows * count).reshape(rows, count)
        yield np.argsort(drawn, axis=1, kind="stable")
