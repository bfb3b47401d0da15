"""Points at which bodies touch: what each body has there."""

from __future__ import annotations

import pytest

from kinegrade.language import Language
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import find_shipped
from kinegrade.problem.template.library.reading import read_template
from tests.worked.draws import kept, told
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
    page = tuple(proses(kept("flat-faced-follower-eccentric-circle", 0, None, language)))
    assert sentence in page


def test_a_pin_is_a_point_of_both_bodies() -> None:
    told = tuple(proses(kept("slider-crank")))
    assert [one for one in told if "coincides" in one] == []
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
    """Of a pinion between two racks the same sentence led to two different equations: it is solved
    seen from the racks where a motion relative to one of them is asked for.
    """
    shipped = find_shipped("templates") / "pinion-between-two-racks.toml"
    quantity = "x(relative_velocity(C, pinion, rack_A))"
    means = '{ en = "velocity of $C$ seen from the rack $A$" }'
    ask = f'v_r = {{ quantity = "{quantity}", unit = "mm/s", sign = "+x", means = {means} }}'
    text = shipped.read_text(encoding="utf-8").replace("[asks]", f"[asks]\n{ask}")
    solution = solve_template(read_template("pinion", text, kept=True), {})
    said = proses(told(solution, language=language))
    assert sum(racks in text for text in said) == 1
