"""From metres to millimetres on paper: one factor for both axes, so that a figure is to scale."""

from __future__ import annotations

from dataclasses import replace

from kinegrade.figure.joints.table import scale_joint
from kinegrade.mechanics.mechanism import Mechanism


def scale_to_paper(mechanism: Mechanism, scale: float) -> Mechanism:
    """The same mechanism with every length multiplied by `scale` (millimetres per metre)."""
    return replace(
        mechanism,
        points={name: point * scale for name, point in mechanism.points.items()},
        joints=tuple(scale_joint(joint, scale) for joint in mechanism.joints),
    )
