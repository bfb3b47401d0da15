"""Motions of one structure stacked: every number is that of its instance."""

from __future__ import annotations

import numpy as np

from kinegrade.mechanics.motion_arrays import describe_structure, stack_motions, stack_numbers
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template


def test_a_stack_holds_the_numbers_of_each() -> None:
    template = load_template("slider-crank")
    first = solve_template(template, {"phi": "30"})
    plan = first.motion.plan
    motions = [
        first.doubles,
        *(solve_template(template, {"phi": phi}, None, plan).doubles for phi in ("60", "105")),
    ]
    assert len({describe_structure(motion) for motion in motions}) == 1
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
    assert describe_structure(stack_motions([motion, motion])) == describe_structure(motion)


def test_what_is_the_same_in_all_stays_one_number_down_to_the_sign_of_zero() -> None:
    assert stack_numbers([0.5, 0.5]) == 0.5
    assert stack_numbers([0.0, -0.0]).tolist() == [0.0, -0.0]
