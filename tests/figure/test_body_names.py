"""The name of a body stands where nothing else could own it."""

from __future__ import annotations

from dataclasses import replace
from math import hypot

import pytest
from msgspec import structs
from shapely import LineString

from kinegrade.figure.joints.symbol import Rim
from kinegrade.figure.marks.angle_arc import AngleArc
from kinegrade.figure.marks.body_names import add_body_names
from kinegrade.figure.marks.lengths.dimension_lines import DimensionLine, SymbolBeside
from kinegrade.figure.marks.sides import Side
from kinegrade.figure.mechanism.layers import Drawing
from kinegrade.figure.mechanism.straight_parts import Bar, Part, SlottedDisc
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.plane import unit
from kinegrade.figure.scene import FIRM, THIN, TOOTHED, Bow, Disc, Label, Outline, Pen, Strokes
from kinegrade.figure.symbols.bars import BAR_WIDTH, SLOT_WIDTH
from kinegrade.figure.teeth import TOOTH_ROOT, trace_gear
from kinegrade.mechanics.mechanism import Body, Mechanism
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import Angle, FigureHints
from tests.figure.mechanisms import polar

CENTRE = Vector(0.0, 0.0)
NO_MECHANISM = Mechanism({"O": CENTRE}, (), (), ())
WHEEL = Rim("W", "O", CENTRE, 15.0, "wheel", False, CENTRE, CENTRE)


def name(body: str, rims: tuple[Rim, ...], layout: Layout, parts: tuple[Part, ...] = ()) -> Vector:
    """Where the name 1 of a body is written."""
    hints, drawing = FigureHints(labels={body: "1"}), Drawing((), (), rims, parts, (), ())
    return add_body_names(layout, NO_MECHANISM, hints, drawing).labels[-1].centre


def test_the_name_of_a_wheel_does_not_stand_beside_another_letter() -> None:
    alone = name("W", (WHEEL,), Layout.of(()))
    letter = Label("O", alone - Vector(4.0, 0.0), 2.5, 2.5)
    moved = name("W", (WHEEL,), structs.replace(Layout.of(()), labels=(letter,)))
    assert moved != alone
    assert hypot(*moved) < 15.0


def test_the_name_of_a_wheel_stands_neither_in_an_angle_nor_beyond_its_side() -> None:
    side = Side(0.0, 0.0, 0.0, broad=False, lag=0.0)
    arc = AngleArc(Bow(CENTRE, 7.0, 0.0, 2.0, THIN), (side,), Angle("x", "O", "right", "up"), 0.0)
    layout = structs.replace(Layout.of(()), marks=(arc,))
    alone, moved = name("W", (WHEEL,), Layout.of(())), name("W", (WHEEL,), layout)
    assert (alone.x > 9.0, alone.y) == (True, 0.0)
    assert hypot(*moved) > 7.0
    assert moved.x < 0.0 or moved.y < -1.5


def test_the_name_of_a_ring_stands_in_a_corner_of_the_paper_else_at_its_teeth() -> None:
    ring = Rim("W", "O", CENTRE, 30.0, "gear", True, polar(30.0, 0), polar(30.0, 0))
    at = name("W", (ring,), Layout.of(()))
    assert (hypot(*at) > 33.0, at.x > 20.0, at.y > 20.0) == (True, True, True)
    hatched = Layout.of((Disc(CENTRE, 35.0, Pen(6.0)),))
    assert 26.0 < hypot(*name("W", (ring,), hatched)) < 29.0


def test_the_name_of_a_wheel_does_not_stand_at_a_point() -> None:
    point = name("W", (WHEEL,), Layout.of(())) - Vector(3.0, 0.0)
    hints = FigureHints(labels={"W": "1"})
    mechanism = replace(NO_MECHANISM, points={"A": point}, bodies=(Body("B", ("A",)),))
    drawing = Drawing((), (), (WHEEL,), (), (), ())
    at = add_body_names(Layout.of(()), mechanism, hints, drawing).labels[-1].centre
    assert hypot(*(at - point)) > 3.3


def test_the_name_of_a_stepped_wheel_stands_between_its_rims() -> None:
    assert (
        11.0 < hypot(*name("W", (WHEEL, structs.replace(WHEEL, radius=11.0)), Layout.of(()))) < 15.0
    )


def test_the_name_of_a_bar_does_not_stand_in_a_wheel_behind_it() -> None:
    bar = Bar("AB", Vector(0.0, 10.0), Vector(40.0, 10.0))
    at = name("AB", (structs.replace(WHEEL, radius=25.0),), Layout.of(()), (bar,))
    assert hypot(*at) > 25.0
    assert abs(at.y - 10.0) < 4.0


def test_the_name_of_a_bar_all_over_a_wheel_is_led_to_it_from_outside() -> None:
    bar = Bar("AB", Vector(-6.0, 5.0), Vector(6.0, 5.0))
    assert hypot(*name("AB", (structs.replace(WHEEL, radius=12.0),), Layout.of(()), (bar,))) > 12.0


def test_the_name_of_a_wheel_without_room_does_not_stand_beyond_the_ring_around_it() -> None:
    ring = Rim("R", "P", polar(20.0, 225), 30.0, "gear", True, CENTRE, CENTRE)
    wheel = structs.replace(WHEEL, radius=8.0)
    full = Layout.of([Disc(CENTRE, radius, FIRM) for radius in (3.2, 4.4, 5.6, 8.0)])
    alone, beside = name("W", (wheel,), full), name("W", (wheel, ring), full)
    assert hypot(*(alone - ring.at)) > 30.0
    assert hypot(*(beside - ring.at)) < 30.0


def test_the_name_of_a_wheel_without_room_is_led_to_its_rim() -> None:
    wheel = structs.replace(WHEEL, radius=8.0)
    full = Layout.of([Disc(CENTRE, radius, FIRM) for radius in (3.2, 4.4, 5.6, 8.0)])
    hints, drawing = FigureHints(labels={"W": "1"}), Drawing((), (), (wheel,), (), (), ())
    *_, leader = add_body_names(full, NO_MECHANISM, hints, drawing).lines
    assert isinstance(leader, Strokes)
    ((start, end),) = leader.lines
    assert 6.0 < hypot(*start) < 8.0 < hypot(*end)


def test_the_name_of_a_gear_without_room_is_led_to_the_bottom_of_its_teeth() -> None:
    """A leader across several teeth would be worse than a name without one."""
    gear = Rim("W", "O", CENTRE, 8.0, "gear", False, CENTRE, polar(8.0, 0.0))
    teeth = Outline(trace_gear(CENTRE, gear.tooth, False), TOOTHED, "grey")
    inner = [Disc(CENTRE, radius, FIRM) for radius in (3.2, 4.4, 5.6)]
    hints, drawing = FigureHints(labels={"W": "1"}), Drawing((), (), (gear,), (), (), ())
    layout = add_body_names(Layout.of([*inner, teeth]), NO_MECHANISM, hints, drawing)
    leader = layout.lines[-1]
    assert isinstance(leader, Strokes)
    ((start, _),) = leader.lines
    assert hypot(*start) == pytest.approx(8.0 - TOOTH_ROOT)


def test_the_names_of_a_slotted_disc_and_of_a_bar_over_it_stand_in_one_and_beyond_the_other() -> (
    None
):
    disc = SlottedDisc("D", CENTRE, 20.0, (Vector(8.0, -15.0), Vector(8.0, 15.0)))
    bar = Bar("AB", CENTRE, Vector(19.0, 5.0), "slot")
    assert hypot(*name("D", (), Layout.of(()), (disc, bar))) < 20.0
    assert hypot(*name("AB", (), Layout.of(()), (disc, bar))) > 20.0


def test_the_leader_of_a_slotted_bar_ends_beside_its_slot() -> None:
    disc = SlottedDisc("D", CENTRE, 20.0, (Vector(8.0, -15.0), Vector(8.0, 15.0)))
    bar = Bar("AB", CENTRE, Vector(19.0, 0.0), "slot")
    hints, drawing = FigureHints(labels={"AB": "2"}), Drawing((), (), (), (disc, bar), (), ())
    full = Layout.of([Disc(CENTRE, radius, FIRM) for radius in (16.0, 20.0, 24.0)])
    *_, leader = add_body_names(full, NO_MECHANISM, hints, drawing).lines
    assert isinstance(leader, Strokes)
    ((start, _),) = leader.lines
    assert SLOT_WIDTH / 2 < abs(start.y) < BAR_WIDTH / 2


def test_the_name_of_a_bar_does_not_stand_in_one_row_with_the_symbol_of_its_length() -> None:
    start, end = Vector(0.0, 10.0), Vector(40.0, 10.0)
    bar = Bar("AB", start, end)
    alone = name("AB", (), Layout.of(()), (bar,))
    symbol = Label("s", alone + Vector(7.0, 0.0), 2.0, 2.0)
    plain = structs.replace(Layout.of(()), labels=(symbol,))
    measured = structs.replace(plain, marks=(SymbolBeside(start, end, "s"),))
    assert name("AB", (), plain, (bar,)) == alone
    moved = name("AB", (), measured, (bar,))
    assert abs(moved.y - symbol.centre.y) > 2.0 or abs(moved.x - symbol.centre.x) > 9.0


def measure_up(start: Vector, end: Vector) -> DimensionLine:
    """The dimension between two points, on a line eight millimetres above the upper one."""
    level = max(start.y, end.y) + 8.0
    return DimensionLine(
        (start, end), (Vector(start.x, level), Vector(end.x, level)), "b", 0, (1, 1)
    )


def test_the_name_of_a_wheel_does_not_stand_at_the_end_of_an_extension_line() -> None:
    alone = name("W", (WHEEL,), Layout.of(()))
    for x in (0.0, 6.0):
        below = alone - Vector(x, 13.0)
        dimension = measure_up(below, below + Vector(6.0, 0.0))
        at = name("W", (WHEEL,), structs.replace(Layout.of(()), marks=(dimension,)))
        tops = [end for _, end in dimension.extensions]
        assert hypot(*at) < 15.0
        assert all(abs(at.x - top.x) > 1.5 or at.y < top.y for top in tops)


@pytest.mark.parametrize("x", [-6.0, 0.0, 5.0])
def test_the_leader_of_a_bar_runs_neither_along_nor_across_an_extension_line(x: float) -> None:
    disc = SlottedDisc("D", CENTRE, 30.0, (Vector(8.0, -20.0), Vector(8.0, 20.0)))
    bar = Bar("AB", Vector(-8.0, -4.0), Vector(8.0, 4.0), "slot")
    dimension = measure_up(Vector(x - 6.0, 0.0), Vector(x + 6.0, 0.0))
    hints, drawing = FigureHints(labels={"AB": "2"}), Drawing((), (), (), (disc, bar), (), ())
    layout = structs.replace(Layout.of(dimension.primitives()), marks=(dimension,))
    *_, leader = add_body_names(layout, NO_MECHANISM, hints, drawing).lines
    assert isinstance(leader, Strokes)
    [line] = leader.lines
    for start, end in dimension.extensions:
        assert abs(unit(line[1] - line[0]).cross(unit(end - start))) > 0.1
        assert not LineString([start, end]).crosses(LineString(line))
