"""The sides of an angle are seen: past an arrow along one of them, and clear of a support."""

from __future__ import annotations

from dataclasses import replace

import pytest
from msgspec import structs
from shapely import LineString, Point
from shapely.ops import unary_union

from kinegrade.figure.marks.angle_arc import AngleArc
from kinegrade.figure.marks.sides import Side, hide_sides
from kinegrade.figure.scene import THIN, Bow, Strokes
from kinegrade.figure.sketch import sketch
from kinegrade.mechanics.drivers import Component
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import Angle, FigureHints, Moving
from tests.figure.clear import heads, lines
from tests.figure.mechanisms import slider_crank

ORIGIN, LEFT = Vector(0.0, 0.0), Vector(-1.0, 0.0)
SIDE = Side(0.0, 0.0, 0.0, broad=False, lag=0.0)
ANGLE = Angle("x", "O", "right", "up")


@pytest.mark.parametrize("phi", [60.0, 100.0, -50.0])
def test_the_arc_of_an_angle_meets_its_side_past_the_arrow_along_it(phi: float) -> None:
    mechanism, _ = slider_crank(0.2, 1.75, phi)
    driven = replace(mechanism, drivers=(Component("B", "B", LEFT, 1.0, 0.0),))
    angle = Angle(r"\theta", "B", "left", "A")
    scene = sketch(driven, FigureHints(angles=(angle,), arrows=(Moving("v", "B"),)))
    (arc,) = (part for part in scene.primitives if isinstance(part, Bow) and part.pen == THIN)
    (tip,) = (head.corners[0] for head in heads(scene))
    if abs(tip.y - arc.centre.y) < 0.1:
        assert arc.radius > arc.centre.x - tip.x
    ends = [Point(arc.path()[place]) for place in (0, -1)]
    on_side = min(ends, key=lambda end: abs(end.y - arc.centre.y))
    thin = unary_union([LineString(line) for line in lines(scene, THIN)])
    assert thin.distance(on_side) < 0.3


def test_a_side_is_hidden_as_far_as_an_arrow_lies_on_it_unless_a_line_runs_farther() -> None:
    arrow = (ORIGIN, Vector(10.0, 0.0))
    for reach, hidden in ((5.0, 10.0), (20.0, 0.0)):
        line = Strokes(((ORIGIN, Vector(reach, 0.0)),), THIN)
        assert hide_sides([SIDE], ORIGIN, [arrow], [line]) == (
            structs.replace(SIDE, hidden=hidden),
        )
    for other in ((ORIGIN, Vector(0.0, 10.0)), (ORIGIN, Vector(-10.0, 0.0))):
        assert hide_sides([SIDE], ORIGIN, [other], []) == (SIDE,)


@pytest.mark.parametrize(("drawn", "past"), [(12.0, True), (30.0, False)])
def test_the_axis_of_a_broad_bar_counts_as_a_line_where_it_runs_on_past_the_bar(
    drawn: float, past: bool
) -> None:
    side = structs.replace(SIDE, drawn=drawn, broad=True)
    arc = AngleArc(Bow(ORIGIN, 17.0, 0.0, 0.4, THIN), (side,), ANGLE, 0.0)
    beyond = [LineString(line) for line in arc.path() if line[0].y == line[1].y == 0.0]
    assert any(line.contains(Point(18.0, 0.0)) for line in beyond) == past
