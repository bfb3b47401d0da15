"""A slider whose motion is given, what shuts it in, and the arrows that are drawn there."""

from __future__ import annotations

from dataclasses import replace

from kinegrade.figure.marks.straight.arrow_places import Site
from kinegrade.figure.marks.straight.motions import add_motions
from kinegrade.figure.mechanism.paper import scale_to_paper
from kinegrade.figure.mechanism.rails import Rail
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.scene import BOLD, FIRM, Strokes
from kinegrade.mechanics.drivers import Component
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import Moving
from tests.figure.mechanisms import slider_crank

RIGHT, UP = Vector(1.0, 0.0), Vector(0.0, 1.0)
BOTH = Moving("v", "B"), Moving("a", "B", None, "acceleration")


def slider(velocity: float, acceleration: float) -> Mechanism:
    """A slider-crank in millimetres, its slider moved to the right."""
    mechanism, _ = slider_crank(0.2, 1.75, 60)
    drivers = (Component("B", "B", RIGHT, velocity, acceleration),)
    return scale_to_paper(replace(mechanism, drivers=drivers), 100.0)


def shut_in(at: Vector) -> Layout:
    """Walls in front of a point and behind it, far ahead as well."""
    sides = [at + RIGHT * aside for each in (5.0, 9.0, 13.0, 17.0) for aside in (each, -each)]
    up = Vector(0.0, 2.0)
    return Layout.of([Strokes(tuple((side - up, side + up) for side in sides), BOLD)])


def place(layout: Layout, mechanism: Mechanism, *hints: Moving) -> list[tuple[Vector, Vector]]:
    """The arrows, each from its start to its end."""
    layout = add_motions(layout, Site(mechanism), hints)
    return [mark.path()[0] for mark in layout.marks]


def lay_floor(at: Vector) -> Rail:
    level = at - Vector(0.0, 1.7)
    return Rail(at, RIGHT, Vector(0.0, -1.0), level - RIGHT * 8, level + RIGHT * 8, 1.7, None)


def list_shafts(layout: Layout) -> list[tuple[Vector, Vector]]:
    """The shafts of the arrows of a layout as they are drawn."""
    firm = (part for part in layout.lines if isinstance(part, Strokes) and part.pen == FIRM)
    return [line for part in firm for line in part.lines]
