"""Where the rotation of a body is marked: at its pivot, or at the pin of two bodies."""

from __future__ import annotations

from kinegrade.figure.joints.symbol import find_fixed_pin
from kinegrade.figure.mechanism.layers import Drawing
from kinegrade.figure.plane import mean
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import Turning


def find_turning_centre(mechanism: Mechanism, hint: Turning, drawing: Drawing) -> Vector:
    """Where a rotation is marked."""
    if hint.of == GROUND:
        return _find_pivot(mechanism, hint.body, drawing)
    return _find_common_point(mechanism, hint)


def _find_common_point(mechanism: Mechanism, hint: Turning) -> Vector:
    """Where a body is pinned to the one it turns relative to; the mean of its points when it is
    not.
    """
    points, others = mechanism.body(hint.body).points, mechanism.body(hint.of).points
    common = [name for name in points if name in others]
    return mean(mechanism.points[name] for name in common or points)


def _find_pivot(mechanism: Mechanism, body: str, drawing: Drawing) -> Vector:
    """Where a body's rotation is marked: its fixed pin, else its circle's centre, else the mean of
    its points.
    """
    pin = find_fixed_pin(drawing.symbols, body)
    if pin is not None:
        return mechanism.points[pin]
    for rim in drawing.rims:
        if rim.body == body:
            return rim.at
    return mean(mechanism.points[name] for name in mechanism.body(body).points)
