"""A body with a slot is a bar, unless its slot is beside the only point about which it turns or its
shape is a disc.
"""

from __future__ import annotations

from math import hypot, pi, sin

import pytest

from kinegrade.errors import TemplateError
from kinegrade.figure.mechanism.layers import Drawing, draw
from kinegrade.figure.mechanism.paper import scale_to_paper
from kinegrade.figure.mechanism.straight_parts import Bar, Rod, SlottedDisc
from kinegrade.figure.plane import angle_of
from kinegrade.figure.scene import Disc, Outline
from kinegrade.figure.sketch import sketch
from kinegrade.figure.symbols.pins import PIN as PIN_RADIUS
from kinegrade.mechanics.joints import GROUND, Line, Parallel, Pin, Slide
from kinegrade.mechanics.mechanism import Body, Mechanism
from kinegrade.mechanics.vector import Vector
from tests.figure.mechanisms import Case, hinted, polar

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
    primitives = slotted_wheel(wheel="disc").primitives
    assert disc.radius in [part.radius for part in primitives if isinstance(part, Disc)]


def make_drive(degrees: float, turning: str = "O", slots: int = 4) -> Case:
    """A Geneva wheel about C, 0.2 m from the pivot of its crank OP, which is at an angle to OC."""
    pin = polar(0.2 * sin(pi / slots), degrees)
    at = {"O": CENTRE, "C": Vector(0.2, 0.0), "P": pin}
    joints = (
        Pin("O", ("crank", turning)),
        Pin("C", ("wheel", GROUND)),
        Slide("P", "crank", Line(at["C"], pin - at["C"]), "wheel"),
    )
    bodies = (Body("crank", ("O", "P")), Body("wheel", ("C",)))
    return hinted(Mechanism(at, bodies, joints, ()), shapes={"wheel": "geneva"})


def draw_drive(degrees: float) -> Drawing:
    """Such a drive at 100 mm per metre."""
    mechanism, hints = make_drive(degrees, GROUND)
    return draw(scale_to_paper(mechanism, 100.0), hints)


def trace_geneva(degrees: float) -> list[Vector]:
    """The outline of the wheel of a drive about its centre."""
    outlines = [part for part in draw_drive(degrees).primitives if isinstance(part, Outline)]
    wheel = max(outlines, key=lambda part: len(part.corners))
    return [corner - Vector(20.0, 0.0) for corner in wheel.corners]


def find_slot(degrees: float) -> Vector:
    """The unit vector from the centre of the wheel to the pin."""
    slot = polar(10.0 * 2**0.5, degrees) - Vector(20.0, 0.0)
    return slot / hypot(*slot)


@pytest.mark.parametrize("degrees", [-40, 10, 25])
def test_the_pin_enters_a_geneva_wheel_along_a_slot(degrees: float) -> None:
    slot = find_slot(degrees)
    sides = [corner for corner in trace_geneva(degrees) if 0.9 < abs(corner.cross(slot)) < 1.0]
    where_crank_and_slot_are_square = (20.0**2 - 200.0) ** 0.5
    ahead = [corner.dot(slot) for corner in sides]
    assert max(ahead) == pytest.approx(where_crank_and_slot_are_square)


@pytest.mark.parametrize("degrees", [-40, 10])
def test_a_geneva_wheel_has_four_slots_as_deep_as_its_pin_comes(degrees: float) -> None:
    wheel, deepest = trace_geneva(degrees), 20.0 - 10.0 * 2**0.5
    ends = [angle_of(corner) for corner in wheel if hypot(*corner) < deepest - PIN_RADIUS]
    turn = angle_of(find_slot(degrees))
    assert {round((end - turn) / (pi / 2)) % 4 for end in ends} == {0, 1, 2, 3}


@pytest.mark.parametrize("slots", [3, 5, 6, 8])
def test_a_geneva_wheel_has_the_slots_that_its_crank_drives_it_by(slots: int) -> None:
    mechanism, hints = make_drive(10, GROUND, slots)
    outlines = draw(scale_to_paper(mechanism, 100.0), hints).primitives
    wheel = max((p for p in outlines if isinstance(p, Outline)), key=lambda p: len(p.corners))
    centre, deepest = Vector(20.0, 0.0), 20.0 * (1 - sin(pi / slots))
    turn = angle_of(scale_to_paper(mechanism, 100.0).points["P"] - centre)
    ends = [
        angle_of(corner - centre)
        for corner in wheel.corners
        if hypot(*(corner - centre)) < deepest - PIN_RADIUS
    ]
    step = 2 * pi / slots
    assert {round((end - turn) / step) % slots for end in ends} == set(range(slots))


def test_the_hollows_of_a_geneva_wheel_fit_a_disc_about_the_pivot_of_its_crank() -> None:
    wheel, slot = trace_geneva(10), find_slot(10)
    pivot = (slot + slot.turned()) * (20.0 / 2**0.5)
    between = [corner for corner in wheel if corner.dot(slot) > 3.0 and corner.cross(slot) < -3.0]
    away = [hypot(*(corner - pivot)) for corner in between]
    assert len(away) > 8
    assert max(away) == pytest.approx(min(away))


def test_the_pin_of_a_geneva_drive_is_no_block() -> None:
    blocks = [
        part
        for part in draw_drive(25).primitives
        if isinstance(part, Outline) and len(part.corners) == 4
    ]
    assert blocks == []


@pytest.mark.parametrize("degrees", [-40, 10])
def test_the_figure_of_a_geneva_drive_uses_the_paper_in_all_postures(degrees: float) -> None:
    assert sketch(*make_drive(degrees, GROUND)).height > 45.0


def test_a_geneva_wheel_without_a_crank_on_the_ground_is_refused() -> None:
    with pytest.raises(TemplateError) as refused:
        sketch(*make_drive(25, "wheel"))
    assert str(refused.value) == (
        "figure.shapes.wheel: no crank with a fixed pin drives this Geneva wheel, whose slots"
        ' depend on it; give the crank a fixed pin, or write the shape "disc"'
    )


def draw_ram(*pinned: Pin) -> Drawing:
    """A ram with an upright slot in which B slides, beside its only point E, at 100 mm per
    metre.
    """
    at = {"C": CENTRE, "B": Vector(0.3, 0.2), "E": Vector(0.5, 0.3)}
    joints = (
        Pin("C", ("lever", GROUND)),
        Slide("B", "lever", Line(at["B"], Vector(0.0, 1.0)), "ram"),
        *(pinned or (Slide("E", "ram", Line(at["E"], Vector(1.0, 0.0)), GROUND),)),
        *(() if pinned else (Parallel("ram", GROUND),)),
    )
    bodies = (Body("lever", ("C", "B")), Body("ram", ("E",)))
    mechanism, hints = hinted(Mechanism(at, bodies, joints, ()))
    return draw(scale_to_paper(mechanism, 100.0), hints)


def test_a_body_that_only_translates_is_no_disc_but_a_slotted_bar_with_an_arm() -> None:
    slotted, arm, rod = (part for part in draw_ram().parts if part.body == "ram")
    assert isinstance(slotted, Bar)
    assert isinstance(arm, Bar)
    assert isinstance(rod, Rod)
    assert (slotted.start.x, slotted.end.x) == pytest.approx((30.0, 30.0))
    assert (arm.start.x, arm.start.y, arm.end.x, arm.end.y) == pytest.approx((30, 30, 50, 30))
    assert slotted.start.y < 20.0
    assert slotted.end.y >= 30.0


def test_a_body_that_turns_about_its_point_is_a_disc() -> None:
    (disc,) = (part for part in draw_ram(Pin("E", ("ram", GROUND))).parts if part.body == "ram")
    assert isinstance(disc, SlottedDisc)
