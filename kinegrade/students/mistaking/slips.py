"""Slips: what remains of a mechanism's terms for a student who makes a known mistake.

A slip is a transformation of terms: each number of a `Slips` is the share that remains of
something, 1 if correct and 0 if forgotten. Shares may be arrays, one entry for each way to go
wrong, so that one run of the plan gives the results of many mistakes. `mistaken_reading` takes the
terms with them, `mistaken` runs the plan.
"""

from __future__ import annotations

from dataclasses import dataclass

from kinegrade.mechanics.shares import Shares
from kinegrade.numbers.number import Number

Share = Number  # or an array of them with an entry for each way to go wrong


@dataclass(frozen=True)
class Slips:
    """What remains of a mechanism's terms: 1 is right, 0 forgotten, -1 reversed.

    - coriolis: each Coriolis acceleration.
    - frame_rate: the moving frame's angular velocity within a Coriolis acceleration; 0 takes that
      of the body that moves in it.
    - relative_normal: the normal part of the acceleration of a point relative to a base point.
    - path_normal: the normal part on a circular path, about a fixed pin or along an arc.
    - square: omega^2 within normal parts; 0 takes omega.
    - tangential: the tangential part that an angular acceleration already known adds.
    - meshing: the sense of a meshing or rolling on a circle: -1 takes inside for outside.
    - crossing: the sense in which a belt's pulleys turn: -1 takes open for crossed.
    - carried: the carrier's turning within a relative angular velocity; 0 takes relative for
      absolute.
    - asked_relative: the second body's turning where a relative angular velocity is asked for.
    - arm: the radius of the carried wheel within the arm r1 + r2.
    - ratio: the ratio of two radii that touch or share a belt; 0 takes its inverse.
    - pole: 0 takes a fixed pivot for the velocity pole.
    - neighbour: 0 takes for a rod's angular velocity that of the body to which it is pinned.
    - far_end: 0 takes a rod's other end for its pole.
    - far_pivot: 0 takes the pivot of the body at a rod's other end for its pole.
    - rotation: the rotation of a rod; 0 takes it to translate.
    - across: the lines across the velocities of a rod's ends, which meet in its pole; 0 takes those
      along them.
    - centre: the centre's velocity within that of other points of a rolling body.
    - own_transport: the transport motion within the absolute motion of a point that two moving
      bodies guide; 0 takes that of the other one.
    - vector_sum: 0 takes the sum of the magnitudes of a motion's terms for its magnitude.
    - relative: the relative velocity within an absolute one; 0 takes the transport velocity for
      it.
    """

    coriolis: Share = 1
    frame_rate: Share = 1
    relative_normal: Share = 1
    path_normal: Share = 1
    square: Share = 1
    tangential: Share = 1
    meshing: Share = 1
    crossing: Share = 1
    carried: Share = 1
    asked_relative: Share = 1
    arm: Share = 1
    ratio: Share = 1
    pole: Share = 1
    neighbour: Share = 1
    far_end: Share = 1
    far_pivot: Share = 1
    rotation: Share = 1
    across: Share = 1
    centre: Share = 1
    own_transport: Share = 1
    vector_sum: Share = 1
    relative: Share = 1

    def select_shares(self) -> Shares:
        """Those of the parts of laws."""
        return Shares(self.meshing, self.crossing, self.carried, self.arm, self.ratio)

    def share_rods(self) -> Share:
        """What remains of rods whose rates are found as they should be."""
        return self.neighbour * self.far_end * self.far_pivot * self.rotation * self.across


def is_right(share: Share) -> bool:
    """Whether a share is 1, in all ways to go wrong."""
    return isinstance(share, int) and share == 1
