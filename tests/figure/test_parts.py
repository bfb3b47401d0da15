"""What an author may add to a figure, and the symbols that follow from how bodies meet."""

from __future__ import annotations

from dataclasses import replace
from math import hypot
from typing import Any

import pytest

from kinegrade.figure.mechanism.layers import Drawing, draw
from kinegrade.figure.mechanism.paper import scale_to_paper
from kinegrade.figure.mechanism.plates import Plate
from kinegrade.figure.mechanism.straight_parts import Bar, Rod
from kinegrade.figure.plane import unit
from kinegrade.figure.scene import FIRM, PITCH, THIN, Bow, Disc, Outline, Scene, Strokes
from kinegrade.figure.sketch import sketch
from kinegrade.figure.symbols.sliding import draw_cylinder
from kinegrade.mechanics.drivers import Component, Rotation
from kinegrade.mechanics.joints import GROUND, Circle, Line, Pin, Roll, Slide
from kinegrade.mechanics.mechanism import Body, Mechanism
from kinegrade.mechanics.vector import Vector
from tests.figure.guided_mechanisms import plate_on_fixed_corners
from tests.figure.mechanisms import RIGHT, UP, Case, hinted, polar, slider_crank, slotted_bar
from tests.figure.wheel_mechanisms import bar_pushing_disc, rack_and_gear

ORIGIN = Vector(0.0, 0.0)


def drawing_of(case: Case, scale: float = 100.0) -> Drawing:
    return draw(scale_to_paper(case[0], scale), case[1])


def symbols(scene: Scene) -> set[str]:
    return {label.symbol for label in scene.labels}


def railway_wheel(**table: Any) -> Case:
    points = {"O": ORIGIN, "C": Vector(0.0, -0.3), "A": Vector(0.0, -0.4)}
    joints = (Roll("W", Circle("O", 0.3), GROUND, Line(points["C"], RIGHT)),)
    driver = Component("O", "W", RIGHT, 1.0, 0.0)
    return hinted(Mechanism(points, (Body("W", ("O", "C", "A")),), joints, (driver,)), **table)


FLANGE = {"circles": [{"body": "W", "centre": "O", "through": "A"}]}


def test_a_flange_that_no_joint_knows_of_is_of_one_body_with_its_wheel_and_behind_it() -> None:
    flange, wheel = [
        part
        for part in drawing_of(railway_wheel(**FLANGE)).primitives
        if isinstance(part, Disc) and part.radius > 5
    ]
    assert (flange.radius, flange.fill, flange.pen) == (pytest.approx(40.0), "grey", FIRM)
    assert (wheel.radius, wheel.fill) == (pytest.approx(30.0), "grey")


def arrow_length(table: dict[str, Any]) -> float:
    scene = sketch(*railway_wheel(**table))
    centre = next(
        part.centre for part in scene.primitives if isinstance(part, Disc) and part.radius > 5
    )
    tips = [
        part.corners[0]
        for part in scene.primitives
        if isinstance(part, Outline) and part.fill == "black"
    ]
    return max(hypot(*(tip - centre)) for tip in tips) / scene.scale


def test_a_radius_is_that_of_the_joint_unless_a_point_on_another_circle_is_named() -> None:
    radius = {"symbol": "r", "centre": "O"}
    assert arrow_length({**FLANGE, "radii": [radius]}) == pytest.approx(0.3)
    assert arrow_length({**FLANGE, "radii": [{**radius, "through": "A"}]}) == pytest.approx(0.4)


def trammel(**table: Any) -> Case:
    points = {"O": ORIGIN, "A": Vector(0.4, 0.0), "B": Vector(0.0, 0.3)}
    joints = (
        Slide("A", "AB", Line(ORIGIN, RIGHT), GROUND),
        Slide("B", "AB", Line(ORIGIN, UP), GROUND),
    )
    mechanism = Mechanism(
        points, (Body("AB", ("A", "B")),), joints, (Component("A", "AB", RIGHT, 1.0, 0.0),)
    )
    return hinted(mechanism, **table)


def test_a_point_that_is_only_constructed_appears_when_it_has_a_label() -> None:
    assert symbols(sketch(*trammel())) == {"A", "B"}
    assert symbols(sketch(*trammel(labels={"O": "O"}))) == {"A", "B", "O"}


def test_a_construction_far_away_does_not_shrink_the_figure() -> None:
    mechanism, hints = trammel()
    far = Mechanism(
        {**mechanism.points, "P": Vector(9.0, 9.0)},
        mechanism.bodies,
        mechanism.joints,
        mechanism.drivers,
    )
    assert sketch(far, hints) == sketch(mechanism, hints)


def test_a_reference_line_is_thin_and_runs_from_point_to_point() -> None:
    parts = drawing_of(trammel(lines=[["O", "B"]])).primitives
    assert Strokes(((ORIGIN, Vector(0.0, 30.0)),), THIN) in parts


def test_a_reference_line_to_a_pin_in_a_slot_lies_over_the_slotted_bar() -> None:
    mechanism, hints = slotted_bar(0.3, 30.0)
    parts = drawing_of((mechanism, replace(hints, lines=(("A", "B"),)))).primitives
    ends = tuple(mechanism.points[name] * 100.0 for name in "AB")
    line = Strokes(((ends[0], ends[1]),), THIN)
    bars = [part for part in parts if isinstance(part, Outline) and part.fill == "grey"]
    assert bars
    assert [bar for bar in bars if not parts.index(line) > parts.index(bar)] == []


def prolonged(angle_to: str) -> Scene:
    points = {"O": ORIGIN, "A": polar(0.3, 20), "F": polar(0.4, 200)}
    mechanism = Mechanism(
        points, (Body("OA", ("O", "A")),), (Pin("O", ("OA", GROUND)),), (Rotation("OA", 1.0, 0.0),)
    )
    angle = {"symbol": "\\beta", "at": "O", "from": "up", "to": angle_to}
    return sketch(*hinted(mechanism, angles=[angle]))


def thin_from(scene: Scene) -> int:
    bow = next(part for part in scene.primitives if isinstance(part, Bow))
    lines = [
        line
        for part in scene.primitives
        if isinstance(part, Strokes) and part.pen == THIN
        for line in part.lines
    ]
    return sum(abs(hypot(*(start - bow.centre)) - 1.0) < 0.01 for start, _ in lines)


def test_a_side_of_an_angle_on_the_prolongation_of_a_bar_gets_its_own_line() -> None:
    assert thin_from(prolonged("A")) == 1  # upwards only: the bar itself is the other side
    assert thin_from(prolonged("F")) == 2


def test_an_arc_beyond_the_end_of_a_short_bar_finds_a_line_there() -> None:
    mechanism, hints = slider_crank(0.02, 30, 60)
    scene = sketch(mechanism, hints)
    bow = next(part for part in scene.primitives if isinstance(part, Bow) and part.pen == THIN)
    reach = max(
        hypot(*(end - bow.centre))
        for part in scene.primitives
        if isinstance(part, Strokes) and part.pen == THIN
        for start, end in part.lines
        if abs((start - bow.centre).cross(polar(1.0, 60))) < 0.01
    )
    assert reach > bow.radius > 0.02 * scene.scale


def test_the_edge_of_a_plate_rests_on_knife_edges_not_in_sleeves() -> None:
    drawing = drawing_of(plate_on_fixed_corners())
    assert [type(part) for part in drawing.parts] == [Plate]
    tips = [
        part.corners[0]
        for part in drawing.primitives
        if isinstance(part, Outline) and len(part.corners) == 3
    ]
    points = plate_on_fixed_corners()[0].points
    assert {(round(tip.x, 6), round(tip.y, 6)) for tip in tips} == {
        (round(points[name].x * 100, 6), round(points[name].y * 100, 6)) for name in "AB"
    }
    wedges = [
        part for part in drawing.primitives if isinstance(part, Outline) and len(part.corners) == 3
    ]
    # Outside
    assert [
        part
        for part in wedges
        if not part.corners[1].dot(part.corners[0]) > part.corners[0].squared()
    ] == []


def test_a_rod_through_its_point_has_two_free_ends_with_letters() -> None:
    mechanism, hints = slotted_bar(0.06, 30)
    case = hinted(mechanism, shapes={"BD": "through"})
    assert {name for name in symbols(sketch(*case)) if name in "DE"} == {"D", "E"}
    rod = next(
        part for part in drawing_of(case).parts if isinstance(part, Rod) and part.body == "BD"
    )
    assert len(rod.free) == 2
    at = mechanism.points["B"] * 100.0
    assert (rod.start - at).dot(rod.end - at) < 0
    assert hints.shapes == {}


def test_the_piston_of_a_rod_is_in_a_closed_cylinder_and_its_end_has_no_letter() -> None:
    mechanism, _ = slotted_bar(0.06, 30)
    case = hinted(mechanism, shapes={"BD": "cylinder"})
    assert "D" not in symbols(sketch(*case))
    drawing = drawing_of(case)
    rod = next(part for part in drawing.parts if isinstance(part, Rod) and part.body == "BD")
    drawn = draw_cylinder(rod.start, rod.end)
    assert set(drawn) <= set(drawing.primitives)
    (cylinder,) = (part for part in drawn if isinstance(part, Outline))
    along = unit(rod.end - rod.start)
    mouth, _, floor, _ = ((corner - rod.start).dot(along) for corner in cylinder.corners)
    *_, shaft = (part.lines[0] for part in drawn if isinstance(part, Strokes))
    assert shaft[0] == rod.start
    assert mouth < (shaft[1] - rod.start).dot(along) < floor


def test_a_rack_has_its_pitch_line_and_its_back_on_the_side_away_from_the_gear() -> None:
    rack = next(part for part in drawing_of(rack_and_gear()).parts if isinstance(part, Bar))
    assert rack.use == "rack"
    assert rack.back.dot(rack.start) > 0  # the gear's centre is the origin


def test_a_fixed_rack_shows_its_pitch_line_above_its_surface() -> None:
    case = railway_wheel(shapes={"W": "gear"})
    levels = {
        part.pen: part.lines[0][0].y
        for part in drawing_of(case).primitives
        if isinstance(part, Strokes) and part.pen in (PITCH, FIRM)
    }
    assert levels[PITCH] == pytest.approx(-30.0)
    assert levels[FIRM] < -31.0


def test_the_track_of_a_wheel_reaches_to_a_ground_pin_on_it() -> None:
    surfaces = [
        line
        for part in drawing_of(bar_pushing_disc()).primitives
        if isinstance(part, Strokes) and part.pen == FIRM
        for line in part.lines
    ]
    assert any(
        min(start.x, end.x) == pytest.approx(0.0) and start.y == pytest.approx(0.0)
        for start, end in surfaces
    ), surfaces


def test_wheels_on_one_line_share_one_surface() -> None:
    points = {"A": Vector(0.0, 0.1), "B": Vector(0.6, 0.2)}
    joints = (
        Roll("W1", Circle("A", 0.1), GROUND, Line(ORIGIN, RIGHT)),
        Roll("W2", Circle("B", 0.2), GROUND, Line(RIGHT, -RIGHT)),
    )
    mechanism = Mechanism(points, (Body("W1", ("A",)), Body("W2", ("B",))), joints, ())
    surfaces = [
        part
        for part in drawing_of(hinted(mechanism)).primitives
        if isinstance(part, Strokes) and part.pen == FIRM
    ]
    assert len(surfaces) == 1


def test_a_letter_stands_nearer_to_its_own_point_than_to_any_other() -> None:
    scene = sketch(*slider_crank(0.03, 20, 60))
    circles = [part.centre for part in scene.primitives if isinstance(part, Disc)]
    own = sorted(circles, key=lambda centre: centre.x)
    for symbol, point in zip("OAB", own, strict=True):
        label = next(label for label in scene.labels if label.symbol == symbol)
        gaps = [
            hypot(
                max(abs(at.x - label.centre.x) - label.width / 2, 0.0),
                max(abs(at.y - label.centre.y) - label.height / 2, 0.0),
            )
            for at in own
        ]
        assert own[gaps.index(min(gaps))] == point
