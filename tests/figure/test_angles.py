"""An angle is read at its arc: the letter between the sides, the ends of the arc on nothing else."""

from __future__ import annotations

from math import degrees, hypot, radians

import pytest

from kinegrade.figure.plane import angle_of
from kinegrade.figure.scene import THIN, Bow, Label, Scene
from kinegrade.figure.sketch import sketch
from kinegrade.mechanics.joints import GROUND, Pin
from kinegrade.mechanics.mechanism import Body, Mechanism
from kinegrade.mechanics.vector import Vector
from tests.figure.clear import heads
from tests.figure.mechanisms import Case, hinted, polar


def crank(angle: float, length: float = 0.2, **table: object) -> Case:
    """A crank OA at an angle in degrees, and a long rod AB that sets the scale."""
    points = {"O": Vector(0.0, 0.0), "A": polar(length, angle)}
    points["B"] = points["A"] + polar(1.0, 110)
    bodies = (Body("OA", ("O", "A")), Body("AB", ("A", "B")))
    joints = (Pin("O", (GROUND, "OA")), Pin("A", ("OA", "AB")))
    given = {"symbol": r"\varphi", "at": "O", "from": "right", "to": "A"} | table
    return hinted(Mechanism(points, bodies, joints, ()), angles=[given])


def find_arc(scene: Scene) -> Bow:
    (arc,) = [part for part in scene.primitives if isinstance(part, Bow) and part.pen == THIN]
    return arc


def find_letter(scene: Scene) -> Label:
    (letter,) = [label for label in scene.labels if label.symbol == r"\varphi"]
    return letter


@pytest.mark.parametrize("angle", [15, 25, 45, 80, 120, 170, -15, -30, -70])
def test_the_letter_of_an_angle_stands_between_its_sides(angle: float) -> None:
    scene = sketch(*crank(angle, 0.5))
    arc, letter = find_arc(scene), find_letter(scene)
    for across in (-0.5, 0.5):
        for upward in (-0.5, 0.5):
            corner = letter.centre + Vector(across * letter.width, upward * letter.height)
            assert 0 < degrees(angle_of(corner - arc.centre)) / angle < 1


@pytest.mark.parametrize("length", [0.08, 0.1, 0.12, 0.15, 0.2])
def test_an_arc_does_not_end_on_the_pin_of_its_bar(length: float) -> None:
    scene = sketch(*crank(50, length))
    arc, reach = find_arc(scene), length * scene.scale
    assert abs(reach - arc.radius) > 1.5


def test_the_head_of_a_signed_angle_is_drawn_on_a_short_arc_too() -> None:
    scene = sketch(*crank(12, 0.2, sense="ccw"))
    arc, (head,) = find_arc(scene), heads(scene)
    tip, back, _ = head.corners
    assert hypot(*(tip - arc.centre)) == pytest.approx(arc.radius)
    assert hypot(*(tip - back)) < 0.6 * arc.radius * radians(12)


@pytest.mark.parametrize("angle", [15, 20, -15])
def test_the_arc_of_a_narrow_angle_runs_where_its_letter_has_room(angle: float) -> None:
    scene = sketch(*crank(angle, 0.8))
    arc, letter = find_arc(scene), find_letter(scene)
    assert abs(hypot(*(letter.centre - arc.centre)) - arc.radius) < 3.0
