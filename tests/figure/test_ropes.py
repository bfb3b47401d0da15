"""A rope is thin, leaves its wheel along the tangent, and ends at its load or at another wheel."""

from __future__ import annotations

from math import hypot

import pytest

from kinegrade.figure.mechanism.layers import Drawing, draw
from kinegrade.figure.mechanism.paper import scale_to_paper
from kinegrade.figure.scene import BOLD, THIN, Outline, Strokes
from kinegrade.mechanics.joints import GROUND, Circle, Line, Parallel, Pin, Roll, Slide
from kinegrade.mechanics.mechanism import Body, Mechanism
from kinegrade.mechanics.vector import Vector
from tests.figure.mechanisms import RIGHT, UP, hinted

DRUM, LEFT_DRUM = Vector(0.0, 0.0), Vector(-0.4, 0.1)
TOUCH, LOWEST = Vector(0.1, 0.0), Vector(0.1, -0.3)


def hoist(shape: str) -> Drawing:
    """A drum of 10 cm with a rope on its right, at 100 mm per metre."""
    joints = (
        Pin("O", ("drum", GROUND)),
        Parallel("weight", GROUND),
        Slide("A", "weight", Line(LOWEST, UP), GROUND),
        Roll("drum", Circle("O", 0.1), "weight", Line(TOUCH, UP)),
    )
    bodies = (Body("drum", ("O",)), Body("weight", ("A",)))
    mechanism = Mechanism({"O": DRUM, "A": LOWEST}, bodies, joints, ())
    drawn, hints = hinted(mechanism, shapes={"weight": shape})
    return draw(scale_to_paper(drawn, 100.0), hints)


def ropes(drawing: Drawing) -> list[Strokes]:
    return [
        part
        for part in drawing.primitives
        if isinstance(part, Strokes) and part.lines == ((TOUCH * 100.0, LOWEST * 100.0),)
    ]


def squares(drawing: Drawing) -> list[Outline]:
    return [
        part
        for part in drawing.primitives
        if isinstance(part, Outline) and len(part.corners) == 4 and part.fill == "grey"
    ]


@pytest.mark.parametrize("shape", ["rope", "load"])
def test_a_rope_runs_from_the_tangent_point_to_its_end_and_needs_no_guide(shape: str) -> None:
    drawing = hoist(shape)
    assert [rope.pen for rope in ropes(drawing)] == [THIN]
    assert drawing.parts == ()
    assert [
        part for part in drawing.primitives if isinstance(part, Strokes) and part.pen == BOLD
    ] == []


def test_a_load_hangs_below_the_end_of_its_rope() -> None:
    assert squares(hoist("rope")) == []
    (load,) = squares(hoist("load"))
    highest = max(corner.y for corner in load.corners)
    assert highest == pytest.approx(-30.0)
    assert sum(corner.x for corner in load.corners) / 4 == pytest.approx(10.0)


def test_a_rope_without_points_runs_from_wheel_to_wheel() -> None:
    points = {"O": DRUM, "P": LEFT_DRUM}
    joints = (
        Roll("one", Circle("O", 0.1), "rope", Line(Vector(0.0, 0.1), RIGHT)),
        Roll("two", Circle("P", 0.2), "rope", Line(Vector(-0.4, -0.1), RIGHT)),
        Roll("two", Circle("P", 0.0), "rope", Line(Vector(-0.4, 0.1), RIGHT)),
    )
    bodies = (Body("one", ("O",)), Body("two", ("P",)), Body("rope", ()))
    drawn, hints = hinted(Mechanism(points, bodies, joints, ()), shapes={"rope": "rope"})
    drawing = draw(scale_to_paper(drawn, 100.0), hints)
    upper = {
        frozenset(line)
        for part in drawing.primitives
        if isinstance(part, Strokes) and part.pen == THIN
        for line in part.lines
        if hypot(*(line[1] - line[0])) > 5.0
    }
    assert upper == {frozenset((Vector(0.0, 10.0), Vector(-40.0, 10.0)))}
