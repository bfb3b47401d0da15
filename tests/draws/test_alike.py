"""Papers alike hard: the sums come close, nobody's combination is dealt twice without need, and who
has a paper keeps it.
"""

from __future__ import annotations

from collections import Counter

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.draws.alike import Candidates, make_alike, order_by_use

SEEDS = st.integers(0, 10**6)


def questions(
    spreads: list[float], papers: int, spare: int, seed: int, steps: float | None = None
) -> list[Candidates]:
    """Difficulties about 5 points, skewed as those of templates are; in `steps` if any."""
    chance = np.random.default_rng(seed)
    drawn = [5 - each * chance.exponential(size=papers + spare) for each in spreads]
    stepped = [np.round(one / steps) * steps if steps else one for one in drawn]
    return [Candidates(one, np.arange(papers)) for one in stepped]


def naive(papers: list[Candidates], count: int) -> float:
    return float(np.sum([each.predicted[:count] for each in papers], axis=0).std())


@given(
    st.lists(st.floats(0.3, 1), min_size=3, max_size=7),
    st.integers(20, 120),
    SEEDS,
    st.sampled_from([None, 0.1]),
)
def test_sums_of_several_questions_differ_at_most_a_quarter_as_much(
    spreads: list[float], papers: int, seed: int, steps: float | None
) -> None:
    asked = questions(spreads, papers, papers, seed, steps)
    numbers, sums = make_alike(asked, papers)
    dealt = [each.predicted[given] for each, given in zip(asked, numbers, strict=True)]
    assert np.allclose(np.sum(dealt, axis=0), sums)
    assert sums.std() <= naive(asked, papers) / 4


@given(st.floats(0.1, 2), st.integers(20, 100), SEEDS)
def test_one_question_takes_what_is_near_the_middle(spread: float, papers: int, seed: int) -> None:
    [asked] = questions([spread], papers, 4 * papers, seed)
    _, sums = make_alike([asked], papers)
    ordered = np.sort(asked.predicted)
    first = np.searchsorted(ordered, sums.min())
    assert np.allclose(np.sort(sums), ordered[first : first + papers])


@given(st.integers(1, 40), st.integers(0, 30), st.integers(1, 4), SEEDS)
def test_what_is_dealt_is_dealt_once(papers: int, spare: int, count: int, seed: int) -> None:
    numbers, _ = make_alike(questions([1.0] * count, papers, spare, seed), papers)
    assert len(numbers) == count
    for given_numbers in numbers:
        assert len(set(given_numbers.tolist())) == papers
        assert set(given_numbers.tolist()) <= set(range(papers + spare))


@given(st.integers(1, 30), SEEDS, st.data())
def test_who_is_not_free_keeps_what_they_have(papers: int, seed: int, data: st.DataObject) -> None:
    free = [
        np.flatnonzero(data.draw(st.lists(st.booleans(), min_size=papers, max_size=papers)))
        for _ in range(3)
    ]
    asked = [
        Candidates(each.predicted, some)
        for each, some in zip(questions([1, 0.5, 0.2], papers, 5, seed), free, strict=True)
    ]
    numbers, _ = make_alike(asked, papers)
    for given_numbers, some in zip(numbers, free, strict=True):
        kept = np.setdiff1d(np.arange(papers), some)
        assert (given_numbers[kept] == kept).all()


def test_where_all_are_alike_the_order_of_the_deck_stays() -> None:
    same = Candidates(np.full(9, 4.2), np.arange(6))
    numbers, sums = make_alike([same, same], 6)
    assert [given_numbers.tolist() for given_numbers in numbers] == [[*range(6)]] * 2
    assert sums == pytest.approx([8.4] * 6)


def test_a_late_paper_is_like_those_that_are_there() -> None:
    # Three papers of 9 points are kept; the fourth may have 2, 3, 4 and 1, 4, 6 points
    kept = [4.0, 5.0, 4.5]
    first = Candidates(np.array([*kept, 2, 3, 4]), np.array([3]))
    second = Candidates(np.array([*(9 - each for each in kept), 1, 4, 6]), np.array([3]))
    numbers, sums = make_alike([first, second], 4)
    assert sums[3] == pytest.approx(9)
    assert [given_numbers[:3].tolist() for given_numbers in numbers] == [[0, 1, 2]] * 2


@given(st.lists(st.integers(0, 3), min_size=1, max_size=12), st.integers(0, 40))
def test_none_is_dealt_again_while_there_are_others(used: list[int], count: int) -> None:
    dealt, spare = order_by_use(used, count)
    assert len(dealt) == count
    assert not set(dealt) & set(spare)
    fresh = [number for number, times in enumerate(used) if not times]
    assert sum(number in fresh for number in set(dealt)) == min(count, len(fresh))
    assert set(spare) <= set(fresh)


@given(st.integers(1, 12), st.integers(0, 40))
def test_too_few_are_dealt_round_evenly(size: int, count: int) -> None:
    counts = Counter(order_by_use([0] * size, count)[0])
    dealt = [counts[number] for number in range(size)]
    assert max(dealt) - min(dealt) <= 1
