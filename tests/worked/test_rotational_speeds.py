"""A rotational speed n is a number of turns in a time, and the angular velocity is 2 pi n."""

from __future__ import annotations

import pytest

from tests.worked.draws import kept
from tests.worked.telling import lines


@pytest.mark.parametrize(
    ("name", "line"),
    [
        (
            "epicyclic-train-by-tooth-counts",
            r"\omega_{OP} &= 2\pi\,n_{OP} = \frac{2\pi \cdot 18}{60\,\unit{s}} = \frac{3\pi}{5}",
        ),
        ("four-bar-by-lengths", r"\omega_{AB} &= -2\pi\,n = -\frac{2\pi \cdot 120}{60\,\unit{s}}"),
        (
            "epicyclic-train-by-tooth-counts",
            r"n_{B} &= \frac{\omega_{B}}{2\pi} = \frac{-4.901\,\unit{rad/s}}{2\pi} \cdot 60\,\unit{s/min}",
        ),
        ("slider-crank", r"\omega_{OA} &= -\omega = -1\,\unit{rad/s}"),
    ],
)
def test_turns_become_radians_by_two_pi(name: str, line: str) -> None:
    assert line in "\n".join(lines(kept(name)))


def test_a_rotational_speed_that_is_asked_has_its_sense() -> None:
    (line,) = (one for one in lines(kept("belt-driven-bicycle")) if "n_{A} &=" in one)
    assert line.endswith(r"\quad\text{(clockwise)}")
