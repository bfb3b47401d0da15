"""A known mistake costs all points of the answers it changes, and is named."""

from __future__ import annotations

import pytest

from tests.by_hand.claims import mistaken
from tests.by_hand.exceptions import unnamed
from tests.by_hand.school import Exam

TURNS = 2
pytestmark = pytest.mark.xdist_group("by_hand")


def test_each_mistake_is_refused_and_named(four_figures: Exam) -> None:
    found = mistaken(four_figures, TURNS)
    assert found.tried.total() > 0
    assert unnamed(found) == set(), str(found)
