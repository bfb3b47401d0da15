"""A body with a slot is a bar, unless its slot is beside its only point or its shape is a disc."""

from __future__ import annotations

from math import degrees, hypot

import pytest

from kinegrade.figure.mechanism.layers import Drawing, draw
from kinegrade.figure.mechanism.paper import scale_to_paper
from kinegrade.figure.mechanism.straight_parts import Bar, SlottedDisc
from kinegrade.figure.plane import angle_of
from kinegrade.figure.scene import Disc, Outline
from kinegrade.mechanics.joints import GROUND, Line, Pin, Slide
from kinegrade.mechanics.mechanism import Body, Mechanism
from kinegrade.mechanics.vector import Vector
from tests.figure.mechanisms import hinted, polar

CENTRE, PIN = Vector(0.0, 0.0), polar(0.2, 160)


def slotted_wheel(**shapes: str) -> Drawing:
    """A wheel about C with a slot along CA, in which a pin slides, at 100 mm per metre."""
    joints = (Pin("C", ("wheel", GROUND)), Slide("A", "M", Line(CENTRE, PIN), "wheel"))
    bodies = (Body("wheel", ("C",)), Body("M", ("A",), particle=True))
    mechanism = Mechanism({"C": CENTRE, "A": PIN}, bodies, joints, ())
    drawn, hints = hinted(mechanism, shapes=shapes)
    return draw(scale_to_paper(drawn, 100.0), hints)


def test_a_slot_through_the_pivot_is_that_of_a_bar_unless_the_author_wants_a_disc() -> None:
    (bar,) = slotted_wheel().parts
    (disc,) = slotted_wheel(wheel="disc").parts
    assert isinstance(bar, Bar)
    assert isinstance(disc, SlottedDisc)
    start, end = (point.dot(PIN) / 0.2 for point in disc.slot)
    assert 0 < start < 20.0 < end < disc.radius
    assert any(
        isinstance(part, Disc) and part.radius == disc.radius
        for part in slotted_wheel(wheel="disc").primitives
    )


def find_geneva() -> Outline:
    outlines = [
        part for part in slotted_wheel(wheel="geneva").primitives if isinstance(part, Outline)
    ]
    return max(outlines, key=lambda part: len(part.corners))


def test_a_geneva_wheel_has_four_open_slots_and_its_pin_in_one() -> None:
    wheel = find_geneva()
    ends = [angle_of(corner) for corner in wheel.corners if hypot(*corner) < 3.0]
    quarters = {round((degrees(end) - 160) / 90) % 4 for end in ends}
    assert quarters == {0, 1, 2, 3}
    edge = [abs(corner.cross(PIN)) / 0.2 for corner in wheel.corners if corner.dot(PIN) / 0.2 > 20]
    assert min(edge) == pytest.approx(0.95)


def test_between_its_slots_a_geneva_wheel_is_hollow() -> None:
    wheel = find_geneva()
    between = [corner for corner in wheel.corners if corner.dot(polar(1.0, 205)) > 9.0]
    nearest = min(between, key=lambda corner: abs(corner.cross(polar(1.0, 205))))
    assert hypot(*nearest) < 0.65 * max(hypot(*corner) for corner in wheel.corners)
