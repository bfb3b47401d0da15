"""Motions of one structure stacked: every number is that of its instance."""

from __future__ import annotations

import numpy as np
import pytest

from kinegrade.mechanics.motion_arrays import stack_motions, stack_numbers, stack_vectors
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template

NAMES = ("slider-crank", "pose-four-bar-coupler")


def test_a_stack_holds_the_numbers_of_each() -> None:
    template = load_template("slider-crank")
    first = solve_template(template, {"phi": "30"})
    plan = first.motion.plan
    motions = [
        first.doubles,
        *(solve_template(template, {"phi": phi}, None, plan).doubles for phi in ("60", "105")),
    ]
    whole = stack_motions(motions)
    for place, motion in enumerate(motions):
        for name, rate in motion.rates.items():
            assert np.broadcast_to(whole.rates[name], 3)[place] == rate
        for name, point in motion.points.items():
            assert [np.broadcast_to(part, 3)[place] for part in whole.points[name]] == list(point)
        for relation, same in zip(motion.frames.relations, whole.frames.relations, strict=True):
            for term, other in zip(relation.left, same.left, strict=True):
                assert [np.broadcast_to(part, 3)[place] for part in other.vector] == list(
                    term.vector
                )


def test_poses_are_stacked_too() -> None:
    template = load_template("pose-four-bar-coupler")
    motion = solve_template(template, {}).doubles
    together = stack_motions([motion, motion])
    assert together.points == motion.points
    assert not together.plan.steps


def test_motions_of_other_mechanisms_are_not_stacked() -> None:
    motions = [solve_template(load_template(name), {}).doubles for name in NAMES]
    with pytest.raises(ValueError, match="shorter"):
        stack_motions(motions)


def test_points_are_stacked_component_by_component() -> None:
    both = stack_vectors([Vector(1.0, 2.0), Vector(1.0, 3.0)])
    assert (both.x, both.y.tolist()) == (1.0, [2.0, 3.0])


def test_what_is_the_same_in_all_stays_one_number_down_to_the_sign_of_zero() -> None:
    assert stack_numbers([0.5, 0.5]) == 0.5
    assert stack_numbers([0.0, -0.0]).tolist() == [0.0, -0.0]
