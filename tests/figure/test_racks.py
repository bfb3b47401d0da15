"""A rack whose gear is not in the figure: on the ground with its back, its pin in an eye."""

from __future__ import annotations

import pytest

from kinegrade.figure.mechanism.layers import Drawing, draw
from kinegrade.figure.mechanism.paper import scale_to_paper
from kinegrade.figure.mechanism.straight_parts import Bar, Rod
from kinegrade.figure.scene import PITCH, TOOTHED, Outline, Strokes
from kinegrade.mechanics.joints import GROUND, Line, Parallel, Pin, Slide
from kinegrade.mechanics.mechanism import Body, Mechanism
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import FigureHints

C = Vector(50.0, 0.0)


def _draw_steering(height: float) -> Drawing:
    """A rod from a fixed pin, so high above the line of a rack on its right, to that rack."""
    points = {"B": Vector(0.0, height), "C": C / 100.0}
    path = Line(points["C"], Vector(1.0, 0.0))
    joints = (
        Pin("B", ("BC", GROUND)),
        Pin("C", ("BC", "rack")),
        Parallel("rack", GROUND),
        Slide("C", "rack", path, GROUND),
    )
    bodies = (Body("BC", ("B", "C")), Body("rack", ("C",)))
    mechanism = scale_to_paper(Mechanism(points, bodies, joints, ()), 100.0)
    return draw(mechanism, FigureHints(shapes={"rack": "rack"}))


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_a_rack_without_a_gear_has_its_teeth_towards_the_rest_and_its_back_on_the_ground(
    side: float,
) -> None:
    drawing = _draw_steering(0.3 * side)
    [rack] = (part for part in drawing.parts if isinstance(part, Bar) and part.use == "rack")
    assert (rack.start, rack.end, rack.back.y) == (C, C + Vector(22.0, 0.0), -side)
    assert [part for part in drawing.parts if isinstance(part, Rod)] == []
    [contour] = (
        part for part in drawing.primitives if isinstance(part, Outline) and part.pen == TOOTHED
    )
    lowest = min(corner.y * side for corner in contour.corners)
    tips = [corner.x for corner in contour.corners if corner.y * side == pytest.approx(0.7)]
    assert lowest == pytest.approx(-2.6)
    assert len(tips) == 8
    assert max(tips) < rack.end.x - 2.0
    [rail] = drawing.rails
    assert rail.side.y == pytest.approx(-side)
    assert rail.start.x < C.x < rack.end.x < rail.end.x
    pitch = [part for part in drawing.primitives if isinstance(part, Strokes) and part.pen == PITCH]
    assert [line[0].y for part in pitch for line in part.lines] == [0.0]
