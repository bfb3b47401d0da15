"""Positions of a four-bar with velocities and accelerations, against pylinkage, which has them by
formulas of its own for each kind of dyad.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator

import numpy as np
from pylinkage import Crank, Ground, RRRDyad
from pylinkage.simulation import Linkage

from benchmarks.figure_of_merit import Figure, seconds
from kinegrade.motion.path import MotionPath, find_path
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template

_POSITIONS = 20_000
_PROMISED = 1e-5  # seconds: 100,000 positions a second
AGAINST_PEER = 2


def figures() -> Iterator[Figure]:
    """The time of one position, against the promised one and against pylinkage's."""
    ours = seconds(follow_four_bar(), 9) / _POSITIONS
    yield Figure("a position of a four-bar, and 10 microseconds", ours, _PROMISED, 1)
    theirs = seconds(follow_by_pylinkage(), 3) / _POSITIONS
    yield Figure("a position of a four-bar, and by pylinkage", ours, theirs, AGAINST_PEER)


def follow_four_bar() -> Callable[[], object]:
    """All positions of a turn, a thousand of which would do for a picture."""
    path = find_path(solve_template(load_template("pole-four-bar-coupler"), {}).motion)
    if not isinstance(path, MotionPath):
        raise TypeError(path)
    moved = np.linspace(*path.bounds, _POSITIONS)
    return lambda: path.place(moved).motion


def follow_by_pylinkage() -> Callable[[], object]:
    """The same number of positions of a crank-rocker."""
    start, end = Ground(0.0, 0.0, name="A"), Ground(4.0, 0.0, name="D")
    crank = Crank(start, 1.0, math.tau / _POSITIONS, name="B")
    rocker = RRRDyad(crank.output, end, 3.5, 2.5, name="C")
    linkage = Linkage([start, end, crank, rocker])
    return lambda: list(linkage.step_with_derivatives(iterations=_POSITIONS))
