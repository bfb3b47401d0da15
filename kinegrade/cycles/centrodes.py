"""The velocity poles of bodies over a cycle, and the curves that they describe: the fixed centrode
in the plane, the moving one in the body.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from kinegrade.mechanics.mechanism import Body
from kinegrade.mechanics.rates import make_turning
from kinegrade.mechanics.vector import Vector
from kinegrade.motion.path import Array, MotionPath, Placement

_TRIED = 49  # positions that show whether a body has a pole that moves
_STILL = 1e-6  # of the mechanism's size, or of what its points do


@dataclass(frozen=True, eq=False)
class Centrodes:
    """Where the velocity pole of a body is at each position, rows of x and y in m: `fixed` in the
    plane, `moving` the place of the body that is there, given by where that is at the instant. Not
    finite where the body does not turn.
    """

    body: str
    fixed: Array
    moving: Array


def list_unpinned_bodies(path: MotionPath) -> tuple[Body, ...]:
    """The bodies that may turn, and about no fixed pin."""
    mechanism, rates = path.motion.frames.mechanism, path.system.rates
    pivots = mechanism.find_pivots()
    return tuple(
        body
        for body in mechanism.bodies
        if body.name not in pivots and make_turning(body.name) in rates
    )


def find_poled_bodies(path: MotionPath) -> tuple[str, ...]:
    """The bodies whose velocity poles move: those that turn, and about no place that stays."""
    placement = path.place(path.spread(_TRIED)[1:-1])
    return tuple(
        body.name
        for body in list_unpinned_bodies(path)
        if _moves(_trace_fixed(placement, body.name), path.size)
    )


def trace_centrodes(placement: Placement, bodies: Sequence[str]) -> tuple[Centrodes, ...]:
    """The centrodes of these bodies, by the engine's velocities."""
    return tuple(
        Centrodes(body, fixed, _carry_back(placement, body, fixed))
        for body in bodies
        for fixed in (_trace_fixed(placement, body),)
    )


def _moves(poles: Array, size: float) -> bool:
    """Whether a body turns, and its poles do not stay."""
    known = poles[:, np.isfinite(poles).all(axis=0)]
    return bool(known.size) and float(np.ptp(known, axis=1).max()) > _STILL * size


def _trace_fixed(placement: Placement, body: str) -> Array:
    """The poles of a body in the plane."""
    motion, shape = placement.motion, placement.moved.shape
    base = motion.frames.bases[body].point
    rate = np.broadcast_to(np.asarray(motion.omega(body), dtype=float), shape)
    velocity, point = motion.velocity(base, body), motion.points[base]
    speed = np.broadcast_to(np.hypot(velocity.x, velocity.y), shape)
    with np.errstate(all="ignore"):
        turns = np.abs(rate) * placement.path.size > _STILL * speed
        poles = point + velocity.turned() / np.where(turns, rate, np.nan)
    return np.array([np.broadcast_to(part, shape) for part in poles])


def _carry_back(placement: Placement, body: str, poles: Array) -> Array:
    """The places of a body that are at these ones, by where they are at the instant."""
    base = placement.motion.frames.bases[body].point
    start, now = placement.path.motion.points[base], placement.motion.points[base]
    angle = np.asarray(placement.at.coordinates[make_turning(body)])
    arm = Vector(poles[0] - now.x, poles[1] - now.y)
    cos, sin = np.cos(angle), np.sin(angle)
    return np.array([start.x + cos * arm.x + sin * arm.y, start.y - sin * arm.x + cos * arm.y])
