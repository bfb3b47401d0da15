"""A velocity and an acceleration in one sense: both leave their point, and each has its symbol."""

from __future__ import annotations

from dataclasses import replace
from math import hypot, radians

import pytest
from msgspec import structs

from kinegrade.figure.marks.straight.arrow_places import Site
from kinegrade.figure.marks.straight.motions import add_motions, list_likely_motions
from kinegrade.figure.mechanism.block_sizes import BlockSize
from kinegrade.figure.mechanism.rails import Rail
from kinegrade.figure.mechanism.straight_parts import Bar, Rod
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.plane import length, nearest_of, polar
from kinegrade.figure.scene import BOLD, FIRM, THIN, Bow, Disc, Strokes
from kinegrade.mechanics.vector import Vector
from tests.figure.arrows_at_sliders import BOTH, RIGHT, UP, lay_floor, list_shafts, slider


def lay_under_block(at: Vector) -> Rail:
    """The floor under a block."""
    return structs.replace(lay_floor(at), block=BlockSize(5.0, 3.0))


@pytest.mark.parametrize("sense", [1.0, -1.0])
def test_two_arrows_of_one_sense_leave_their_pin_on_either_side_of_its_line(sense: float) -> None:
    mechanism = slider(sense, sense)
    at = mechanism.points["B"]
    layout = add_motions(Layout.of(()), Site(mechanism), BOTH)
    one, other = list_shafts(layout)
    for start, end in (one, other):
        assert hypot(*(start - at)) < 1.2
        assert start.y == end.y
        assert (end.x - start.x) * sense > 7.0
    assert (one[0].y - at.y) * (other[0].y - at.y) < 0
    assert abs(abs(one[1].x - at.x) - abs(other[1].x - at.x)) > 4.0


@pytest.mark.parametrize("slope", [-60, -30, 30, 60])
def test_a_bar_that_leaves_the_pin_hides_no_tail_and_crosses_no_arrow(slope: float) -> None:
    mechanism = slider(1, 1)
    at = mechanism.points["B"]
    bar = Bar("AB", at, at + polar(radians(slope), 30.0))
    layout = Layout.of([Strokes(((bar.start, bar.end),), BOLD)])
    layout = add_motions(layout, Site(mechanism, (), (bar,)), BOTH)
    (first, _), (second, _) = list_shafts(layout)
    assert first.y == pytest.approx(at.y)
    assert length(second - nearest_of(second, bar.start, bar.end)) > 2.0


def test_on_the_ground_both_keep_off_it_and_the_long_one_is_next_to_it() -> None:
    mechanism = slider(1, 1)
    at = mechanism.points["B"]
    layout = add_motions(Layout.of(()), Site(mechanism, [lay_under_block(at)]), BOTH)
    low, high = sorted(list_shafts(layout), key=lambda line: line[0].y)
    assert low[0].y - (at.y - 1.7) > 1.0
    assert low[1].x > high[1].x + 4.0
    letters = {label.symbol: label.centre for label in layout.labels}
    assert letters["v"].y > high[0].y
    assert letters["a"].x > high[1].x


def test_on_a_rack_both_begin_at_its_end() -> None:
    mechanism = slider(1, 1)
    at = mechanism.points["B"]
    rack = Rail(at, RIGHT, -UP, at - RIGHT * 12, at + RIGHT * 5, 2.8, None)
    layout = add_motions(Layout.of(()), Site(mechanism, [rack]), BOTH)
    for start, end in list_shafts(layout):
        assert hypot(*(start - at)) < 1.5
        assert start.y == end.y > at.y - 1.4


def test_no_symbol_stands_beside_the_other_arrow_or_just_past_its_tip() -> None:
    mechanism = slider(1, 1)
    at = mechanism.points["B"]
    bare = Rail(at, RIGHT, -UP, at - RIGHT * 12, at + RIGHT * 12, 0.0, None)
    for rails in ([], [lay_under_block(at)], [bare]):
        layout = add_motions(Layout.of(()), Site(mechanism, rails), BOTH)
        arrows = [(start, end + RIGHT * 4.0) for start, end in list_shafts(layout)]
        for number, label in enumerate(layout.labels):
            gaps = [
                max(abs(gap.x) - label.width / 2, abs(gap.y) - label.height / 2)
                for gap in (label.centre - nearest_of(label.centre, *arrow) for arrow in arrows)
            ]
            assert gaps[number] == min(gaps)
            assert max(gaps) - min(gaps) > 0.4


def rod_with_walls() -> tuple[Site, Layout, Vector]:
    """A rod to the right of B with bars on both of its sides, and its end."""
    mechanism = slider(1, 1)
    at = mechanism.points["B"]
    body = mechanism.bodies[-1].name
    end = at + RIGHT * 14.0
    rod = Rod(body, at, end, (end,))
    mechanism = replace(
        mechanism, bodies=tuple(replace(each, points=("B",)) for each in mechanism.bodies)
    )
    beside = [(at + UP * level, end + UP * level) for level in (3.6, -3.6, 5.8, -5.8)]
    layout = Layout.of([Strokes(((at, end), *beside), BOLD)])
    return Site(mechanism, (), (rod,)), layout, end


def list_arrows_at_rod(count: int) -> tuple[list[tuple[Vector, Vector]], Vector]:
    """The shafts of so many arrows along a rod with walls, and its end."""
    site, layout, end = rod_with_walls()
    layout = add_motions(layout, site, BOTH[:count])
    _, *shafts = [part.lines[0] for part in layout.lines if isinstance(part, Strokes)]
    return shafts, end


def test_an_arrow_along_a_rod_starts_at_its_free_end() -> None:
    [(start, tip)], end = list_arrows_at_rod(1)
    assert start.y == tip.y == end.y
    assert 0.2 < start.x - end.x < 0.5


def test_an_arrow_leaves_the_free_end_of_a_rod_where_there_is_room_beside_it_too() -> None:
    # under the rod it would be squeezed, with its tip at the rail of the guide
    site, _, end = rod_with_walls()
    rod = Strokes(((site.mechanism.points["B"], end),), BOLD)
    shaft = add_motions(Layout.of([rod]), site, BOTH[:1]).lines[1]
    assert isinstance(shaft, Strokes)
    [(start, tip)] = shaft.lines
    assert start.y == tip.y == end.y
    assert start.x > end.x


def test_two_arrows_along_a_rod_touch_its_end_on_either_side() -> None:
    shafts, end = list_arrows_at_rod(2)
    touching = (BOLD.width + FIRM.width) / 2
    assert sorted(start.y - end.y for start, _ in shafts) == pytest.approx([-touching, touching])
    for start, tip in shafts:
        assert start.y == tip.y
        assert 0.3 < end.x - start.x < 1.0


def test_an_arrow_whose_symbol_names_its_point_does_not_start_at_the_end_of_a_rod() -> None:
    site, layout, end = rod_with_walls()
    layout = add_motions(layout, site, [replace(BOTH[0], symbol="v_{B}")])
    _, *shafts = [part.lines[0] for part in layout.lines if isinstance(part, Strokes)]
    assert shafts
    assert [start for start, _ in shafts if not start.x < end.x] == []


def test_neither_of_two_arrows_of_a_block_lies_on_its_edge() -> None:
    mechanism = slider(1, 1)
    at = mechanism.points["B"]
    layout = add_motions(Layout.of(()), Site(mechanism, [lay_under_block(at)]), BOTH)
    for start, _ in list_shafts(layout):
        assert abs(start.y - at.y) < 1.5 - 0.4


def test_a_symbol_past_the_end_of_a_rail_stands_on_either_side() -> None:
    mechanism = slider(1, 0)
    at = mechanism.points["B"]
    wall = Strokes(((at + Vector(3.0, 2.0), at + Vector(20.0, 2.0)),), BOLD)
    for reach, below in ((20.0, False), (4.0, True)):
        rail = structs.replace(lay_under_block(at), start=at - RIGHT * 7, end=at + RIGHT * reach)
        layout = add_motions(Layout.of((wall,)), Site(mechanism, [rail]), BOTH[:1])
        assert (layout.labels[0].centre.y < at.y - 1.0) == below


def test_at_the_centre_of_a_wheel_no_arrow_stands_beside_it() -> None:
    mechanism = slider(1, 0)
    at = mechanism.points["B"]
    bar = Strokes(((at, at + Vector(30.0, 4.0)),), FIRM)
    for wheel, on_it in (([], False), ([Disc(at, 12.0, FIRM, "grey")], True)):
        layout = add_motions(Layout.of([*wheel, bar]), Site(mechanism), BOTH[:1])
        starts = [mark.path()[0][0] for mark in layout.marks]
        assert [abs(start.y - at.y) < 1e-9 for start in starts] == [on_it]


def test_an_arrow_without_a_good_place_is_complained_of() -> None:
    mechanism = slider(1, 0)
    at = mechanism.points["B"]
    above = Strokes(((at + Vector(-30.0, 2.6), at + Vector(30.0, 2.6)),), BOLD)
    ahead = Strokes(((at + Vector(8.5, 3.0), at + Vector(8.5, -1.0)),), BOLD)
    layout = Layout.of([above, ahead])
    assert add_motions(layout, Site(mechanism, [lay_floor(at)]), BOTH[:1]).crowded == ("v",)
    assert add_motions(Layout.of(()), Site(mechanism), BOTH[:1]).crowded == ()


def test_an_arrow_close_to_a_bar_crosses_no_arc_on_its_way() -> None:
    mechanism = slider(1, 0)
    arc = Bow(mechanism.points["B"], 6.0, -0.3, 1.0, THIN)
    layout = add_motions(Layout.of([arc]), Site(mechanism), BOTH[:1])
    assert abs(list_shafts(layout)[0][0].y - mechanism.points["B"].y) > 2.0


def test_the_places_of_two_arrows_to_come_are_on_either_side_of_their_line() -> None:
    mechanism = slider(1, 1)
    at = mechanism.points["B"]
    levels = [start.y - at.y for start, _ in list_likely_motions(Site(mechanism), BOTH)]
    assert levels == [0.0, 0.0, pytest.approx(1.0), pytest.approx(-1.0)]


@pytest.mark.parametrize("slope", [25, 33, 41, 50])
def test_an_arrow_just_above_the_ground_begins_in_the_bar_over_it(slope: float) -> None:
    mechanism = slider(1, 1)
    at = mechanism.points["B"]
    bar = Bar("AB", at, at + polar(radians(slope), 30.0))
    floor = Rail(at, RIGHT, -UP, at - RIGHT * 12, at + RIGHT * 12, 0.0, None)
    ground = Strokes(((floor.start, floor.end),), FIRM)
    drawn = Layout.of([Strokes(((bar.start, bar.end),), BOLD), ground])
    layout = add_motions(drawn, Site(mechanism, [floor], (bar,)), BOTH[:1])
    start, end = list_shafts(layout)[-1]
    assert start.y == end.y > at.y
    assert length(start - nearest_of(start, bar.start, bar.end)) < 0.1
