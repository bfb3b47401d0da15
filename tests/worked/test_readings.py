"""What reading solutions line by line has found: sentences that were not so, symbols and numbers
that were missing, and phrases that nobody says.
"""

from __future__ import annotations

import pytest

from kinegrade.language import Language
from tests.worked.draws import kept
from tests.worked.telling import displayed, lines, proses


def _read(name: str, language: Language = "en") -> str:
    return "\n".join(proses(kept(name, 0, None, language)))


def test_the_idea_names_the_base_point_that_the_step_takes() -> None:
    # the velocity of C is given, and the step went by base point B all the same
    told = _read("rack-steering")
    assert "so $C$ serves as base point." in told
    assert "that of the base point $C$ plus" in told


@pytest.mark.parametrize("name", ["bar-pushing-rolling-disc"])
def test_an_absolute_velocity_that_rolling_calls_by_its_point_is_said_to_be_the_same(
    name: str,
) -> None:
    told = _read(name)
    assert r"Here $\boldsymbol{v}_{\mathrm{a}} = \boldsymbol{v}_{C}$" in told
    assert r"Here $\boldsymbol{a}_{\mathrm{a}} = \boldsymbol{a}_{C}$" in told


@pytest.mark.parametrize(
    ("name", "rims"),
    [
        ("hoist-with-gears", "The pitch circles of gears in mesh have equal speeds"),
        ("two-stage-belt-drive", "The rims of pulleys joined by a belt have equal speeds"),
    ],
)
def test_wheels_about_fixed_axes_are_not_seen_from_the_ground(name: str, rims: str) -> None:
    told = _read(name)
    assert rims in told
    assert "the ground" not in told


def test_a_pole_gives_the_rotation_of_a_rocker_in_numbers_too() -> None:
    (turning,) = [
        line for line in displayed(kept("stone-crusher")) if line.startswith(r"\omega_{AB} &=")
    ]
    assert turning.count(r"\frac") >= 2
    assert r"\unit{m/s}}{" in turning


def test_chinese_has_no_preposition_twice() -> None:
    told = _read("oscillating-flat-faced-follower", "zh")
    assert "以从动件为动系" in told
    assert "从从" not in told


def test_a_sum_of_angles_is_worked_out_before_a_point_is_placed_by_it() -> None:
    # the cosine took 86.53 degrees, which stood nowhere
    told = displayed(kept("watt-linkage"))
    (place,) = [place for place, line in enumerate(told) if line.startswith("x_{C} &=")]
    assert told[place - 1].endswith(r"= 17.8209^\circ + 68.7136^\circ \approx 86.5345^\circ")
    assert r"\cos 86.5345^\circ" in told[place]


def test_a_relative_rotation_is_added_in_numbers() -> None:
    # the sum stood there without its terms
    (turning,) = [
        line for line in displayed(kept("two-link-robot-arm")) if line.startswith(r"\omega_{AB} &=")
    ]
    sum_of_both = (
        r"\omega_{AB} &= \omega_{OA} - \omega_{\mathrm{r}} = 1\,\unit{rad/s} - 2\,\unit{rad/s}"
    )
    assert turning.startswith(sum_of_both)


@pytest.mark.parametrize("name", ["tangent-cam-with-roller", "roller-rolling-on-rotating-bar"])
def test_a_named_length_is_not_found_again_by_coordinates(name: str) -> None:
    # OC = y_C was told after y_C = OC
    assert r"= y_{C}" not in _read(name)
    assert r"= x_{B}" not in _read(name)


def test_a_part_of_a_relative_acceleration_is_taken_as_it_was_found() -> None:
    """Both parts went into components along x and y, and came back from these."""
    page = displayed(kept("pin-in-two-rings"))
    found = r"a_{\mathrm{r},1}^{\mathrm{t}} &= a_{\mathrm{r}1}^{\mathrm{t}} = 0.5"
    assert [line for line in page if line.startswith(found)] != []
    assert [line for line in page if "a_{\\mathrm{r}1,x}" in line] == []


def test_of_a_rope_the_straight_part_translates_with_its_load() -> None:
    told = _read("hoist-with-gears")
    assert "the straight part of the rope with the load: translation" in told
    assert "the drum, which turns with the gear" in told


def test_the_sense_about_a_moving_centre_is_that_of_the_question_from_the_table_on() -> None:
    told = _read("eccentric-cam-offset-follower")
    assert r"$\perp CA,\curvearrowright$" in told
    assert "Counted as asked for" not in told
    assert "constant length" not in told


@pytest.mark.parametrize("name", ["slotted-bar-between-two-rods", "slotted-link-on-cylinder"])
def test_a_given_velocity_is_said_to_be_the_absolute_one_before_a_table_calls_it_so(
    name: str,
) -> None:
    page = list(lines(kept(name)))
    called = r"Here $\boldsymbol{v}_{\mathrm{a}} = \boldsymbol{v}_{B}$"
    (said,) = (place for place, line in enumerate(page) if line.startswith(called))
    (table,) = (
        place
        for place, line in enumerate(page)
        if line.startswith(r"    [ ] \boldsymbol{v}_{\mathrm{a}} |")
    )
    assert said < table


@pytest.mark.parametrize(
    "name", ["crank-bar-through-sleeve-with-arm", "slotted-rocker-and-slider-two-drivers"]
)
def test_a_coriolis_acceleration_is_found_after_its_theorem(name: str) -> None:
    page = list(lines(kept(name)))
    chapter = page.index("# Accelerations")
    found = [place for place, line in enumerate(page) if r"a_{\mathrm{Cor}} &=" in line]
    assert found
    assert min(found) > chapter
