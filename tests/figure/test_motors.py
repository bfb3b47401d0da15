"""A motor turns one moving body against another, and is drawn at their pin."""

from __future__ import annotations

from kinegrade.figure.scene import Disc
from kinegrade.figure.sketch import sketch
from kinegrade.mechanics.drivers import Rotation
from kinegrade.mechanics.joints import GROUND, Line, Pin, Slide
from kinegrade.mechanics.mechanism import Body, Mechanism
from kinegrade.mechanics.vector import Vector
from tests.figure.mechanisms import RIGHT, hinted

ORIGIN = Vector(0.0, 0.0)


def housings(driver: Rotation, *arrows: dict[str, str]) -> list[Vector]:
    """The centres of the motors of a slider-crank, in metres from O."""
    points = {"O": ORIGIN, "A": Vector(0.2, 0.2), "B": Vector(0.7, 0.0)}
    joints = (
        Pin("O", ("OA", GROUND)),
        Pin("A", ("OA", "AB")),
        Slide("B", "AB", Line(ORIGIN, RIGHT), GROUND),
    )
    bodies = (Body("OA", ("O", "A")), Body("AB", ("A", "B")))
    mechanism, hints = hinted(Mechanism(points, bodies, joints, (driver,)), arrows=list(arrows))
    scene = sketch(mechanism, hints)
    discs = [part for part in scene.primitives if isinstance(part, Disc)]
    first = min((disc.centre for disc in discs), key=lambda centre: centre.x)
    found = [disc.centre - first for disc in discs if disc.fill == "grey"]
    return [Vector(round(at.x / scene.scale, 6), round(at.y / scene.scale, 6)) for at in found]


def test_a_motor_is_at_the_pin_of_the_bodies_that_it_turns() -> None:
    assert housings(Rotation("AB", 1.0, 0.0, "OA")) == [Vector(0.2, 0.2)]


def test_it_is_there_as_well_where_an_arrow_has_its_own_sense() -> None:
    arrow = {"symbol": r"\omega", "turns": "AB", "sense": "ccw"}
    assert housings(Rotation("AB", 1.0, 0.0, "OA"), arrow) == [Vector(0.2, 0.2)]


def test_a_crank_that_turns_on_the_ground_has_no_motor() -> None:
    assert housings(Rotation("OA", 1.0, 0.0)) == []
