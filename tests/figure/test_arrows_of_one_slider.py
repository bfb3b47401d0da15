"""A velocity and an acceleration of one slider: told from one another where there is room."""

from __future__ import annotations

from math import hypot

import pytest

from kinegrade.figure.marks.straight.arrow_places import Site
from kinegrade.figure.marks.straight.motions import add_motions
from kinegrade.figure.mechanism.rails import Rail
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.scene import BOLD, FIRM, THIN, Bow, Strokes
from kinegrade.mechanics.vector import Vector
from tests.figure.arrows_at_sliders import BOTH, RIGHT, lay_floor, list_shafts, place, slider


def test_a_velocity_and_an_acceleration_that_oppose_point_away_from_one_another() -> None:
    mechanism = slider(1, -1)
    (tail, tip), (start, end) = place(Layout.of(()), mechanism, *BOTH)
    assert start.x < tail.x
    assert (tip - tail).dot(end - start) < 0
    assert start.y == tail.y == mechanism.points["B"].y


def test_a_second_arrow_passes_the_first_on_the_open_side_of_the_rail() -> None:
    mechanism = slider(1, 1)
    at = mechanism.points["B"]
    for side in (Vector(0.0, 1.0), Vector(0.0, -1.0)):
        level = at + side * 1.7
        rail = Rail(at, RIGHT, side, level - RIGHT * 8, level + RIGHT * 8, 1.7, None)
        layout = add_motions(Layout.of(()), Site(mechanism, [rail]), BOTH)
        assert (layout.marks[-1].path()[0][0] - at).dot(side) < 0


def test_two_arrows_of_one_sense_both_begin_at_their_point() -> None:
    mechanism = slider(1, 1)
    at = mechanism.points["B"]
    layout = add_motions(Layout.of(()), Site(mechanism, [lay_floor(at)]), BOTH)
    one, other = list_shafts(layout)
    for start, end in (one, other):
        assert at.x <= start.x <= at.x + 4.0 < end.x
    assert abs(one[0].y - other[0].y) > 2.5


def test_an_arrow_passes_the_edges_of_a_plate_rather_than_lying_on_another_one() -> None:
    mechanism = slider(1, 1)
    at = mechanism.points["B"]
    edges = [(at + RIGHT * side, at + Vector(side + 5.0, 20.0)) for side in (0.3, 1.6)]
    layout = Layout.of([Strokes(tuple(edges), FIRM)])
    layout = add_motions(layout, Site(mechanism, [lay_floor(at)]), BOTH)
    one, other = list_shafts(layout)[-2:]
    assert abs(one[0].y - other[0].y) > 2.5


def test_where_there_is_no_room_beside_it_an_arrow_lies_on_a_longer_one_of_its_sense() -> None:
    mechanism = slider(1, 1)
    at = mechanism.points["B"]
    above = Strokes(((at + Vector(-30.0, 2.6), at + Vector(30.0, 2.6)),), BOLD)
    layout = add_motions(Layout.of([above]), Site(mechanism, [lay_floor(at)]), BOTH)
    one, other = list_shafts(layout)
    assert one[0] == other[0]
    assert hypot(*(one[0] - at)) < 1.2
    assert other[1].y == pytest.approx(at.y)
    assert other[1].x > one[1].x + 8.0
    letters = {label.symbol: label.centre for label in layout.labels}
    assert letters["v"].x < one[1].x + 2.0 < letters["a"].x
    opposed = add_motions(Layout.of([above]), Site(slider(1, -1), [lay_floor(at)]), BOTH)
    assert max(hypot(*(end - start)) for start, end in list_shafts(opposed)) < 12.0


@pytest.mark.parametrize("radius", [7.0, 14.0])
def test_where_an_arrow_hides_the_side_of_an_angle_no_longer_one_does(radius: float) -> None:
    mechanism = slider(1, 1)
    at = mechanism.points["B"]
    above = Strokes(((at + Vector(-30.0, 2.6), at + Vector(30.0, 2.6)),), BOLD)
    arc = Bow(at, radius, 0.0, 0.3, THIN)
    layout = add_motions(Layout.of([above, arc]), Site(mechanism, [lay_floor(at)]), BOTH)
    one, other = list_shafts(layout)
    assert abs(one[0].y - other[0].y) > 1.0
