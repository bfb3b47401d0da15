"""The letter of a point in a wheel stands in the wheel where there is room."""

from __future__ import annotations

from math import hypot

from kinegrade.figure.marks.names import label_points
from kinegrade.figure.mechanism.layers import draw
from kinegrade.figure.mechanism.paper import scale_to_paper
from kinegrade.mechanics.joints import GROUND, Circle, Line, Pin, Roll
from kinegrade.mechanics.mechanism import Body, Mechanism
from kinegrade.mechanics.vector import Vector
from tests.figure.mechanisms import RIGHT, hinted, polar

RADIUS = 8.0  # millimetres


def test_the_letter_of_an_eccentric_pivot_is_tried_within_its_disc_first() -> None:
    joints = (
        Pin("O", ("W", GROUND)),
        Roll("W", Circle("B", 1.0), GROUND, Line(Vector(0.0, -1.0), RIGHT)),
    )
    points = {"O": polar(0.5, 200), "B": Vector(0.0, 0.0)}
    mechanism, hints = hinted(Mechanism(points, (Body("W", ("O", "B")),), joints, ()))
    paper = scale_to_paper(mechanism, RADIUS)
    [wish] = [wish for wish in label_points(paper, hints, draw(paper, hints)) if wish.symbol == "O"]
    within = [hypot(*spot) < RADIUS for spot in wish.spots.tolist()]
    assert within[0]
    assert not within[-1]
    assert within == sorted(within, reverse=True)
