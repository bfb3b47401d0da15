"""What a position leaves undetermined: at a change point bodies may go on in several ways, so that
no rates follow from the position alone; and what is nothing divided by nothing is decided by last
digits alone.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from kinegrade.cycles.rounding import Scales
from kinegrade.mechanics.motion import Motion
from kinegrade.mechanics.rates import Rates
from kinegrade.mechanics.vector import Vector
from kinegrade.motion.path import Array, MotionPath, Placement

_LOOSE = 1e-4  # of the greatest singular value: change points are found less well than others
_SHARES = (1.0, 0.7)  # of the ways in which rates, and their changes, may differ
_SAME = 1e-9
_SHAKEN = 1e-11  # of the mechanism's size, and of its usual rates


def find_undetermined(
    path: MotionPath, change: float, beside: float, read: Callable[[Motion, Array], Array]
) -> NDArray[np.bool_]:
    """Which of the values that `read` gives of a motion, one row each, depend at the change point
    at the displacement `change` on rates that are not determined there; `beside` is near by.
    """
    moved = np.array([change])
    placement = path.place(moved)
    found = [read(motion, moved)[:, 0] for motion in _list_motions(placement, beside)]
    with np.errstate(invalid="ignore"):
        apart, size = np.abs(found[1] - found[0]), np.abs(found).max(axis=0)
        return np.asarray(~(apart <= _SAME * size))


def _list_motions(placement: Placement, beside: float) -> tuple[Motion, Motion]:
    """Two motions through a change point that agree in what is determined there."""
    path = placement.path
    near = path.place(np.array([beside])).motion
    rates = path.system.rates
    loose = _find_loose(placement)

    def move(sense: int) -> Motion:
        ways = [
            {
                rate: known[rate] + sense * share * way
                for rate, way in zip(rates, loose, strict=True)
            }
            for known, share in zip((near.rates, near.changes), _SHARES, strict=True)
        ]
        return replace(near, frames=placement.frames, rates=ways[0], changes=ways[1])

    return move(1), move(-1)


def _find_loose(placement: Placement) -> Array:
    """How the rates may differ while the input stands still."""
    path = placement.path
    at = [np.asarray(placement.at.coordinates[rate], dtype=float) for rate in path.system.rates]
    unknowns = np.array([*(each.item() for each in at), placement.moved[0]]) / path.system.units
    rows = path.system.evaluate(unknowns)[1][:, :-1]
    _, sizes, ways = np.linalg.svd(rows)
    free = np.ones(len(ways), dtype=bool)
    free[: len(sizes)] = sizes <= _LOOSE * sizes[0]
    return np.asarray(ways[free].sum(axis=0) * path.system.units[:-1])


def shake_motion(placement: Placement, scales: Scales) -> Motion:
    """The motion of a placement on a path of these scales, with every place and every rate moved a
    little, in no common direction: what differs much between the two is decided by last digits.
    """
    motion, units = placement.motion, placement.path.system.units[:-1]
    mechanism, size = motion.frames.mechanism, scales.length * _SHAKEN
    directions = _list_directions()
    points = {name: point + next(directions) * size for name, point in mechanism.points.items()}

    def shake(rates: Rates, usual: float) -> Rates:
        each = zip(placement.path.system.rates, units, _list_directions(), strict=False)
        return {rate: rates[rate] + way.x * _SHAKEN * usual * unit for rate, unit, way in each}

    return replace(
        motion,
        frames=replace(motion.frames, mechanism=replace(mechanism, points=points)),
        rates=shake(motion.rates, scales.rate),
        changes=shake(motion.changes, scales.change),
    )


def _list_directions() -> Iterator[Vector]:
    """Unit vectors without end, none of which has the direction of another one."""
    angle = 1.0
    while True:
        yield Vector(math.cos(angle), math.sin(angle))
        angle += 2.0
