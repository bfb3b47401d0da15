"""Where the arrow of a given motion stands: at its point or beside it, on its own side of a wall."""

from __future__ import annotations

from math import hypot, radians

import pytest

from kinegrade.figure.marks.straight.arrow_places import Site
from kinegrade.figure.marks.straight.motions import (
    add_motions,
    draw_likely_motions,
    list_likely_motions,
)
from kinegrade.figure.mechanism.rails import Rail
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.plane import nearest_of, polar
from kinegrade.figure.scene import BOLD, FIRM, THIN, Bow, Disc, Label, Outline, Strokes
from kinegrade.figure.sketch import sketch
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.given_marks import mark_givens
from kinegrade.problem.template.hints import Moving
from kinegrade.problem.template.library.library import load_template
from tests.figure.arrows_at_sliders import (
    BOTH,
    RIGHT,
    lay_floor,
    list_shafts,
    place,
    shut_in,
    slider,
)
from tests.problem.draws import draw_filter, drawn

ASIDE = Vector(0.0, 2.6), Vector(0.0, -2.6)


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
    assert min(hypot(*(start - pin)) for start in to_the_right for pin in pins) < beside


def test_an_arrow_does_not_cross_the_arc_of_an_angle_where_it_can_go_beside_it() -> None:
    mechanism = slider(1, 0)
    arc = Bow(mechanism.points["B"], 7.0, -0.2, 1.0, THIN)
    ((start, end),) = place(Layout.of([arc]), mechanism, Moving("v", "B"))
    assert start.y == pytest.approx(end.y)
    assert start.y < mechanism.points["B"].y - 2.0
