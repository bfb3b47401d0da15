"""An angle is read at its arc: the letter between the sides, the ends of the arc on nothing else."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from math import cos, degrees, hypot, radians, sin
from operator import attrgetter

import numpy as np
import pytest
from msgspec.structs import replace

from kinegrade.figure.joints.symbol import Use
from kinegrade.figure.marks.angle_arc import AngleArc, LedAngleArc, Neighbours, add_leaders
from kinegrade.figure.marks.angles import find_neighbours, list_led_arcs, mark_angles
from kinegrade.figure.marks.sides import Side, find_sides
from kinegrade.figure.mechanism.layers import Drawing
from kinegrade.figure.mechanism.straight_parts import Bar, is_slender
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.placing.wedge import (
    Wedge,
    list_spots_in_wedge,
    rate_parted,
    rate_parted_by_rims,
)
from kinegrade.figure.plane import angle_of
from kinegrade.figure.scene import BOLD, FIRM, PITCH, THIN, Bow, Disc, Label, Scene, Strokes
from kinegrade.figure.sketch import sketch
from kinegrade.mechanics.joints import GROUND, Pin
from kinegrade.mechanics.mechanism import Body, Mechanism
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.printed_givens import mark_question
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.hints import Angle
from kinegrade.problem.template.library.library import load_template
from kinegrade.problem.template.library.reading import read_template
from kinegrade.problem.template.library.starter import write_starter_text
from tests.figure.clear import heads
from tests.figure.mechanisms import Case, hinted, polar
from tests.problem.draws import draw_filter, drawn


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


def test_the_arc_of_an_obtuse_angle_is_no_speck_at_its_vertex() -> None:
    values = {"l": "1.305", "theta": "35", "gamma": "110"}
    solution = solve_template(load_template("rod-ground-incline-fixed-centrode"), values)
    hints = mark_question(solution.template, solution.template.asked())
    scene = sketch(solution.motion.frames.mechanism.map(float), hints)
    arcs = [each for each in scene.primitives if isinstance(each, Bow)]
    assert len(arcs) == 2
    assert min(arc.radius for arc in arcs) > 4.0


@pytest.mark.parametrize("length", [0.08, 0.1, 0.12, 0.15, 0.2])
def test_an_arc_does_not_end_on_the_pin_of_its_bar(length: float) -> None:
    scene = sketch(*crank(50, length))
    arc, reach = find_arc(scene), length * scene.scale
    assert abs(reach - arc.radius) > 1.5


@pytest.mark.parametrize(("phi", "swept"), [("-30", -30), ("150", 150), ("210", 210)])
def test_an_angle_beyond_half_a_turn_is_drawn_as_it_is_counted(phi: str, swept: float) -> None:
    """The starter counts 210 degrees counter-clockwise; the shorter way would be 150 clockwise."""
    template = read_template("rocker", write_starter_text())
    solution = solve_template(template, {"phi": phi}, ())
    hints = mark_question(template, template.asked())
    arc = find_arc(sketch(solution.assembly.mechanism.map(float), hints))
    assert degrees(arc.sweep) == pytest.approx(swept)


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


VERTEX = Vector(0.0, 0.0)


def draw_at_o(
    start: str,
    end: str,
    *,
    lines: Sequence[Strokes] = (),
    bars: Sequence[Bar] = (),
) -> Layout:
    """An angle at O in a drawing of some firm lines and bars, with points P, Q and R."""
    at = {"O": VERTEX, "P": polar(30.0, 40), "Q": polar(6.0, 80), "R": polar(30.0, 16)}
    strokes = [Strokes(((bar.start, bar.end),), BOLD) for bar in bars if is_slender(bar)]
    drawing = Drawing((*lines, *strokes), (), (), tuple(bars), (), ())
    hint = Angle(r"\varphi", "O", start, end)
    layout = Layout.of(drawing.primitives)
    (arcs,) = mark_angles(at, hint, find_sides(at, hint, drawing))
    return layout.marked(arcs, (), partial(list_led_arcs, arcs, layout.obstacles))


def test_the_arc_of_a_narrow_angle_is_seen_beside_a_broad_bar() -> None:
    radii: dict[Use, float] = {}
    uses: tuple[Use, ...] = ("link", "slot")
    for use in uses:
        bar = Bar("OQ", VERTEX, polar(30.0, 20), use)
        hint, drawing = Angle("u", "O", "right", "Q"), Drawing((), (), (), (bar,), (), ())
        at = {"O": VERTEX, "Q": polar(30.0, 20)}
        (arcs,) = mark_angles(at, hint, find_sides(at, hint, drawing))
        radii[use] = min(arcs, key=lambda arc: arc.demerit).bow.radius
    assert radii["slot"] * sin(radians(20)) > 1.75 + 2.5
    assert radii["link"] < radii["slot"]


def test_the_arc_of_an_angle_does_not_run_along_a_circle() -> None:
    at = {"O": Vector(0.0, 0.0)}
    sides = tuple(Side(turn, 0.0, 0.0, broad=False, lag=0.0) for turn in (0.0, 1.2))
    hint = Angle("x", "O", "right", "up")
    [alone] = mark_angles(at, hint, sides)
    nicest = min(alone, key=attrgetter("demerit")).bow
    for circle in (Disc(nicest.centre, nicest.radius + 0.5, FIRM), replace(nicest, radius=7.4)):
        [arcs] = mark_angles(at, hint, sides, Neighbours((circle,)))
        assert abs(min(arcs, key=attrgetter("demerit")).bow.radius - circle.radius) > 1.0


def test_only_circles_large_enough_to_be_mistaken_for_an_arc_count() -> None:
    pin, wheel = Disc(Vector(0.0, 0.0), 0.9, FIRM), Disc(Vector(0.0, 0.0), 9.0, FIRM)
    drawing = Drawing((pin, wheel, Strokes((), FIRM)), (), (), (), (), ())
    assert find_neighbours(drawing).circles == (wheel,)


def test_a_leader_that_cannot_be_the_cheapest_is_not_made() -> None:
    layout = draw_at_o("right", "P")
    [arc] = [mark for mark in layout.marks if isinstance(mark, AngleArc)]
    least, most = 7.0 + arc.demerit, 9.0 + arc.demerit
    dears = (least, least + 0.1, most + 0.1)
    bare = Layout.of(()).obstacles
    led = [list(list_led_arcs([arc], bare, dear)) for dear in dears]
    reaches = [{each.reach for each in some if isinstance(each, LedAngleArc)} for some in led]
    assert reaches == [set(), {4.0}, {4.0, 6.5}]


def list_thin_lines(layout: Layout) -> list[tuple[Vector, Vector]]:
    thin = [part for part in layout.lines if isinstance(part, Strokes) and part.pen == THIN]
    return [line for strokes in thin for line in strokes.lines]


def test_the_letter_of_an_angle_stands_on_the_same_side_of_a_bar_as_its_arc() -> None:
    across = Bar("AC", Vector(-20.0, 5.8), Vector(20.0, 3.4))
    layout = draw_at_o("right", "left", bars=[across])
    [letter] = layout.labels
    assert letter.centre.y < 4.6 - 0.06 * letter.centre.x


def test_the_side_of_an_angle_does_not_run_across_a_bar() -> None:
    bar = Bar("BC", Vector(9.5, -6.0), Vector(9.5, 6.0))
    rod = Bar("OP", VERTEX, polar(30.0, 40))
    for start, end in list_thin_lines(draw_at_o("right", "P", bars=[bar, rod])):
        assert max(start.x, end.x) < 9.5


def test_the_axis_of_a_slotted_bar_is_drawn_where_it_is_the_side_of_an_angle() -> None:
    """Dash-dotted: a full line in the slot would be a part of the bar."""
    slotted = Bar("OP", VERTEX, polar(30.0, 40), "slot")
    layout = draw_at_o("right", "P", bars=[slotted])
    strokes = [each for each in layout.lines if isinstance(each, Strokes) and each.pen == PITCH]
    ((_, end),) = (line for each in strokes for line in each.lines)
    assert angle_of(end) == pytest.approx(radians(40))
    slender = list_thin_lines(draw_at_o("right", "P", bars=[replace(slotted, use="link")]))
    assert slender
    assert [end for _, end in slender if not abs(end.y) < 1e-9] == []


def test_the_ground_takes_the_place_of_a_side_that_it_would_double() -> None:
    ground = Strokes(((Vector(-3.0, -0.6), Vector(30.0, -0.6)),), FIRM)
    rod = Bar("OP", VERTEX, polar(30.0, 40))
    layout = draw_at_o("right", "P", lines=[ground], bars=[rod])
    arc = find_arc_of(layout)
    foot = arc.centre + polar(arc.radius, degrees(arc.start))
    assert list_thin_lines(layout) == []
    assert foot.y == pytest.approx(-0.6)


HINT = Angle("x", "O", "right", "up")


def make_sides(*angles: float) -> tuple[Side, ...]:
    """Sides along which nothing is drawn."""
    return tuple(Side(angle, 0.0, 0.0, False, 0.0) for angle in angles)


def find_arc_of(layout: Layout) -> Bow:
    (arc,) = [part for part in layout.lines if isinstance(part, Bow)]
    return arc


def test_a_letter_that_has_no_room_at_its_arc_is_led_to_it() -> None:
    rod = Bar("OR", VERTEX, polar(30.0, 16))
    far = Bar("BC", Vector(11.0, -15.0), Vector(11.0, 15.0))
    layout = draw_at_o("right", "R", bars=[far, rod])
    arc, [letter] = find_arc_of(layout), layout.labels
    ends = [
        line for line in list_thin_lines(layout) if hypot(*line[0]) == pytest.approx(arc.radius)
    ]
    [(start, end)] = ends
    assert 0 < degrees(angle_of(start)) < 16
    assert hypot(*(end - letter.centre)) < max(letter.width, letter.height)


def find_corners(letter: Label) -> list[Vector]:
    half = [(x, y) for x in (-0.5, 0.5) for y in (-0.5, 0.5)]
    return [letter.centre + Vector(x * letter.width, y * letter.height) for x, y in half]


def measure_turn(arc: Bow, place: Vector) -> float:
    """Degrees from the first side of an angle to a place, in the sense of its arc."""
    turned = degrees(angle_of(place - arc.centre) - arc.start) % 360
    return turned if arc.sweep > 0 else -turned % 360


@pytest.mark.parametrize(
    ("name", "seed", "symbol"),
    [
        ("pin-in-disc-slot-and-rod", "u3", r"\varphi"),
        ("bar-pushing-rolling-disc", "u2", r"\gamma"),
    ],
)
def test_a_letter_is_not_led_out_of_an_angle_in_which_it_has_room(
    name: str, seed: str, symbol: str
) -> None:
    template = load_template(name)
    [draw] = drawn(draw_filter(template, seed), 1)
    mechanism = draw.solution.assembly.mechanism.map(float)
    scene = sketch(mechanism, mark_question(template, template.asked()))
    [letter] = [label for label in scene.labels if label.symbol == symbol]
    arcs = [part for part in scene.primitives if isinstance(part, Bow) and part.pen == THIN]
    assert any(
        all(measure_turn(arc, corner) < abs(degrees(arc.sweep)) for corner in find_corners(letter))
        for arc in arcs
        if hypot(*(letter.centre - arc.centre)) < arc.radius + 5.0
    ), arcs


def test_a_leader_passes_the_end_of_a_side_rather_than_going_through_it() -> None:
    side = Side(0.0, 0.0, 0.0, broad=False, lag=0.0)
    arc = AngleArc(Bow(VERTEX, 7.0, 0.0, 0.3, THIN), (side,), Angle("x", "O", "right", "up"), 0.0)
    through: dict[bool, set[float]] = {True: set(), False: set()}
    for led in list_led_arcs([arc], Layout.of(()).obstacles, 9.0):
        [(start, end)] = led.path()
        reach = 0.0
        if end.y < 0 < start.y:
            reach = start.x + (end.x - start.x) * start.y / (start.y - end.y)
        through[0.0 < reach < 8.0].add(round(led.demerit, 3))
    assert min(through[False]) < min(through[True]) - 10.0


def test_no_leader_ends_at_a_side_beyond_which_its_letter_would_stand() -> None:
    side = Side(0.0, 0.0, 0.0, broad=False, lag=0.0)
    arc = AngleArc(Bow(VERTEX, 12.0, 0.0, 0.3, THIN), (side,), Angle("x", "O", "right", "up"), 0.0)
    downward = LedAngleArc(arc, Vector(11.8, 2.2), radians(210), 4.0, 0.0)
    assert downward.path()[0][1].y > 0.0
    assert downward.crosses(arc.measure_sides())
    assert not replace(downward, turn=radians(10)).crosses(arc.measure_sides())


def test_a_leader_may_leave_a_narrow_angle_between_its_sides() -> None:
    sides = tuple(Side(turn, 0.0, 0.0, broad=False, lag=0.0) for turn in (0.15, 0.35))
    arc = AngleArc(Bow(VERTEX, 7.0, 0.15, 0.2, THIN), sides, Angle("x", "O", "right", "up"), 0.0)
    ends = [led.path()[0][1] for led in list_led_arcs([arc], Layout.of(()).obstacles, 9.0)]
    assert any(0.22 < angle_of(end) < 0.28 for end in ends), ends


def test_a_leader_does_not_take_its_letter_to_the_arc_of_another_angle() -> None:
    bow, hint = Bow(VERTEX, 12.0, 0.0, 0.3, THIN), Angle("x", "O", "right", "up")
    led = LedAngleArc(
        AngleArc(bow, make_sides(0.0, 0.3), hint, 0.0), Vector(11.8, 2.2), 0.2, 4.0, 0.0
    )
    [(_, end)] = led.path()
    other = Neighbours(arcs=(Bow(end - Vector(4.0, 0.0), 5.0, -1.0, 2.0, THIN),))
    at_other = replace(led, arc=replace(led.arc, neighbours=other))
    costs = [Layout.of(()).marked([each]).costs[-1] for each in (led, at_other)]
    assert costs[1] > costs[0] + 4.0


def test_a_letter_stands_on_the_side_of_a_bar_on_which_its_arc_is() -> None:
    bow = Bow(VERTEX, 7.0, 0.0, 1.2, THIN)
    bar = (Vector(11.0, -2.0), Vector(4.0, 12.0))
    spots = np.array([[5.0, 2.5], [9.0, 6.0], [7.0, 3.0], [12.0, 3.0]])
    assert rate_parted(spots, bow, [bar]).tolist() == [0.0, 1.0, 0.0, 1.0]
    assert rate_parted(spots, bow, []).tolist() == [0.0] * 4


def test_a_letter_stands_nearer_to_its_own_arc_than_to_another() -> None:
    side = Side(0.0, 0.0, 0.0, broad=False, lag=0.0)
    bow, other = Bow(VERTEX, 7.0, 0.0, 1.2, THIN), Bow(Vector(2.0, 1.0), 9.0, 0.0, 1.2, THIN)
    alone = AngleArc(bow, (side, side), Angle("x", "O", "right", "up"), 0.0)
    beside = replace(alone, neighbours=Neighbours(arcs=(other,))).wish()
    assert alone.wish().demerits is not None
    assert beside.demerits is not None
    outside = alone.wish().spots[0]
    assert hypot(*outside) > bow.radius
    assert beside.demerits[0] > alone.wish().demerits[0]


def test_the_letter_of_an_angle_stands_on_the_same_side_of_a_rim_as_its_arc() -> None:
    bow, rim = Bow(VERTEX, 7.0, 0.0, 1.3, THIN), Disc(polar(22.0, 37), 14.5, FIRM)
    spots = np.array([polar(9.0, 40), polar(4.5, 40)])
    assert rate_parted_by_rims(spots, bow, [rim]).tolist() == [1.0, 0.0]
    beside = AngleArc(bow, make_sides(0.0, 1.3), HINT, 0.0, Neighbours((rim,)))
    wish = beside.wish()
    assert wish.demerits is not None
    assert hypot(*wish.spots[wish.demerits.argmin()]) < bow.radius


def test_the_letter_of_a_narrow_angle_stands_beside_the_bar_and_not_on_it() -> None:
    bow = Bow(VERTEX, 13.0, 0.0, 0.26, THIN)
    wish = list_spots_in_wedge(r"\gamma", Wedge(bow, (0.09, 0.4)))
    assert wish.demerits is not None
    x, y = wish.spots[wish.demerits.argmin()]
    below, above = y, x * sin(0.26) - y * cos(0.26)
    assert 0.2 < above - below < 0.7


def test_a_leader_to_an_arc_leaves_it_at_a_clear_angle_and_follows_no_line() -> None:
    arc = AngleArc(Bow(VERTEX, 9.0, 0.0, 0.8, THIN), make_sides(0.0, 0.8), HINT, 0.0)
    line = (polar(14.0, 23), polar(20.0, 23))
    beside = replace(arc, neighbours=Neighbours(lines=(line,)))
    for led in add_leaders(arc, 0.0, 99.0):
        outward = angle_of(led.start)
        assert abs(cos(led.turn - outward)) > 0.6
    straight = [
        next(led for led in add_leaders(each, 0.0, 99.0) if abs(led.turn - 0.4) < 1e-9)
        for each in (arc, beside)
    ]
    assert straight[1].demerit > straight[0].demerit + 5.0
