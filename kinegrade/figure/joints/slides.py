"""What sliding joints look like: a block in a slot or on a ground guide, a sleeve about a bar, a
rod in a guide.
"""

from __future__ import annotations

from collections.abc import Mapping

from kinegrade.figure.joints.ropes import is_rope
from kinegrade.figure.joints.symbol import Feature, Guide, Symbol, is_particle
from kinegrade.figure.plane import on_line, unit
from kinegrade.mechanics.joints import GROUND, Line, Sleeve, Slide
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector


def find_slide_symbol(mechanism: Mechanism, joint: Slide, shapes: Mapping[str, str]) -> Symbol:
    """A pin on a ground guide, in a sleeve about a bar, or in the slot of a bar.

    The bar runs in a sleeve where the ground holds its point, or where its shape is "bar". A
    particle, and what drives a Geneva wheel, is a pin without a block. What hangs on a rope has no
    guide.
    """
    at, along = mechanism.points[joint.point], unit(joint.line.direction)
    if joint.of == GROUND and is_rope(shapes, joint.body):
        return Symbol(point=joint.point)
    if joint.of == GROUND:
        bare = shapes.get(joint.body) == "bare"
        return Symbol(point=joint.point, pinned=not bare, guide=Guide(joint.body, at, along))
    held = joint.body == GROUND
    in_sleeve = held or shapes.get(joint.of) == "bar"
    path = Line(at, along)
    without_block = shapes.get(joint.of) in ("bare", "geneva")
    bare = in_sleeve or without_block or is_particle(mechanism, joint.body)
    return Symbol(
        point=joint.point,
        pinned=True,
        fixed=held,
        features=(Feature(joint.of, joint.line, at, "bar" if in_sleeve else "slot"),),
        sleeve=path if in_sleeve else None,
        block=None if bare else path,
    )


def find_sleeve_symbol(mechanism: Mechanism, joint: Sleeve) -> Symbol:
    """A rod in a guide of the ground, or a sleeve about a bar."""
    bar, carrier = _tell_bar_from_carrier(mechanism, joint)
    at, along = _find_sleeve_centre(mechanism, joint, carrier, bar), unit(joint.line.direction)
    if joint.of == GROUND:
        return Symbol(translating=joint.body, guide=Guide(joint.body, at, along))
    edge = Feature(bar, joint.line, at, "bar")
    return Symbol(features=(edge,), sleeve=Line(at, along), carrier=carrier)


def _tell_bar_from_carrier(mechanism: Mechanism, joint: Sleeve) -> tuple[str, str]:
    """Of two bodies sliding in each other, the bar and the sleeve: the bar is the one with more
    points on the line.
    """
    on_body = len(_list_points_on_line(mechanism, joint.body, joint.line))
    on_other = len(_list_points_on_line(mechanism, joint.of, joint.line))
    return (joint.of, joint.body) if on_other > on_body else (joint.body, joint.of)


def _find_sleeve_centre(mechanism: Mechanism, joint: Sleeve, carrier: str, bar: str) -> Vector:
    """Where a sleeve is drawn: at its carrier's point on the line, else at the bar's."""
    for body in (carrier, bar):
        for at in _list_points_on_line(mechanism, body, joint.line):
            return at
    return joint.line.point


def _list_points_on_line(mechanism: Mechanism, body: str, line: Line) -> list[Vector]:
    """The marked points of a body that lie on a line; the ground has none."""
    names = () if body == GROUND else mechanism.body(body).points
    places = (mechanism.points[name] for name in names)
    return [at for at in places if on_line(at, line)]
