"""The letter of a point in a wheel stands in the wheel where there is room."""

from __future__ import annotations

from math import hypot

from kinegrade.figure.joints.symbol import Rim
from kinegrade.figure.marks.names import label_bodies, label_points
from kinegrade.figure.mechanism.layers import Drawing, draw
from kinegrade.figure.mechanism.paper import scale_to_paper
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.scene import Label
from kinegrade.mechanics.joints import GROUND, Circle, Line, Pin, Roll
from kinegrade.mechanics.mechanism import Body, Mechanism
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import FigureHints
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


def test_the_name_of_a_wheel_does_not_stand_beside_another_letter() -> None:
    centre = Vector(0.0, 0.0)
    rim = Rim("W", "O", centre, 15.0, "wheel", False, centre, centre)
    mechanism = Mechanism({"O": centre}, (Body("W", ("O",)),), (), ())
    hints, drawing = FigureHints(labels={"W": "1"}), Drawing((), (), (rim,), (), (), ())
    [alone] = Layout.of(()).written(label_bodies(mechanism, hints, drawing, ())).labels
    letter = Label("O", alone.centre - Vector(4.0, 0.0), 2.5, 2.5)
    [moved] = Layout.of(()).written(label_bodies(mechanism, hints, drawing, (letter,))).labels
    assert moved.centre != alone.centre
    assert hypot(*moved.centre) < 15.0
