"""A known mistake costs all points of the answers it changes, and is named."""

from __future__ import annotations

import pytest

from tests.by_hand.claims import mistaken
from tests.by_hand.school import Exam

TURNS = 2
NOT_YET = {  # no answer is recognised as these
    "added-as-scalars",
    "coriolis-wrong-omega",
    "degrees-per-second",
    "inverse-ratio",
    "minus-in-magnitude",
    "omega-not-squared",
    "one-length-for-another",
    "pole-on-velocities",
    "relative-normal-outwards",
    "rpm-typed",
    "supplementary-angle",
    "tangential-dropped",
    "three-powers-of-ten-down",
    "three-powers-of-ten-up",
    "translation-assumed",
    "two-powers-of-ten-down",
    "two-powers-of-ten-up",
}
# The way from A to O is found of a mistaken angle, which a student reads off the figure; gears of
# one size have no mesh on the inside.
UNNAMED = {
    ("bar-through-swivelling-sleeve", "degrees-for-radians"),
    ("bar-through-swivelling-sleeve", "sine-for-cosine"),
    ("planetary-gear-external-rim-accelerations", "meshing-reversed"),
    ("planetary-gear-external-rim-velocities", "meshing-reversed"),
}
pytestmark = pytest.mark.xdist_group("by_hand")


def test_each_mistake_is_refused_and_named(four_figures: Exam) -> None:
    found = mistaken(four_figures, TURNS)
    assert found.tried.total() > 0
    failed = {tuple(where.split()[:2]) for where in found.failed}
    assert {each for each in failed - UNNAMED if each[1] not in NOT_YET} == set(), found
