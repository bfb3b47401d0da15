"""Axes: round steps, whole intervals."""

from __future__ import annotations

import pytest

from kinegrade.cycles.ticks import make_axis, make_turn_axis


@pytest.mark.parametrize(
    ("low", "high", "ticks"),
    [
        (0.0, 1.166, ["0.0", "0.5", "1.0", "1.5"]),
        (-0.577, 0.577, ["-1.0", "-0.5", "0.0", "0.5", "1.0"]),
        (-31.0, 42.0, ["-40", "-20", "0", "20", "40", "60"]),
        (2.0, 2.0, ["0", "1", "2", "3", "4"]),
        (0.0, 0.0, ["-1.0", "-0.5", "0.0", "0.5", "1.0"]),
    ],
)
def test_steps_are_1_2_or_5(low: float, high: float, ticks: list[str]) -> None:
    axis = make_axis(low, high, 4)
    assert [axis.write(tick) for tick in axis.ticks] == ticks


def test_turns_have_steps_of_45_degrees_and_end_where_they_end() -> None:
    axis = make_turn_axis(-10.0, 350.0, 9)
    assert [axis.write(tick) for tick in axis.ticks] == [str(tick) for tick in range(0, 316, 45)]
    assert axis.place(350.0) == 1.0
