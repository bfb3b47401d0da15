"""What goes with two other points, as on one body, is not baked a second time."""

from __future__ import annotations

import numpy as np

from kinegrade.practice.poses import FINE, frame_poses, write_motion
from kinegrade.practice.skeleton import list_marked
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template
from tests.practice.node import move_in_node
from tests.practice.test_motion import find_motion

GEARS = "planetary-gear-external-rim-velocities"


def test_of_a_planet_gear_its_centre_and_its_mark_alone_are_baked() -> None:
    path = find_motion(GEARS)
    motion = write_motion(path, solve_template(load_template(GEARS), {}), ())
    baked = {row // 2 for row, text in enumerate(motion.coordinates) if " " in text.lstrip("=")}
    written = {place for place in baked if not motion.coordinates[2 * place].startswith("=")}
    assert written == {place for pair in list_marked(path).values() for place in pair}
    assert len(baked) > len(written)


def test_points_that_are_not_baked_are_where_the_engine_has_them() -> None:
    """To a few steps of the table, which has a thousandth part of a pixel."""
    path = find_motion(GEARS)
    motion = write_motion(path, solve_template(load_template(GEARS), {}), ())
    table, window = frame_poses(path)
    count = len(table.moved)
    shares = [place / count for place in range(count)]
    (shown,) = move_in_node([motion], shares)["shown"]
    expected = window.project(table.places)
    found = np.array([np.ravel(each["points"])[: len(expected)] for each in shown]).T
    assert np.abs(found - expected).max() <= 2.5 / FINE
