"""A motor turns one moving body against another, and is drawn at their pin."""

from __future__ import annotations

import pytest

from kinegrade.figure.mechanism.layers import draw
from kinegrade.figure.mechanism.paper import scale_to_paper
from kinegrade.figure.scene import BOLD, Disc, Outline, Strokes
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


def test_both_bars_run_over_the_motor_whose_light_neck_lies_on_the_one_that_carries_it() -> None:
    points = {"O": ORIGIN, "A": Vector(0.3, 0.0), "B": Vector(0.3, 0.3)}
    bodies = (Body("OA", ("O", "A")), Body("AB", ("A", "B")))
    joints = (Pin("O", ("OA", GROUND)), Pin("A", ("OA", "AB")))
    driver = Rotation("AB", 1.0, 0.0, "OA")
    mechanism, hints = hinted(Mechanism(points, bodies, joints, (driver,)))
    drawn = draw(scale_to_paper(mechanism, 100.0), hints).primitives
    (housing,) = (part for part in drawn if isinstance(part, Disc) and part.fill == "grey")
    (neck,) = (part for part in drawn if isinstance(part, Outline) and part.fill == "grey")
    bars = [part for part in drawn if isinstance(part, Strokes) and part.pen == BOLD]
    assert not [part for part in drawn if isinstance(part, Outline) and part.fill == "black"]
    left = min(corner.x for corner in neck.corners)
    assert left < housing.centre.x - housing.radius - 2.0
    assert [corner.y for corner in neck.corners if corner.x < 27.0] == [pytest.approx(0.0)]
    assert drawn.index(neck) < drawn.index(housing)
    assert len(bars) == 2
    assert [bar for bar in bars if not drawn.index(housing) < drawn.index(bar)] == []
