"""Who goes on rightly from an own wrong value is charged for it once."""

from __future__ import annotations

import pytest

from tests.by_hand.claims import following
from tests.by_hand.school import Exam

TURNS = 1
pytestmark = pytest.mark.xdist_group("by_hand")


def test_every_edge_is_followed(four_figures: Exam) -> None:
    found = following(four_figures, TURNS)
    assert found.tried.total() > 0
    assert found.beyond(0) == set(), str(found)
