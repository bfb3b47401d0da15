"""Cells of papers rule out no row all of whose numbers are right on a paper, and most others."""

from __future__ import annotations

import numpy as np
import pytest

from kinegrade.grading.fast.intervals import Intervals
from kinegrade.grading.fast.paper_cells import list_cells

ASKS = 9


def make_intervals(values: np.ndarray, share: float) -> Intervals:
    room = share * np.abs(values)
    return Intervals(values, values - room, values + room, 0.0)


@pytest.mark.parametrize("papers", [1, 2, 40, 3000])
@pytest.mark.parametrize("share", [0.0, 0.01, 0.5])
@pytest.mark.parametrize("digits", [0, 1, 9])
def test_no_row_that_a_paper_has_is_ruled_out(papers: int, share: float, digits: int) -> None:
    chance = np.random.default_rng(papers + digits)
    keys = np.round(chance.normal(size=(papers, ASKS)) * 10, digits)
    each = [make_intervals(keys[:, ask], share) for ask in range(ASKS)]
    off = chance.choice([0.0, share, -share, share / 2], size=keys.shape)
    rows = chance.permutation(keys + off * np.abs(keys))[:300]
    rows[chance.random(rows.shape) < 0.05] = np.nan
    cells = list_cells(range(ASKS), each)
    assert len(cells) == 2
    assert [found for found in cells if not found.may_have(rows).all()] == []


def test_most_rows_that_no_paper_has_are_ruled_out() -> None:
    chance = np.random.default_rng(3)
    keys = chance.normal(size=(3000, ASKS)) * 10
    each = [make_intervals(keys[:, ask], 0.01) for ask in range(ASKS)]
    rows = chance.normal(size=(500, ASKS)) * 10
    first, _ = list_cells(range(ASKS), each)
    assert first.may_have(rows).mean() < 0.2


def test_too_few_asks_have_no_cells() -> None:
    assert list_cells([], []) == []
