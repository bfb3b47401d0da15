"""How often mistakes lead to right answers: shares that are known beforehand by symmetry."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from kinegrade.problem.template.library.library import load_template
from kinegrade.students.near_mistakes import NearMistakes, find_near_mistakes
from kinegrade.students.separation import Separation
from tests.problem.draws import draw_filter


def find_shares(**fixed: tuple[str, ...]) -> tuple[Separation, NearMistakes]:
    draws = draw_filter(load_template("slider-crank"), fixed=fixed)
    assert draws.separation is not None
    return draws.separation, find_near_mistakes(draws.separation)


def test_what_45_degrees_hide_is_refused_as_often_as_they_are_drawn() -> None:
    separation, near = find_shares(phi=("30", "45", "60"), alpha=("5", "10"))
    sample = separation.sample
    drawn = np.array(sample["phi"]) == "45"
    fit = separation.compare(sample).fit
    assert near.refused["v_B"]["sine-for-cosine"] == pytest.approx(drawn[fit].mean(), abs=0.01)
    assert list(near.refused["a_B"].values()) == sorted(near.refused["a_B"].values(), reverse=True)
    assert "coriolis-dropped" not in near.refused["v_B"]  # it has nothing to do with velocities


def test_a_surface_twice_as_large_as_the_track_hides_which_was_taken() -> None:
    """Too many draws would be lost if they had to tell the diameter from the radius."""
    separation = draw_filter(load_template("two-wheels-on-cylinder")).separation
    assert separation is not None
    near = find_near_mistakes(separation)
    assert 0 < near.passing["omega_2"]["diameter-for-radius.R"] < 1
    assert "diameter-for-radius.R" not in near.refused["omega_2"]


def test_nothing_is_told_of_draws_that_are_not_fit() -> None:
    separation, _ = find_shares()
    still = {**separation.sample, "phi": ["0"] * len(separation.sample["phi"])}
    near = find_near_mistakes(replace(separation, sample=still))  # at rest in its dead point
    for found in (near.refused, near.passing):
        assert found
        assert {ask: near_ones for ask, near_ones in found.items() if near_ones} == {}
