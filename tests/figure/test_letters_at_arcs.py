"""The letter of an angle stands at its arc, its arrowhead off other lines, and the arrow of a radius
off the sides of angles.
"""

from __future__ import annotations

from math import hypot, pi

import pytest
from msgspec.structs import replace

from kinegrade.figure.marks.angle_arc import ALONE, AngleArc, Neighbours
from kinegrade.figure.marks.angles import find_neighbours, mark_angles
from kinegrade.figure.marks.radius_arrows import RadiusFromCentre
from kinegrade.figure.marks.radius_crossings import rate_crossings
from kinegrade.figure.marks.sides import Side
from kinegrade.figure.mechanism.layers import Drawing
from kinegrade.figure.mechanism.straight_parts import SlottedDisc
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.plane import angle_of
from kinegrade.figure.scene import THIN, Bow, Label
from kinegrade.figure.symbols.bars import SLOT_WIDTH
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import Angle
from tests.figure.mechanisms import polar

ORIGIN = Vector(0.0, 0.0)
POINTS = {"O": ORIGIN, "A": polar(30.0, 60)}
PHI = Angle(r"\varphi", "O", "right", "A")
SENSED = Angle(r"\varphi", "O", "right", "A", sense="ccw")
CLOSE = 0.8  # millimetres of paper between a letter and its arc


def make_sides(first: float, last: float) -> tuple[Side, Side]:
    """Sides in two directions (degrees) along which nothing is drawn."""
    one, other = (
        Side(angle_of(polar(1.0, way)), 0.0, 0.0, broad=False, lag=0.0) for way in (first, last)
    )
    return one, other


@pytest.mark.parametrize("first", [0, 25, 30, 115, 205])
@pytest.mark.parametrize("radius", [7.0, 8.5])
def test_a_letter_stands_close_to_its_arc_in_every_direction(first: int, radius: float) -> None:
    bow = Bow(ORIGIN, radius, angle_of(polar(1.0, first)), pi / 4.5, THIN)
    layout = Layout.of(()).marked([AngleArc(bow, make_sides(first, first + 40), PHI, 0.0)])
    [label] = layout.labels
    wide = max(abs(label.centre.x) - label.width / 2, 0.0)
    high = max(abs(label.centre.y) - label.height / 2, 0.0)
    assert hypot(wide, high) - radius < CLOSE


def list_demerits(hint: Angle, near: Neighbours) -> dict[float, float]:
    """The demerit of the arc of each radius."""
    [arcs] = mark_angles(POINTS, hint, make_sides(0, 60), near)
    return {arc.bow.radius: arc.demerit for arc in arcs}


@pytest.mark.parametrize(
    "near",
    [
        Neighbours(bars=((polar(10.0, 50), polar(13.0, 60)),)),
        Neighbours(pins=(polar(12.0, 61),)),
    ],
)
def test_an_arrowhead_is_not_lost_among_other_lines(near: Neighbours) -> None:
    for hint, worse in ((PHI, False), (SENSED, True)):
        alone, crossed = list_demerits(hint, ALONE), list_demerits(hint, near)
        assert (crossed[12.0] > alone[12.0], crossed[20.0] > alone[20.0]) == (worse, False)


def test_the_edges_of_a_slot_in_a_disc_part_a_letter_from_its_arc() -> None:
    disc = SlottedDisc("disc", ORIGIN, 30.0, (Vector(10.0, -25.0), Vector(10.0, 25.0)))
    near = find_neighbours(Drawing((), (), (), (disc,), (), ()))
    beside = sorted(start.x for start, _ in near.bars)
    assert beside == pytest.approx([10.0 - SLOT_WIDTH / 2, 10.0 + SLOT_WIDTH / 2])


def test_the_arrow_of_a_radius_across_a_side_of_an_angle_is_worse() -> None:
    bow = Bow(Vector(-9.0, 6.0), 12.0, 0.0, -pi / 2, THIN)
    angle = AngleArc(bow, make_sides(0, -90), Angle(r"\psi", "O", "right", "down"), 0.0)
    ways = [polar(1.0, turn) for turn in (110, -20)]
    arrows = [RadiusFromCentre(ORIGIN, 20.0, way, "R", 0.0, (), False, ()) for way in ways]
    across, clear = rate_crossings(arrows, replace(Layout.of(()), marks=(angle,)))
    assert (across > 0, clear) == (True, 0.0)


def test_the_letter_of_a_radius_stands_at_its_arrow_however_near_that_of_the_centre() -> None:
    [start, end] = ORIGIN, Vector(0.0, 9.0)
    arrow = RadiusFromCentre(ORIGIN, 9.0, Vector(0.0, 1.0), "r_3", 0.0, (), False, ())
    centre = Label("B", Vector(1.6, 3.4), 2.4, 2.5)
    layout = replace(Layout.of((centre,)), labels=(centre,)).marked([arrow])
    at = layout.labels[-1].centre
    assert abs(at.x) < 2.6
    assert start.y < at.y < end.y
