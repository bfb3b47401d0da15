"""Dealing the questions of an exam so that its papers are alike hard.

A student, or version, that has a paper keeps its numbers. The others get combinations that no one
has yet, while these last, such that the predicted sums of all papers differ little. Where those
that were looked at do not serve, more of a deck is looked at.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping, Sequence, Set
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from kinegrade.draws.alike import Candidates, make_alike, order_by_use
from kinegrade.draws.deal import Deal, Look, look_further
from kinegrade.draws.deck import Combination, Deck
from kinegrade.exam.setting.difficulties import find_difficulty
from kinegrade.exam.setting.given_questions import give_questions
from kinegrade.exam.setting.kept_deal import Stated, find_kept
from kinegrade.exam.setting.setting import Exam

SHARE_LEFT = 0.15  # of the standard deviation of papers dealt in the order of the decks
_NEGLIGIBLE = 1e-9  # squared points
_MOST_SPARE = 4  # combinations for each that is dealt ...
_SPARE_FOR_FEW = 8  # ... and so many more, which are looked at in any case

Predict = Callable[[Sequence[Combination]], Any]


@dataclass(frozen=True)
class Pool:
    """What a question offers to those `holders` among `papers` that hold it: the values that some
    keep, and the good combinations that its `deal` found in its `deck`. `predict` gives
    difficulties, in points.

    Where all have the `same` values, they are those that the first paper keeps, or the first good
    ones.
    """

    papers: Sequence[str]
    holders: Set[str]
    deck: Deck
    predict: Predict
    kept: Mapping[str, Combination]
    deal: Deal
    same: bool = False

    @cached_property
    def free(self) -> Any:
        """The numbers of the papers without values yet, among which values may be exchanged."""
        if self.same:
            return np.array([], dtype=np.intp)
        waiting = self.holders - self.kept.keys()
        return np.flatnonzero([paper in waiting for paper in self.papers])

    @cached_property
    def combinations(self) -> list[Combination | None]:
        """For each paper what it keeps or may get, None where it does not hold the question; then
        those to spare.
        """
        good = [self.deck.combination(at) for at in self.deal.positions[: self.deal.wanted]]
        if self.same:
            common = next((self.kept[each] for each in self.papers if each in self.kept), good[0])
            one = {paper: self.kept.get(paper, common) for paper in self.holders}
            return [one.get(paper) for paper in self.papers]
        held = Counter(tuple(values.values()) for values in self.kept.values())
        used = [held[tuple(values.values())] for values in good]
        dealt, spare = order_by_use(used, len(self.free))
        given = {self.papers[place]: good[at] for place, at in zip(self.free, dealt, strict=True)}
        own = {**self.kept, **given}
        return [*(own.get(paper) for paper in self.papers), *(good[number] for number in spare)]

    @cached_property
    def candidates(self) -> Candidates:
        """The combinations by their difficulties; a question that a paper does not hold adds
        nothing to it.
        """
        known = [each for each in self.combinations if each is not None]
        predicted = np.zeros(len(self.combinations))
        predicted[self._known] = self.predict(known)
        return Candidates(predicted, self.free)

    @property
    def variance(self) -> float:
        """The variance of the difficulties on the papers that hold it, in squared points."""
        return float(np.var(self.candidates.predicted[self._known]))

    @property
    def _known(self) -> Any:
        """Which of the combinations there are."""
        return np.array([each is not None for each in self.combinations])

    @property
    def more(self) -> int:
        """How many more good combinations to look for, 0 where there can be no more."""
        if not self.free.size:
            return 0
        enough = _MOST_SPARE * len(self.free) + 2 * _SPARE_FOR_FEW
        if len(self.deal.positions) < self.deal.wanted or self.deal.spare >= enough:
            return 0
        return min(max(len(self.free) // 2, _SPARE_FOR_FEW), enough - self.deal.spare)


@dataclass(frozen=True)
class AlikeDeal:
    """Papers dealt from the pools of questions."""

    papers: Sequence[str]
    pools: Mapping[str, Pool]

    @property
    def values(self) -> dict[str, dict[str, Combination]]:
        """For each question what everyone gets, by paper."""
        numbers, _ = self._dealt
        return {
            name: {
                paper: values
                for paper, number in zip(self.papers, given, strict=True)
                if (values := pool.combinations[number]) is not None
            }
            for (name, pool), given in zip(self.pools.items(), numbers, strict=True)
        }

    @property
    def alike(self) -> bool:
        """Whether the sums of the papers that are dealt differ little from the mean of all."""
        _, sums = self._dealt
        dealt = np.unique(np.concatenate([pool.free for pool in self.pools.values()]))
        left = float(np.square(sums[dealt] - sums.mean()).sum()) / max(len(dealt), 1)
        naive = sum(
            pool.variance * len(pool.holders) / len(self.papers) for pool in self.pools.values()
        )
        return left <= SHARE_LEFT**2 * naive + _NEGLIGIBLE

    def widest(self) -> str | None:
        """The question that differs most of those of which more can be looked at, None if there
        are none.
        """
        able = [name for name, pool in self.pools.items() if pool.more]
        return max(able, key=lambda name: self.pools[name].variance, default=None)

    def widened(self, name: str, exam: Exam, look: Look) -> AlikeDeal:
        """The deal with more of a question's deck looked at."""
        pool = self.pools[name]
        begun = replace(pool.deal, spare=pool.deal.spare + pool.more)
        further = look_further(exam.filters, {name: begun}, look)
        return replace(self, pools={**self.pools, name: replace(pool, deal=further[name])})

    @cached_property
    def _dealt(self) -> tuple[list[Any], Any]:
        pools = [pool.candidates for pool in self.pools.values()]
        return make_alike(pools, len(self.papers))


def deal_alike(exam: Exam, places: Mapping[str, int], stated: Stated, look: Look) -> AlikeDeal:
    """An exam dealt to papers, or versions, by place; `stated` is what some of them have already.

    Raises DrawError for questions of which no combination is good.
    """
    papers = tuple(places)
    spare = _SPARE_FOR_FEW if len(papers) > 1 else 0
    same = {each.identifier for each in exam.bank.questions if each.dealing == "same"}
    given = give_questions(exam.bank, exam.secret, places, stated)
    holders = {
        name: frozenset(paper for paper in papers if name in given[paper]) for name in exam.filters
    }
    left = max(places.values()) + 1 - len(papers)  # places of those who have left
    begun = {
        name: Deal(each.deck.size, 1)
        if name in same
        else Deal(each.deck.size, max(len(holders[name]) + left, 1), spare=spare)
        for name, each in exam.filters.items()
    }
    pools = {
        name: Pool(
            papers,
            holders[name],
            exam.filters[name].deck,
            find_difficulty(exam, name).predict,
            {
                paper: values
                for paper, values in find_kept(exam.filters[name].deck, stated, name).items()
                if paper in holders[name]
            },
            found,
            name in same,
        )
        for name, found in look_further(exam.filters, begun, look).items()
    }
    dealt = AlikeDeal(papers, pools)
    while not dealt.alike and (name := dealt.widest()) is not None:
        dealt = dealt.widened(name, exam, look)
    return dealt
