"""Ring-shaped slots that cross are told apart."""

from __future__ import annotations

from math import hypot

from kinegrade.figure.mechanism.layers import draw
from kinegrade.figure.mechanism.paper import scale_to_paper
from kinegrade.figure.scene import Outline
from kinegrade.mechanics.joints import Arc, Circle
from kinegrade.mechanics.mechanism import Body, Mechanism
from kinegrade.mechanics.vector import Vector
from tests.figure.mechanisms import hinted


def bands() -> list[Outline]:
    """The filled bands of two rings of 30 cm with a particle in both, at 100 mm per metre."""
    points = {"C": Vector(-0.2, 0.0), "D": Vector(0.2, 0.0), "M": Vector(0.0, 0.05**0.5)}
    joints = (Arc("M", "M", Circle("C", 0.3), "I"), Arc("M", "M", Circle("D", 0.3), "II"))
    bodies = (Body("I", ("C",)), Body("II", ("D",)), Body("M", ("M",), particle=True))
    mechanism, hints = hinted(Mechanism(points, bodies, joints, ()))
    primitives = draw(scale_to_paper(mechanism, 100.0), hints).primitives
    return [part for part in primitives if isinstance(part, Outline) and part.pen is None]


def test_of_two_crossing_slots_one_is_grey_and_the_other_covers_it() -> None:
    assert [band.fill for band in bands()] == ["grey", "white"]


def test_a_band_lies_along_its_circle_and_leaves_the_middle_open() -> None:
    first, _ = bands()
    radii = [hypot(corner.x + 20.0, corner.y) for corner in first.corners]
    assert 28.5 < min(radii) < 30.0 < max(radii) < 31.5
