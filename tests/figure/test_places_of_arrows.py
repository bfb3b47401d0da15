"""Where the arrows of given motions stand: on their own side of a wall, told from one another."""

from __future__ import annotations

from dataclasses import replace
from math import degrees, hypot, radians

import numpy as np
import pytest

from kinegrade.figure.marks.straight.arrow_places import Site
from kinegrade.figure.marks.straight.motions import (
    add_motions,
    draw_likely_motions,
    list_likely_motions,
)
from kinegrade.figure.mechanism.paper import scale_to_paper
from kinegrade.figure.mechanism.rails import Rail
from kinegrade.figure.mechanism.straight_parts import Rod
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.placing.place import Wish
from kinegrade.figure.plane import nearest_of, polar, shorter_way
from kinegrade.figure.scene import BOLD, FIRM, THIN, Bow, Disc, Label, Outline, Strokes
from kinegrade.figure.sketch import sketch
from kinegrade.mechanics.drivers import Component, Rotation
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.given_marks import mark_givens
from kinegrade.problem.template.hints import Moving, Turning
from kinegrade.problem.template.library.library import load_template
from tests.figure.mechanisms import slider_crank
from tests.problem.draws import draw_filter, drawn

RIGHT, UP = Vector(1.0, 0.0), Vector(0.0, 1.0)
BOTH = Moving("v", "B"), Moving("a", "B", None, "acceleration")
ASIDE = Vector(0.0, 2.6), Vector(0.0, -2.6)


def slider(velocity: float, acceleration: float) -> Mechanism:
    """A slider-crank in millimetres, its slider moved to the right."""
    mechanism, _ = slider_crank(0.2, 1.75, 60)
    drivers = (Component("B", "B", RIGHT, velocity, acceleration),)
    return scale_to_paper(replace(mechanism, drivers=drivers), 100.0)


def shut_in(at: Vector) -> Layout:
    """Walls in front of a point and behind it, far ahead as well."""
    sides = [at + RIGHT * aside for each in (5.0, 9.0, 13.0, 17.0) for aside in (each, -each)]
    up = Vector(0.0, 2.0)
    return Layout.of([Strokes(tuple((side - up, side + up) for side in sides), BOLD)])


def place(layout: Layout, mechanism: Mechanism, *hints: Moving) -> list[tuple[Vector, Vector]]:
    """The arrows, each from its start to its end."""
    layout = add_motions(layout, Site(mechanism), hints)
    return [mark.path()[0] for mark in layout.marks]


def draw_floor(layout: Layout, mechanism: Mechanism) -> tuple[Layout, Vector]:
    """The layout with a floor where the arrow of a velocity would stand, and the way to it."""
    at = mechanism.points["B"]
    ((start, _),) = place(layout, mechanism, Moving("v", "B"))
    toward = Vector(0.0, 1.0 if start.y > at.y else -1.0)
    foot = at + toward * 2.2
    return layout.drawn([Strokes(((foot - RIGHT * 20, foot + RIGHT * 20),), FIRM)]), toward


def test_an_arrow_beside_its_point_is_on_its_own_side_of_a_wall() -> None:
    mechanism = slider(1, 0)
    at = mechanism.points["B"]
    layout, toward = draw_floor(shut_in(at), mechanism)
    ((start, _),) = place(layout, mechanism, Moving("v", "B"))
    assert (start - at).dot(toward) < 0


def test_neither_head_of_an_acceleration_lies_on_a_rim() -> None:
    mechanism = slider(1, 1)
    at = mechanism.points["B"]
    for inner in (6.0, 7.0, 8.0):
        rim = Layout.of([Disc(at, inner, FIRM)])
        [(start, end)] = place(rim, mechanism, Moving("a", "B", None, "acceleration"))
        back = end - RIGHT * 4.0
        assert not hypot(*(back - at)) < inner < hypot(*(end - at)), (start, end, inner)


def test_a_head_ends_well_off_a_rim_and_the_symbol_of_an_arrow_in_a_disc_too() -> None:
    mechanism = slider(1, 0)
    at = mechanism.points["B"]
    for radius in (9.0, 10.0, 11.0, 13.0):
        layout = add_motions(Layout.of([Disc(at, radius, FIRM)]), Site(mechanism), BOTH[:1])
        [(_, end)] = list_shafts(layout)
        assert abs(hypot(*(end - at)) - radius) > 1.0
        within = [hypot(*(place - at)) < radius for place in (end, layout.labels[0].centre)]
        assert within != [True, False]


def test_an_arrow_lies_on_an_axis_through_its_point() -> None:
    mechanism = slider(1, 0)
    at = mechanism.points["B"]
    axis = Strokes(((at - RIGHT * 10, at + RIGHT * 20),), THIN)
    ((start, end),) = place(Layout.of([axis]), mechanism, Moving("v", "B"))
    assert (start.y, end.y) == (at.y, at.y)


def test_a_velocity_and_an_acceleration_that_oppose_point_away_from_one_another() -> None:
    mechanism = slider(1, -1)
    (tail, tip), (start, end) = place(Layout.of(()), mechanism, *BOTH)
    assert start.x < tail.x
    assert (tip - tail).dot(end - start) < 0
    assert start.y == tail.y == mechanism.points["B"].y


def test_the_tail_of_an_arrow_beside_its_point_is_level_with_it() -> None:
    mechanism = slider(1, 0)
    at = mechanism.points["B"]
    bar = Strokes(((at, at + RIGHT * 30.0),), BOLD)
    layout = add_motions(Layout.of([bar]), Site(mechanism), BOTH[:1])
    beside, line = (part.lines[0] for part in layout.lines[1:] if isinstance(part, Strokes))
    assert beside[0].x == at.x
    assert (line[1], layout.lines[-1].pen) == (beside[0], THIN)
    assert abs(line[0].y - at.y) == pytest.approx(1.05)


def test_the_line_to_the_tail_of_an_arrow_crosses_no_letter() -> None:
    mechanism = slider(1, 0)
    at = mechanism.points["B"]
    letters = [Label("B", at + Vector(0.0, side * 2.9), 1.0, 1.0) for side in (1.0, -1.0)]
    layout = shut_in(at).drawn(letters)
    line = add_motions(layout, Site(mechanism), [Moving("v", "B")]).lines[-1]
    assert isinstance(line, Strokes)
    [(start, end)] = line.lines
    for letter in letters:
        gap = letter.centre - nearest_of(letter.centre, start, end)
        assert max(abs(gap.x), abs(gap.y)) > 0.5


def test_a_second_arrow_passes_the_first_on_the_open_side_of_the_rail() -> None:
    mechanism = slider(1, 1)
    at = mechanism.points["B"]
    for side in (Vector(0.0, 1.0), Vector(0.0, -1.0)):
        level = at + side * 1.7
        rail = Rail(at, RIGHT, side, level - RIGHT * 8, level + RIGHT * 8, 1.7, None)
        layout = add_motions(Layout.of(()), Site(mechanism, [rail]), BOTH)
        assert (layout.marks[-1].path()[0][0] - at).dot(side) < 0


def lay_floor(at: Vector) -> Rail:
    level = at - Vector(0.0, 1.7)
    return Rail(at, RIGHT, Vector(0.0, -1.0), level - RIGHT * 8, level + RIGHT * 8, 1.7, None)


def test_the_line_to_an_arrow_in_the_ground_is_upright_and_the_hatching_cleared_for_it() -> None:
    mechanism = slider(1, 0)
    at = mechanism.points["B"]
    above = Strokes(((at + Vector(-30.0, 2.6), at + Vector(30.0, 2.6)),), BOLD)
    layout = add_motions(shut_in(at).drawn([above]), Site(mechanism, [lay_floor(at)]), BOTH[:1])
    line = layout.lines[-1]
    assert isinstance(line, Strokes)
    [(start, end)] = line.lines
    assert start.x == end.x == at.x
    assert end.y < at.y - 1.7 < start.y < at.y - 1.0
    [white] = [each for each in layout.lines if isinstance(each, Outline) and each.fill == "white"]
    across, upward = zip(*white.corners, strict=True)
    assert min(across) < at.x - 0.5 < at.x + 0.5 < max(across)
    assert at.y - 3.3 < min(upward) < at.y - 3.0 < at.y - 2.1 < max(upward) < at.y - 1.9


def test_the_symbol_of_an_arrow_is_not_on_the_other_side_of_the_rail_of_its_point() -> None:
    mechanism = slider(1, 0)
    at = mechanism.points["B"]
    above = Strokes(((at + Vector(1.0, 3.0), at + Vector(11.0, 3.0)),), FIRM)
    layout = Layout.of([above])
    free = add_motions(layout, Site(mechanism), BOTH[:1])
    railed = add_motions(layout, Site(mechanism, [lay_floor(at)]), BOTH[:1])
    assert free.marks[-1].path() == railed.marks[-1].path()
    assert free.labels[0].centre.y < at.y - 1.7 < railed.labels[0].centre.y


def test_an_arrow_may_run_along_the_side_of_an_angle_at_its_point() -> None:
    mechanism = slider(1, 0)
    at = mechanism.points["B"]
    above = Strokes(((at + Vector(-30.0, 2.6), at + Vector(30.0, 2.6)),), BOLD)
    below = Strokes(((at - Vector(30.0, 2.6), at + Vector(30.0, -2.6)),), FIRM)
    for first, along in ((0.0, True), (-0.3, False)):
        arc = Bow(at, 7.0, first, 1.0, THIN)
        layout = add_motions(Layout.of([above, below, arc]), Site(mechanism), BOTH[:1])
        ((start, _), *_) = layout.marks[-1].path()
        assert (start.y == pytest.approx(at.y)) == along


def test_an_arrow_in_the_ground_is_worse_than_one_across_the_arc_of_an_angle() -> None:
    mechanism = slider(1, 0)
    at = mechanism.points["B"]
    above = Strokes(((at + Vector(-30.0, 2.6), at + Vector(30.0, 2.6)),), BOLD)
    arc = Bow(at, 7.0, -0.3, 1.0, THIN)
    layout = add_motions(Layout.of([above, arc]), Site(mechanism, [lay_floor(at)]), BOTH[:1])
    ((start, _), *_) = layout.marks[-1].path()
    assert start.y == pytest.approx(at.y)


def list_shafts(layout: Layout) -> list[tuple[Vector, Vector]]:
    """The shafts of the arrows of a layout as they are drawn."""
    firm = (part for part in layout.lines if isinstance(part, Strokes) and part.pen == FIRM)
    return [line for part in firm for line in part.lines]


def test_two_arrows_of_one_sense_both_begin_at_their_point() -> None:
    mechanism = slider(1, 1)
    at = mechanism.points["B"]
    layout = add_motions(Layout.of(()), Site(mechanism, [lay_floor(at)]), BOTH)
    one, other = list_shafts(layout)
    assert all(at.x <= start.x <= at.x + 4.0 < end.x for start, end in (one, other))
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


@pytest.mark.parametrize("velocity", [1.0, -1.0])
def test_the_arrow_of_a_bare_end_begins_at_it_just_above_the_ground(velocity: float) -> None:
    mechanism = slider(velocity, 0)
    at = mechanism.points["B"]
    ends = at - RIGHT * 12.0, at + RIGHT * 12.0
    floor = Rail(at, RIGHT, Vector(0.0, -1.0), *ends, 0.0, None)
    bare = Layout.of([Strokes((ends,), FIRM)])
    layout = add_motions(bare, Site(mechanism, [floor]), BOTH[:1])
    _, (start, end) = list_shafts(layout)
    assert hypot(*(start - at)) < 1.8
    assert 0.75 < start.y - at.y < 1.8
    assert (end.x - start.x) * velocity > 7.0
    assert len([part for part in layout.lines if isinstance(part, Strokes)]) == 2


def test_an_arrow_leaves_its_pin_close_to_a_bar_rather_than_beside_its_point() -> None:
    mechanism = slider(1, 0)
    at = mechanism.points["B"]
    for angle, at_pin in ((18.0, True), (4.0, False)):
        bar = Strokes(((at, at + polar(radians(angle), 30.0)),), BOLD)
        ((start, _),) = place(Layout.of([bar]), mechanism, Moving("v", "B"))
        assert (start.y == pytest.approx(at.y)) == at_pin


def test_an_arrow_does_not_end_at_a_rim_as_a_radius_does() -> None:
    mechanism = slider(1, 0)
    at = mechanism.points["B"]
    for radius, longer in ((10.0, True), (6.0, False)):
        rim = Disc(at, radius, FIRM, "grey")
        walls = Strokes(tuple((at + step, at + step + RIGHT * 30) for step in ASIDE), BOLD)
        ((_, end),) = place(Layout.of([rim, walls]), mechanism, Moving("v", "B"))
        assert (end.x > at.x + 11.0) == longer


def test_an_angle_leaves_its_side_to_the_arrow_along_it_and_begins_past_its_tip() -> None:
    mechanism = slider(-1, 0)
    at = mechanism.points["B"]
    [part] = draw_likely_motions(list_likely_motions(Site(mechanism), BOTH[:1]))
    assert isinstance(part, Strokes)
    assert {round(end.x - at.x, 6) for _, end in part.lines} == {-12.05}
    assert sorted(round(start.y - at.y, 6) for start, _ in part.lines) == [-0.85, 0.85]
    assert draw_likely_motions(()) == ()


def test_the_arc_of_an_angle_leaves_room_for_an_arrow_at_another_point() -> None:
    template = load_template("slotted-bar-between-two-rods")
    stated = {
        "theta": ("25", "35", "40", "55"),
        "v_A": ("-60", "-50", "-40", "-30", "-20"),
        "v_B": ("20", "30", "40", "50", "60"),
        "a_B": ("20", "30", "40"),
    }
    [draw] = drawn(draw_filter(template, "u5", stated), 1)
    mechanism = draw.solution.assembly.mechanism.map(float)
    scene = sketch(mechanism, mark_givens(template))
    size = 7.4  # of a shaft
    shafts = [part.lines[0] for part in scene.primitives if isinstance(part, Strokes)]
    level = [(start, end) for start, end in shafts if abs(end.y - start.y) < 1e-9]
    to_the_right = [s for s, e in level if e.x - s.x == pytest.approx(size)]
    pins = [part.centre for part in scene.primitives if isinstance(part, Disc)]
    beside = 1.2  # at the pin, a little off its middle where another arrow begins there, too
    assert any(hypot(*(start - pin)) < beside for start in to_the_right for pin in pins)


def test_each_symbol_is_nearest_to_its_own_arrow() -> None:
    mechanism = slider(1, 1)
    layout = add_motions(Layout.of(()), Site(mechanism), BOTH)
    arrows = [mark.path()[0] for mark in layout.marks]
    for number, label in enumerate(layout.labels):
        gaps = [hypot(*(label.centre - nearest_of(label.centre, *arrow))) for arrow in arrows]
        assert gaps[number] == min(gaps)
        assert max(gaps) - min(gaps) > 0.6


def test_an_arrow_does_not_cross_the_arc_of_an_angle_where_it_can_go_beside_it() -> None:
    mechanism = slider(1, 0)
    arc = Bow(mechanism.points["B"], 7.0, -0.2, 1.0, THIN)
    ((start, end),) = place(Layout.of([arc]), mechanism, Moving("v", "B"))
    assert start.y == pytest.approx(end.y)
    assert start.y < mechanism.points["B"].y - 2.0


def turn_both(of: str, phi: float) -> list[Bow]:
    """The arrows of an angular velocity and acceleration of one body."""
    mechanism, hints = slider_crank(0.2, 1.75, phi)
    body = "OA" if of == "ground" else "AB"
    arrows = (
        Turning(r"\omega", body, None, "velocity", of),
        Turning(r"\alpha", body, None, "acceleration", of),
    )
    drivers = (Rotation(body, 2.0, -1.0, of),)
    scene = sketch(replace(mechanism, drivers=drivers), replace(hints, arrows=arrows))
    return [part for part in scene.primitives if isinstance(part, Bow) and part.pen == FIRM]


@pytest.mark.parametrize("phi", [20.0, 60.0, 120.0])
def test_the_two_arrows_of_a_body_do_not_follow_one_another_on_one_arc(phi: float) -> None:
    one, other = turn_both("ground", phi)
    turned = shorter_way(one.start + one.sweep / 2 - other.start - other.sweep / 2)
    assert abs(degrees(turned)) > 85.0 or abs(one.radius - other.radius) >= 2.5


@pytest.mark.parametrize("phi", [30.0, 60.0, 120.0])
def test_two_arrows_of_a_relative_rotation_have_radii_that_differ(phi: float) -> None:
    one, other = turn_both("OA", phi)
    assert abs(one.radius - other.radius) >= 2.5


def test_the_symbol_of_an_arrow_leaves_the_letter_of_its_point_a_place() -> None:
    mechanism = slider(1.0, 0.0)
    at = mechanism.points["B"]
    usual = add_motions(Layout.of(()), Site(mechanism), BOTH[:1]).labels[-1].centre
    close = usual - RIGHT * 2.2
    letter = Wish("B", np.array([close, at + Vector(0.0, 12.0)]), names=at)
    layout = add_motions(Layout.of(()), Site(mechanism), BOTH[:1], named=[letter])
    assert layout.labels[-1].centre != usual
    assert layout.written([letter]).labels[-1].centre == close


def test_the_symbol_of_an_arrow_stays_where_the_letter_of_its_point_has_another_place() -> None:
    mechanism = slider(1.0, 0.0)
    at = mechanism.points["B"]
    usual = add_motions(Layout.of(()), Site(mechanism), BOTH[:1]).labels[-1].centre
    letter = Wish("B", np.array([usual, at + Vector(0.0, 3.0)]), names=at)
    layout = add_motions(Layout.of(()), Site(mechanism), BOTH[:1], named=[letter])
    assert layout.labels[-1].centre == usual


def test_a_symbol_is_not_cut_off_from_its_arrow_by_a_rod() -> None:
    mechanism = slider(1, 0)
    at = mechanism.points["B"]
    rod = Rod(mechanism.bodies[-1].name, at, at + RIGHT * 30.0, ())
    above = (at + UP * 6.6 - RIGHT * 20.0, at + UP * 6.6 + RIGHT * 30.0)
    layout = Layout.of([Strokes(((rod.start, rod.end),), BOLD), Strokes((above,), FIRM)])
    layout = add_motions(layout, Site(mechanism, (), (rod,)), BOTH[:1])
    [mark], [label] = layout.marks, layout.labels
    start, _ = mark.path()[0]
    assert abs(start.y - at.y) > 1.0
    assert (start.y - at.y) * (label.centre.y - at.y) > 0


def test_a_symbol_does_not_stand_past_a_tip_at_the_end_of_a_line() -> None:
    mechanism = slider(1, 0)
    at = mechanism.points["B"]
    leg = Strokes(((at + RIGHT * 3.0, at + RIGHT * 13.0),), THIN)
    close = [(at + RIGHT * 3.0 + UP * side, at + RIGHT * 9.0 + UP * side) for side in (1.6, -1.6)]
    layout = add_motions(Layout.of([leg, Strokes(tuple(close), FIRM)]), Site(mechanism), BOTH[:1])
    [label] = layout.labels
    assert abs(label.centre.y - at.y) > 1.0
