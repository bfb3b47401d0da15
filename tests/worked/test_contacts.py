"""Points at which bodies touch: what each body has there."""

from __future__ import annotations

import pytest

from kinegrade.language import Language
from tests.worked.draws import kept
from tests.worked.telling import proses


@pytest.mark.parametrize(
    ("language", "sentence"),
    [
        ("en", "The point of the cam that coincides with $A$ turns about $O$:"),
        ("de", "Der Punkt der Kurvenscheibe, der mit $A$ zusammenfällt, dreht sich um $O$:"),
        ("zh", "凸轮上与 $A$ 重合的点绕 $O$ 转动："),
    ],
)
def test_the_contact_is_the_followers_point_and_the_cam_has_one_there(
    language: Language, sentence: str
) -> None:
    """By the statement A is a point of the follower, which the cam passes by."""
    told = tuple(proses(kept("flat-faced-follower-eccentric-circle", 0, None, language)))
    assert sentence in told


def test_a_pin_is_a_point_of_both_bodies() -> None:
    told = tuple(proses(kept("slider-crank")))
    assert not any("coincides" in one for one in told)
    assert "$A$ is a point of $OA$, which turns about $O$:" in proses(
        kept("planetary-gear-external-rim-velocities")
    )


@pytest.mark.parametrize(
    ("language", "racks"),
    [
        ("en", "at the contacts with the rack $A$ and the rack $B$ at any time; differentiated"),
        ("zh", "与齿条 $A$ 和齿条 $B$ 的接触点在任意时刻均无滑动，对时间求导，分别相对于它们，"),
        ("de", "an den Berührpunkten mit der Zahnstange $A$ und der Zahnstange $B$ nichts gleitet"),
    ],
)
def test_no_slip_between_moving_bodies_says_once_which_at_accelerations_too(
    language: Language, racks: str
) -> None:
    """Of a pinion between two racks the same sentence led to two different equations."""
    said = proses(kept("pinion-between-two-racks", 0, None, language))
    assert sum(racks in text for text in said) == 1
