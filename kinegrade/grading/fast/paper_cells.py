"""Papers by where their right answers to a few asks stand among those of all papers, so that for
thousands of rows it is seen at a glance that no paper has all their numbers.

Each of these asks parts the numbers into buckets, and a paper stands in the cells of all of them
that its intervals touch: one, as a rule. Few cells are taken, and a row looks into its own.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import prod

import numpy as np
from numpy.typing import NDArray

from kinegrade.exam.folder.columns.runs import list_runs
from kinegrade.grading.fast.bounds import Flags, Numbers, Places
from kinegrade.grading.fast.intervals import SAME, Intervals, rank_roughly

_TOGETHER = 4  # asks: papers stand in the cells of so many
_CELLS = 50  # for each paper: so few are taken
_MOST_BUCKETS = 64
_MOST_TOUCHED = 3  # buckets of an ask, by the widest interval
_RANKS = 2**16


@dataclass(frozen=True, slots=True)
class _Buckets:
    """The bucket of each rough rank that a number may have, so many of them, in its order."""

    of_rank: NDArray[np.uint8]
    count: int

    def find(self, numbers: Numbers) -> Places:
        """The buckets of numbers."""
        found: Places = self.of_rank[rank_roughly(numbers)].astype(np.intp)
        return found


@dataclass(frozen=True, slots=True)
class PaperCells:
    """The cells that are `taken`, and by ask its buckets."""

    buckets: dict[int, _Buckets]
    taken: Flags

    @classmethod
    def of(cls, asks: Mapping[int, Intervals]) -> PaperCells:
        """The papers with these intervals by asks, none of which has full turns or a paper that
        does not ask it.
        """
        papers = len(next(iter(asks.values())).value)
        most = round((_CELLS * papers) ** (1 / len(asks)))
        buckets: dict[int, _Buckets] = {}
        owners, cells = np.arange(papers), np.zeros(papers, dtype=np.intp)
        for ask, intervals in asks.items():
            each, first, counts = _divide(intervals, max(1, min(_MOST_BUCKETS, most, papers)))
            buckets[ask], first, counts = each, first[owners], counts[owners]
            owners, cells = np.repeat(owners, counts), np.repeat(cells * each.count, counts)
            cells += list_runs(first, counts)
        taken = np.zeros(prod(each.count for each in buckets.values()), dtype=np.bool_)
        taken[cells] = True
        return cls(buckets, taken)

    def may_have(self, numbers: Numbers) -> Flags:
        """False for the rows of numbers of which certainly no paper has all."""
        cells = np.zeros(len(numbers), dtype=np.intp)
        for ask, buckets in self.buckets.items():
            cells = cells * buckets.count + buckets.find(numbers[:, ask])
        blank: Flags = np.any(np.isnan(numbers[:, [*self.buckets]]), axis=1)
        return self.taken[cells] | blank


def list_cells(asks: Sequence[int], each: Sequence[Intervals]) -> list[PaperCells]:
    """The cells of these asks, as many together as tell papers apart; few rows are right on their
    own paper in all of them.
    """
    begins = range(0, len(asks) - _TOGETHER + 1, _TOGETHER)
    parts = (asks[begin : begin + _TOGETHER] for begin in begins)
    return [PaperCells.of({ask: each[ask] for ask in part}) for part in parts]


def _divide(intervals: Intervals, most: int) -> tuple[_Buckets, Places, Places]:
    """The buckets of an ask, with as many papers each as equal values allow, at most so many and so
    wide that no interval touches many; and which buckets each interval touches.
    """
    counted = np.cumsum(np.bincount(rank_roughly(intervals.value), minlength=_RANKS))
    before = np.append(0, counted[:-1])
    lowest = rank_roughly(intervals.low - 2 * SAME * np.abs(intervals.low))
    highest = rank_roughly(intervals.high + 2 * SAME * np.abs(intervals.high))
    for count in (most, *(2**power for power in range(most.bit_length() - 1, 0, -1)), 1):
        of_rank = (before * count // (counted[-1] + 1)).astype(np.uint8)
        first, last = of_rank[lowest].astype(np.intp), of_rank[highest].astype(np.intp)
        if (last - first).max(initial=0) < _MOST_TOUCHED:
            break
    return _Buckets(of_rank, count), first, last - first + 1
