"""What a class's points say about the asks: how hard each was, and whether it separates good papers
from weak ones.

Arrays have a row for each student and a column for each ask, NaN where a paper does not ask it. A
figure for which there are too few
students is None.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import atanh, sqrt, tanh

import numpy as np
import numpy.typing as npt

from kinegrade.press.class_charts import Histogram, Summary

Points = npt.NDArray[np.float64]
_FEWEST = 3  # students: a correlation of two is always 1 or -1
_Z95 = 1.96  # standard deviations on either side that hold 95 % of a normal distribution
_CERTAIN = 1 - 1e-9  # a correlation that counts as 1
_FINE, _COARSE = 10, 20  # per cent: the width of a bin of the histogram
_FEW = 25  # students: smaller classes get coarse bins


def summarise(values: Sequence[float] | Points) -> Summary | None:
    """The summary of at least one value.

    >>> summarise([1, 2, 4]).median
    2.0
    """
    if not len(values):
        return None
    array = np.asarray(values, dtype=np.float64)
    lower, median, upper = map(float, np.quantile(array, (0.25, 0.5, 0.75)))
    sd = float(array.std(ddof=1)) if len(array) > 1 else None
    return Summary(
        len(array),
        float(array.mean()),
        sd,
        float(array.min()),
        lower,
        median,
        upper,
        float(array.max()),
    )


def make_histogram(percents: Sequence[float] | Points) -> Histogram:
    """Percentages from 0 to 100 in bins of ten, or of twenty for few values; anything above 100
    counts as 100.

    >>> make_histogram([0, 20, 39.9, 100]).counts
    (1, 2, 0, 0, 1)
    """
    width = _COARSE if len(percents) < _FEW else _FINE
    edges = np.arange(0, 100 + width, width)
    counts, _ = np.histogram(np.clip(np.round(percents, 6), 0, 100), edges)
    return Histogram(tuple(map(float, edges)), tuple(map(int, counts)))


def find_facilities(points: Points, out_of: Points) -> tuple[float | None, ...]:
    """For each ask the mean share of its points; None where no student or no point counts."""
    asked = [column[~np.isnan(column)] for column in points.T]
    return tuple(
        float(each.mean()) / most if most and len(each) else None
        for each, most in zip(asked, out_of.tolist(), strict=True)
    )


def find_discriminations(points: Points, out_of: Points) -> tuple[float | None, ...]:
    """For each ask the correlation (Pearson) of its points with the share of those of all other
    asks, as papers may ask different ones.

    None for fewer than three students, or if all have the same points for the ask or for the
    others.
    """
    asked = ~np.isnan(points)
    totals, maxima = np.nansum(points, axis=1), asked @ out_of
    return tuple(
        _discriminate(column, totals - column, maxima - most)
        for column, most in zip(points.T, out_of.tolist(), strict=True)
    )


def _discriminate(column: Points, others: Points, maxima: Points) -> float | None:
    """The correlation for one ask with the others, which are out of `maxima`, of the students who
    were asked it and something else.
    """
    known = ~np.isnan(column) & (maxima > 0)
    if known.sum() < _FEWEST:
        return None
    return correlate(column[known], others[known] / maxima[known])


def correlate(first: Points, second: Points) -> float | None:
    """Pearson's coefficient; None if either of the two does not vary."""
    one, other = first - first.mean(), second - second.mean()
    scale = float(np.sqrt((one**2).sum() * (other**2).sum()))
    smallest = (
        1e-9 * float(np.abs(first).max(initial=0) * np.abs(second).max(initial=0)) * len(first)
    )
    return float((one * other).sum() / scale) if scale > smallest else None


def find_interval(correlation: float, students: int) -> tuple[float, float] | None:
    """Between what values a correlation lies with 95 % confidence, by Fisher's z; None for too few
    students.

    >>> [round(end, 2) for end in find_interval(0.1, 60) or ()]
    [-0.16, 0.35]
    """
    if students <= _FEWEST:
        return None
    middle = atanh(min(max(correlation, -_CERTAIN), _CERTAIN))
    reach = _Z95 / sqrt(students - _FEWEST)
    return tanh(middle - reach), tanh(middle + reach)


def find_reliability(points: Points) -> float | None:
    """Cronbach's alpha: how much of the totals' variance the asks share; None for too few students
    or asks. No student lacks any.
    """
    students, asks = points.shape
    if students < _FEWEST or asks < 2:
        return None
    totals = points.sum(axis=1)
    if np.ptp(totals) <= 1e-9 * float(np.abs(totals).max()):
        return None
    parts = float(points.var(axis=0, ddof=1).sum())
    whole = float(totals.var(ddof=1))
    return float(asks / (asks - 1) * (1 - parts / whole))
