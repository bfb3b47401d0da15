"""Rings with a slot along them: body and slot are seen, and which of two that cross is in front."""

from __future__ import annotations

from math import hypot

from kinegrade.figure.mechanism.layers import draw
from kinegrade.figure.mechanism.paper import scale_to_paper
from kinegrade.figure.scene import PITCH, Disc, Outline, Primitive
from kinegrade.figure.symbols.bars import BAR_WIDTH
from kinegrade.mechanics.joints import GROUND, Arc, Circle, Pin
from kinegrade.mechanics.mechanism import Body, Mechanism
from kinegrade.mechanics.vector import Vector
from tests.figure.mechanisms import hinted

ORIGIN = Vector(0.0, 0.0)


def rings() -> tuple[Primitive, ...]:
    """Two rings of 30 cm with a particle in both, at 100 mm per metre."""
    points = {"C": Vector(-0.2, 0.0), "D": Vector(0.2, 0.0), "M": Vector(0.0, 0.05**0.5)}
    joints = (Arc("M", "M", Circle("C", 0.3), "I"), Arc("M", "M", Circle("D", 0.3), "II"))
    bodies = (Body("I", ("C",)), Body("II", ("D",)), Body("M", ("M",), particle=True))
    mechanism, hints = hinted(Mechanism(points, bodies, joints, ()))
    return draw(scale_to_paper(mechanism, 100.0), hints).primitives


def bands() -> list[Outline]:
    """Their filled bands."""
    return [part for part in rings() if isinstance(part, Outline) and part.pen is None]


def test_of_two_rings_that_cross_the_first_lies_in_front_with_its_slot() -> None:
    assert [band.fill for band in bands()] == ["grey", "white", "grey", "white"]
    assert [min(corner.x for corner in band.corners) > -20.0 for band in bands()] == [
        True,
        True,
        False,
        False,
    ]


def test_the_edges_of_the_ring_behind_do_not_pass_over_the_one_in_front() -> None:
    drawn = rings()
    front = next(number for number, part in enumerate(drawn) if part == bands()[2])
    behind = [part for part in drawn[front:] if isinstance(part, Disc) and part.centre.x > 0]
    assert [part for part in behind if part.radius > 5.0] == []


def test_a_band_lies_along_its_circle_and_leaves_the_middle_open() -> None:
    *_, body, slot = bands()
    wide, narrow = (
        [hypot(corner.x + 20.0, corner.y) for corner in band.corners] for band in (body, slot)
    )
    assert 28.0 < min(wide) < min(narrow) < 30.0 < max(narrow) < max(wide) < 32.0


def test_a_slot_has_its_centre_line_to_which_a_mean_radius_reaches() -> None:
    middle = [part for part in rings() if isinstance(part, Disc) and part.pen == PITCH]
    assert [(part.centre.x, part.radius) for part in middle] == [(20.0, 30.0), (-20.0, 30.0)]


def test_a_ring_is_solid_about_the_pin_on_which_it_turns() -> None:
    points = {"C": ORIGIN, "A": Vector(-0.3, 0.0), "M": Vector(0.0, 0.3)}
    joints = (Pin("A", ("I", GROUND)), Arc("M", "M", Circle("C", 0.3), "I"))
    bodies = (Body("I", ("A", "C")), Body("M", ("M",), particle=True))
    mechanism, hints = hinted(Mechanism(points, bodies, joints, ()))
    primitives = draw(scale_to_paper(mechanism, 100.0), hints).primitives
    (slot,) = [
        part
        for part in primitives
        if isinstance(part, Outline) and part.fill == "white" and len(part.corners) > 4
    ]
    near = min(hypot(corner.x + 30.0, corner.y) for corner in slot.corners)
    assert BAR_WIDTH / 2 < near < 3.0
    assert [corner for corner in slot.corners if not 28.0 < hypot(*corner) < 32.0] == []
    assert max(corner.x for corner in slot.corners) > 30.0
