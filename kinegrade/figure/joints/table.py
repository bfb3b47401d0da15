"""The table of joints: one entry for each, which says what it adds to a drawing and what becomes of
its lengths on paper.

Nothing else in `figure/` knows one joint from another. Drivers have theirs in `drivers.py`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import assert_never

from kinegrade.figure.joints.belts import find_belt_symbol
from kinegrade.figure.joints.profiles import find_arc_symbol, find_mesh_symbol, find_touch_symbol
from kinegrade.figure.joints.slides import find_sleeve_symbol, find_slide_symbol
from kinegrade.figure.joints.symbol import Symbol
from kinegrade.mechanics.joints import (
    GROUND,
    Arc,
    Belt,
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


def find_symbols(mechanism: Mechanism, shapes: Mapping[str, str]) -> tuple[Symbol, ...]:
    """What each joint adds to a drawing, in the order of the joints; `shapes` are the author's
    hints by body.
    """
    return tuple(_find_symbol(mechanism, joint, shapes) for joint in mechanism.joints)


def _find_symbol(mechanism: Mechanism, joint: Joint, shapes: Mapping[str, str]) -> Symbol:
    match joint:
        case Pin(point=point, bodies=bodies):
            return Symbol(point=point, pinned=True, fixed=GROUND in bodies, turning=bodies)
        case Slide():
            return find_slide_symbol(mechanism, joint, shapes)
        case Sleeve():
            return find_sleeve_symbol(mechanism, joint)
        case Arc():
            return find_arc_symbol(mechanism, joint)
        case Contact() | Roll():
            return find_touch_symbol(mechanism, joint, shapes)
        case Mesh():
            return find_mesh_symbol(mechanism, joint)
        case Belt():
            return find_belt_symbol(mechanism, joint)
        case Parallel(body=body, of=of):
            return Symbol(translating=body if of == GROUND else None)
        case _:
            assert_never(joint)


def scale_joint(joint: Joint, scale: float) -> Joint:
    """The joint with its lengths multiplied by `scale`; directions stay."""
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
        case Mesh() | Belt():
            on = _scale_circle(joint.on, scale)
            return replace(joint, circle=_scale_circle(joint.circle, scale), on=on)
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
