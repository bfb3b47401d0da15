"""The scale of a figure: the largest at which a drawing, whose symbols do not scale, fits its
frame.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import assert_never

from msgspec import Struct
from msgspec.structs import replace

from kinegrade.figure.joints.table import find_symbols
from kinegrade.figure.mechanism.geneva_wheels import find_geneva_wheels
from kinegrade.figure.mechanism.rims import find_rims
from kinegrade.figure.mechanism.wheels.outlines import trace_cam_outline
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.scene import FIRM, Bow, Box, Primitive, Scene, find_common_box, move
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import FigureHints

WIDTH, HEIGHT = 75.0, 55.0  # millimetres, the largest width of a figure
_ATTEMPTS = 6
# Millimetres below its limit at which a figure that was too large is aimed, as its marks move
_MARGIN = 1.2


class Room(Struct, frozen=True):
    """What a drawing may take at most, in millimetres."""

    width: float
    height: float

    def holds(self, box: Box) -> bool:
        """Whether a drawing in that box is within the room."""
        return box.width <= self.width and box.height <= self.height


FIGURE = Room(WIDTH, HEIGHT)


def fit_scene(
    compose: Callable[[float], Layout],
    scale: float,
    span: tuple[float, float],
    room: Room = FIGURE,
) -> Scene:
    """The scene that `compose` gives at the first scale, from `scale` downward, at which it is
    within the room.

    `span` is the width and height of the scaled part, in the unit that the scale (millimetres per
    unit) refers to.
    """
    for _ in range(_ATTEMPTS):
        layout = compose(scale)
        box = find_common_box(layout.primitives)
        if room.holds(box):
            break
        scale = _shrink(scale, box, span, room)
    scene = _move_to_corner(layout.primitives, box, scale)
    return replace(
        scene,
        crowded=layout.crowded,
        astray=layout.astray,
        claimed=layout.claimed,
        strain=layout.strain,
    )


def find_fitting_scale(
    trace: Callable[[float], Iterable[Primitive]],
    scale: float,
    span: tuple[float, float],
    room: Room,
) -> float:
    """The first scale, from `scale` downward, at which what `trace` gives is within the room;
    `span` as for `fit_scene`.
    """
    for _ in range(_ATTEMPTS):
        box = find_common_box(trace(scale))
        if room.holds(box):
            break
        scale = _shrink(scale, box, span, room)
    return scale


def make_scene(primitives: Iterable[Primitive], scale: float) -> Scene:
    """The primitives as a scene, translated so that nothing lies to the left of or below its
    corner.
    """
    drawn = tuple(primitives)
    return _move_to_corner(drawn, find_common_box(drawn), scale)


def _move_to_corner(primitives: Iterable[Primitive], box: Box, scale: float) -> Scene:
    """The primitives, whose bounding box is given, as a scene."""
    home = Vector(-box.left, -box.bottom)
    return Scene(
        box.width, box.height, scale, tuple([move(primitive, home) for primitive in primitives])
    )


def measure_span(
    mechanism: Mechanism, hints: FigureHints, beside: Iterable[Vector] = ()
) -> tuple[float, float]:
    """Width and height in metres of the scaled part: points, circles, profiles of cams, Geneva
    wheels, and points `beside` them.
    """
    boxes = [(point, 0.0) for point in (*mechanism.points.values(), *beside)]
    joints = find_symbols(mechanism, hints.shapes)
    for rim in find_rims(mechanism, joints, hints.circles):
        match rim.kind:
            case "cam":
                boxes += [(point, 0.0) for point in trace_cam_outline(mechanism, joints, rim)]
            case "wheel" | "gear" | "slot" | "edge":
                arc = rim.find_arc()
                path = Bow(rim.at, rim.radius, *arc, FIRM).path() if arc else ()
                boxes += [(point, 0.0) for point in path] or [(rim.at, rim.radius)]
            case _:
                assert_never(rim.kind)
    wheels = find_geneva_wheels(mechanism, joints, hints.shapes)
    boxes += [(wheel.centre, wheel.radius) for wheel in wheels]
    across = [at.x + side * radius for at, radius in boxes for side in (-1, 1)]
    upward = [at.y + side * radius for at, radius in boxes for side in (-1, 1)]
    return max(across) - min(across), max(upward) - min(upward)


def _shrink(scale: float, box: Box, span: tuple[float, float], room: Room) -> float:
    """The next scale to try, where the drawing takes that box."""
    across, upward = span
    return scale * min(
        _find_shrinkage(box.width, room.width, across * scale),
        _find_shrinkage(box.height, room.height, upward * scale),
    )


def _find_shrinkage(size: float, limit: float, scaled: float) -> float:
    """The factor that brings a size within its limit when only its scaled part shrinks."""
    if size <= limit or scaled <= 0:
        return 1.0
    return min(0.98, max(0.5, (limit - _MARGIN - (size - scaled)) / scaled))
