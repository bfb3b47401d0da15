"""The cycles of all templates: positions meet an independent model of the joints, rates are the
derivatives of positions, and neighbours on a path lie near each other.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from mpmath import mp, mpf

from kinegrade.mechanics.rates import make_turning
from kinegrade.motion.path import Array, MotionPath, Placement
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import find_template_names, load_template
from tests.laws.position import DIGITS, PositionModel
from tests.motion.mechanisms import follow

TEMPLATES = [name for name in find_template_names() if load_template(name).scheme.drivers]
STEP = 2e-3  # of the input: Richardson's sixth order leaves 1e-11 of what is smooth


@pytest.fixture(scope="module", params=TEMPLATES)
def path(request: pytest.FixtureRequest) -> MotionPath:
    return follow(solve_template(load_template(request.param), {}).motion)


def spread_within_half_a_turn(path: MotionPath, count: int) -> Placement:
    """Positions in which nothing has turned by more than the independent model can tell."""
    moved = path.spread(count)
    turned = [np.broadcast_to(c, moved.shape) for c in path.place(moved).at.coordinates.values()]
    near = moved[np.abs(turned).max(axis=0) < 3.0]
    assert len(near) >= 5
    return path.place(near[np.linspace(0, len(near) - 1, 5).astype(int)])


def find_poses(placement: Placement, number: int) -> list[Any]:
    """The unknowns of the independent model at one position."""
    frames, at, unknowns = placement.path.motion.frames, placement.at, []
    for body in frames.mechanism.bodies:
        base = frames.bases[body.name]
        arm = frames.mechanism.points[body.points[0]] - frames.mechanism.points[base.point]
        shift = at.move_chain(base.chain).shift + at.carry(body.name, arm) - arm
        rate = make_turning(body.name)
        pose = [shift.x, shift.y] if body.particle else [*shift, at.coordinates[rate]]
        unknowns += [mpf(float(np.broadcast_to(c, placement.moved.shape)[number])) for c in pose]
    return unknowns


@pytest.mark.sampled(8, by="path")
def test_positions_meet_an_independent_model_of_the_joints(path: MotionPath) -> None:
    placement = spread_within_half_a_turn(path, 400)
    with mp.workdps(DIGITS):
        model = PositionModel(path.motion.frames.mechanism)
        for number in range(len(placement.moved)):
            poses = model.poses(find_poses(placement, number))
            for joint in model.mechanism.joints:
                missed = [abs(value) for value in model.joint(poses, joint)]
                assert max(missed, default=0) <= 1e-12 * path.size, joint


@pytest.mark.sampled(4, by="path")
def test_every_position_meets_its_conditions(path: MotionPath) -> None:
    assert path.place(path.spread(721)).greatest <= 1e-12 * path.size


@pytest.mark.sampled(4, by="path")
def test_neighbours_on_a_path_lie_near_each_other(path: MotionPath) -> None:
    moved = path.spread(4001)
    for coordinate in path.place(moved).at.coordinates.values():
        steps = np.abs(np.diff(np.broadcast_to(coordinate, moved.shape)))
        padded = np.pad(steps, 1, mode="reflect")
        assert (steps <= 3 * np.maximum(padded[:-2], padded[2:]) + 0.1).all()


def choose_inside(path: MotionPath) -> Array:
    """Displacements at which the path is smooth over several steps."""
    low, high = path.bounds
    return low + (high - low) * np.array([0.2, 0.33, 0.47, 0.71, 0.8])


def differentiate(at: Callable[[float], Array], step: float) -> tuple[Array, Array]:
    """First and second derivatives by central differences of the eighth order."""
    first = (4 / 5, -1 / 5, 4 / 105, -1 / 280)
    second = (8 / 5, -1 / 5, 8 / 315, -1 / 560)
    pairs = [(at((k + 1) * step), at(-(k + 1) * step)) for k in range(4)]
    slope = sum(w * (p - m) for w, (p, m) in zip(first, pairs, strict=True)) / step
    bend = sum(w * (p + m) for w, (p, m) in zip(second, pairs, strict=True)) - 205 / 72 * at(0.0)
    return slope, bend / step**2


def drive_in_step(path: MotionPath) -> MotionPath:
    """The path with the drivers' accelerations in proportion, as their velocities are."""
    frames, change = path.motion.frames, float(path.input.leading.acceleration)
    relations = tuple(
        replace(relation, acceleration=share * change)
        for relation, share in zip(frames.relations, path.input.shares, strict=True)
    )
    return follow(replace(path.motion, frames=replace(frames, relations=relations)))


@pytest.mark.sampled(8, first=2, by="path")
def test_rates_and_their_changes_are_the_derivatives_of_positions(path: MotionPath) -> None:
    path, moved = drive_in_step(path), choose_inside(path)
    motion = path.place(moved).motion
    leading = path.input.leading
    speed, change = float(leading.velocity), float(leading.acceleration)
    for rate in path.system.rates:
        slope, bend = differentiate(
            lambda gone, rate=rate: np.broadcast_to(  # type: ignore[misc]
                path.place(moved + gone).at.coordinates[rate], moved.shape
            ),
            STEP * (1.0 if path.input.is_angle else path.size),
        )
        scale = 1 + np.abs(slope * speed)
        assert np.abs(slope * speed - motion.rates[rate]).max() <= 1e-8 * scale.max(), rate
        # what differences miss of a bend is one share of it at any speed
        bends, scale = bend * speed**2 + slope * change, 1 + (1 + np.abs(bend)) * speed**2
        assert np.abs(bends - motion.changes[rate]).max() <= 1e-6 * scale.max(), rate
