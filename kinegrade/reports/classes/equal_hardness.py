"""Whether papers were equally hard: versions compared with each other, drawn numbers compared with
points.

Two rank tests, with p-values from permutations that are always the same. They assume nothing about
the distribution, and the same marks give the same report. `PCG64` promises a stable stream; a
permutation is the sorting order of its numbers.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
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
    return _test(observed, count, lambda orders: statistic(ranked[orders]) >= observed - 1e-9)


def correlate_ranks(first: Points, second: Points) -> Test | None:
    """Rank correlation, tested two-sided; None if either of the two does not vary."""
    one, other = rank_values(first), rank_values(second)
    observed = correlate(one, other)
    if observed is None:
        return None
    one, other = one - one.mean(), other - other.mean()
    reached = abs(float(one @ other)) - 1e-9
    return _test(observed, len(one), lambda orders: np.abs(one[orders] @ other) >= reached)


def find_parameter_trends(
    parameters: Mapping[tuple[str, str], Points], shares: Mapping[str, Points]
) -> tuple[ParameterTrend, ...]:
    """The trend of each drawn number that varies, the clearest first; NaN stands for a student
    without that number.
    """
    found = []
    for (question, name), numbers in parameters.items():
        known = np.isfinite(numbers) & np.isfinite(shares[question])
        test = (
            correlate_ranks(numbers[known], shares[question][known]) if known.sum() >= 3 else None
        )
        if test is not None:
            found.append(
                (question, name, test, split_in_thirds(numbers[known], shares[question][known]))
            )
    found.sort(key=lambda trend: (trend[2].p, -abs(trend[2].statistic)))
    adjusted = adjust_p_values([test.p for _, _, test, _ in found])
    return tuple(
        ParameterTrend(question, name, test.statistic, test, p, groups)
        for (question, name, test, groups), p in zip(found, adjusted, strict=True)
    )


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


def _test(observed: float, count: int, reaches: Callable[[_Orders], Any]) -> Test:
    """The test of a statistic for `count` students; `reaches` says for each order whether it gives
    at least as much.
    """
    permutations = min(_MOST_PERMUTATIONS, max(_FEWEST_PERMUTATIONS, _WORK // count))
    generator = np.random.PCG64(_SEED)
    at_once = max(1, _AT_ONCE // count)
    as_much = 0
    for start in range(0, permutations, at_once):
        rows = min(at_once, permutations - start)
        orders = np.argsort(
            generator.random_raw(rows * count).reshape(rows, count), axis=1, kind="stable"
        )
        as_much += int(np.count_nonzero(reaches(orders)))
    return Test(observed, (1 + as_much) / (1 + permutations), permutations)
