"""Papers alike hard: who gets which of the combinations that are dealt of each question, so that
the sums of their difficulties differ little from paper to paper.

What differs by less than rounding counts as equal, so that a deal is the same on every machine.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

_SWEEPS = 20  # over all questions; a class needs two to six
_EQUAL = 1e-9  # points, or squared points: what differs by less is equal


@dataclass(frozen=True)
class Candidates:
    """A question's combinations: the difficulty of what each paper has, paper by paper, then of
    those to spare, in points. `free` are the numbers of the papers that may get another one.
    """

    predicted: Any
    free: Any


def order_by_use(used: Sequence[int], count: int) -> tuple[list[int], list[int]]:
    """The combinations that so many papers get, by their numbers in the order of the deck, and
    those to spare; `used` says how often each has been dealt already.

    None is dealt again while there are others; where some are, there are none to spare.

    >>> order_by_use([0, 1, 0], 1)
    ([0], [2])
    >>> order_by_use([0, 1, 0], 4)
    ([0, 2, 0, 1], [])
    """
    fresh = [number for number, times in enumerate(used) if not times]
    if len(fresh) >= count:
        return fresh[:count], fresh[count:]
    copies = range(count // len(used) + 1)
    ranked = sorted((times + copy, n) for n, times in enumerate(used) for copy in copies)
    return [number for _, number in ranked[:count]], []


def make_alike(questions: Sequence[Candidates], papers: int) -> tuple[list[Any], Any]:
    """For each question the numbers of the candidates that the papers get, and the papers' sums, in
    points.

    Question by question, the hardest combination goes to the paper that is easiest without it, the
    next hardest to the next (the rearrangement algorithm: G. Puccetti, L. Rueschendorf, J. Comput.
    Appl. Math. 236, 2012); then papers far from the middle get one to spare that brings them
    closer. Until nothing comes closer.
    """
    orders = [np.arange(len(each.predicted)) for each in questions]
    dealt = [pair for pair in zip(questions, orders, strict=True) if pair[0].free.size]
    widest_first = sorted(dealt, key=_negative_range)
    sums = np.sum([each.predicted[:papers] for each in questions], axis=0)
    left = np.inf
    for _ in range(_SWEEPS):
        middle = np.median(sums)
        before, left = left, float(np.square(sums - middle).sum())
        if left > before - _EQUAL:
            break
        for question, order in widest_first:
            others = sums - question.predicted[order[:papers]]
            _exchange(question, order, others)
            _replace(question, order, middle - others)
            sums = others + question.predicted[order[:papers]]
    return [order[:papers] for order in orders], sums


def _negative_range(entry: tuple[Candidates, Any]) -> float:
    return -float(np.ptp(entry[0].predicted))


def _exchange(question: Candidates, order: Any, others: Any) -> None:
    """Give the candidates of the free papers, in place, to these papers against the order of the
    `others`, the sums without this question, where this brings the sums closer.
    """
    free = question.free
    to = free[np.argsort(-np.round(others[free], 9), kind="stable")]
    held = order[free]
    given = held[np.argsort(question.predicted[held], kind="stable")]
    if np.var(others[to] + question.predicted[given]) < (
        np.var(others[free] + question.predicted[held]) - _EQUAL
    ):
        order[to] = given


def _replace(question: Candidates, order: Any, wanted: Any) -> None:
    """Give each free paper, in place, the candidate to spare nearest to what is `wanted` of this
    question, where it is nearer than its own; those farthest off choose first.
    """
    papers = len(wanted)
    off = np.abs(question.predicted[order[:papers]] - wanted)
    for paper in question.free[np.argsort(-np.round(off[question.free], 9), kind="stable")]:
        away = np.abs(question.predicted[order[papers:]] - wanted[paper])
        if away.size and away.min() < off[paper] - _EQUAL:
            spare = papers + int(np.argmin(np.round(away, 9)))
            order[paper], order[spare] = order[spare], order[paper]
