"""From metres to millimetres on paper: one factor for both axes, so that a figure is to scale."""

from __future__ import annotations

from dataclasses import replace
from typing import assert_never

from kinegrade.mechanics.joints import (
    Arc,
    Circle,
    Contact,
    Joint,
    Line,
    Mesh,
    Parallel,
    Pin,
    Roll,
    Sleeve,
    Slide,
)
from kinegrade.mechanics.mechanism import Mechanism


def scale_to_paper(mechanism: Mechanism, scale: float) -> Mechanism:
    """The same mechanism with every length multiplied by `scale` (millimetres per metre)."""
    points = {name: point * scale for name, point in mechanism.points.items()}
    return replace(
        mechanism,
        points=points,
        joints=tuple(_scale_joint(joint, scale) for joint in mechanism.joints),
    )


def _scale_joint(joint: Joint, scale: float) -> Joint:
    match joint:
        case Pin() | Parallel():
            return joint
        case Slide() | Sleeve():
            return replace(joint, line=_scale_line(joint.line, scale))
        case Arc():
            return replace(joint, circle=_scale_circle(joint.circle, scale))
        case Contact() | Roll():
            on = _scale_shape(joint.on, scale)
            return replace(joint, circle=_scale_circle(joint.circle, scale), on=on)
        case Mesh():
            return replace(
                joint, circle=_scale_circle(joint.circle, scale), on=_scale_circle(joint.on, scale)
            )
        case _:
            assert_never(joint)


def _scale_shape(shape: Line | Circle, scale: float) -> Line | Circle:
    match shape:
        case Line():
            return _scale_line(shape, scale)
        case Circle():
            return _scale_circle(shape, scale)
        case _:
            assert_never(shape)


def _scale_line(line: Line, scale: float) -> Line:
    return Line(line.point * scale, line.direction)


def _scale_circle(circle: Circle, scale: float) -> Circle:
    return Circle(circle.centre, circle.radius * scale)
