"""Which papers answers fit is the same however it is looked up: all of them at once, few by their
order, or all asks of one paper together.
"""

from __future__ import annotations

import numpy as np
import pytest

from kinegrade.grading.fast.intervals import AsksBeside, Intervals

PAPERS = 300


@pytest.mark.parametrize("period", [0.0, 360.0])
@pytest.mark.parametrize("unasked", [0.0, 0.1])
@pytest.mark.parametrize("share", [0.0, 0.01, 1.0])
def test_papers_are_found_alike(period: float, unasked: float, share: float) -> None:
    chance = np.random.default_rng(2)
    values = np.round(chance.normal(size=PAPERS) * 300, 1)
    values[chance.random(PAPERS) < unasked] = np.nan
    room = share * np.abs(values)
    intervals = Intervals(values, values - room, values + room, period)
    answers = np.concatenate((values * chance.choice([1, 1.01, 1.02, -1]), [0.0, -1e-14]))
    fits = intervals.fit(answers)
    found = np.zeros_like(fits)
    found[intervals.list_fits(answers)] = True
    assert (found == fits).all()
    papers = chance.permutation(PAPERS)
    others = Intervals(values + 1, values + 0.5, values + 2, 0.0)
    given = answers[:PAPERS]
    beside = AsksBeside.of([intervals, others], papers).fit(given)
    assert (beside[0] == intervals.fit_beside(given, papers)).all()
    assert (beside[1] == others.fit_beside(given, papers)).all()
