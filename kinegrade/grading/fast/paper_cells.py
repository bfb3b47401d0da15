"""Papers by where their right answers to a few asks stand among those of all papers, so that for
thousands of rows it is seen at a glance that no paper has all their numbers.

Each of these asks parts the papers into so many buckets, and a paper stands in one cell of all of
them. Few cells are taken, and a row looks into the few in which a paper with its numbers would be.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from kinegrade.exam.folder.columns.runs import list_runs
from kinegrade.grading.fast.bounds import Flags, Numbers, Places
from kinegrade.grading.fast.intervals import SAME, Intervals, SortedIntervals, rank_roughly

_TOGETHER = 4  # asks: papers stand in one cell of so many
_CELLS = 50  # for each paper: so few are taken
_MOST_BUCKETS = 64
_MOST_LOOKED = 4  # buckets of an ask; a row that has to look into more cannot be told


class _Buckets(NamedTuple):
    """The highest ends up to each bucket, and the lowest beginnings from each on."""

    up_to: Numbers
    from_on: Numbers


@dataclass(frozen=True, slots=True)
class PaperCells:
    """The cells that are `taken`, and by ask its buckets, so many of each."""

    buckets: dict[int, _Buckets]
    count: int
    taken: Flags

    @classmethod
    def of(cls, asks: Mapping[int, tuple[Numbers, SortedIntervals]]) -> PaperCells:
        """The papers with these values and their intervals by asks, none of which has full turns or
        a paper that does not ask it.
        """
        papers = len(next(iter(asks.values()))[0])
        most = round((_CELLS * papers) ** (1 / len(asks)))
        count = max(1, min(_MOST_BUCKETS, most, papers))
        buckets: dict[int, _Buckets] = {}
        cells = np.zeros(papers, dtype=np.intp)
        for ask, (values, order) in asks.items():
            buckets[ask], stands = _divide(values[order.papers], order, count)
            cells = cells * count + stands
        taken = np.zeros(count ** len(asks), dtype=np.bool_)
        taken[cells] = True
        return cls(buckets, count, taken)

    def may_have(self, numbers: Numbers) -> Flags:
        """False for the rows of numbers of which certainly no paper has all."""
        open_to: Flags = np.any(np.isnan(numbers[:, [*self.buckets]]), axis=1)
        rows = np.flatnonzero(~open_to)
        cells = np.zeros(len(rows), dtype=np.intp)
        for ask, buckets in self.buckets.items():
            first, counts = _find_band(buckets, numbers[rows, ask])
            open_to[rows[counts > _MOST_LOOKED]] = True
            counts[counts > _MOST_LOOKED] = 0
            rows, cells = np.repeat(rows, counts), np.repeat(cells * self.count, counts)
            cells += list_runs(first, counts)
        open_to[rows[self.taken[cells]]] = True
        return open_to


def list_cells(
    asks: Sequence[int], each: Sequence[Intervals], orders: Sequence[SortedIntervals]
) -> list[PaperCells]:
    """The cells of these asks, as many together as tell papers apart; few rows are right on their
    own paper in all of them.
    """
    begins = range(0, len(asks) - _TOGETHER + 1, _TOGETHER)
    parts = (asks[begin : begin + _TOGETHER] for begin in begins)
    return [PaperCells.of({ask: (each[ask].value, orders[ask]) for ask in part}) for part in parts]


def _divide(values: Numbers, order: SortedIntervals, count: int) -> tuple[_Buckets, Places]:
    """The buckets of an ask, with as many papers as equal values allow, and that of each paper."""
    ranks = rank_roughly(values)
    begins_run = np.append(True, ranks[1:] != ranks[:-1])
    first = np.maximum.accumulate(np.where(begins_run, np.arange(len(begins_run)), 0))
    bucket = first * count // len(first)
    stands = np.empty(len(bucket), dtype=np.intp)
    stands[order.papers] = bucket
    ends = np.searchsorted(bucket, np.arange(count), side="right") - 1
    begins = np.searchsorted(bucket, np.arange(count), side="left")
    up_to, from_on = np.append(-np.inf, order.up_to), np.append(order.from_on, np.inf)
    return _Buckets(up_to[ends + 1], from_on[begins]), stands


def _find_band(buckets: _Buckets, answers: Numbers) -> tuple[Places, Places]:
    """The first bucket with papers on which each answer may be right, and how many follow it."""
    slack = SAME * np.abs(answers)
    first = np.searchsorted(buckets.up_to, answers - slack, side="left")
    last = np.searchsorted(buckets.from_on, answers + slack, side="right")
    return first, np.maximum(last - first, 0)
