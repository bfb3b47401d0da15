"""The construction of a velocity pole: normals that meet, tips on one line, a contact, far away."""

from __future__ import annotations

from math import hypot, tan

import pytest

from kinegrade.figure.scene import THIN, Bow, Disc, Outline, Scene
from kinegrade.figure.vectors.mechanism import PointArrow
from kinegrade.figure.vectors.plain_mechanism import PICTURE
from kinegrade.figure.vectors.pole_construction import (
    NORMAL,
    TALL,
    Pole,
    _shorten_normal,
    draw_pole_construction,
)
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.hints import Turning
from kinegrade.problem.template.library.library import load_template
from tests.figure.clear import dots, faults, heads, lines, symbols
from tests.figure.mechanisms import slider_crank


def crank(phi: float, pole: Vector, rotation: Turning | None = None) -> Scene:
    """The rod of a slider-crank with r = 1 m, l = 2 m; its ends move as about the pole."""
    mechanism, hints = slider_crank(1.0, 2.0, phi)
    a, b = mechanism.points["A"], mechanism.points["B"]
    above_a, above_b = (pole - point for point in (a, b))
    rays = [PointArrow("v_A", a, -above_a.turned()), PointArrow("v_B", b, -above_b.turned())]
    return draw_pole_construction(mechanism, hints, Pole("P", pole), rays, rotation)


def pole_of_rod(phi: float) -> Vector:
    b = slider_crank(1.0, 2.0, phi)[0].points["B"]
    return Vector(b.x, b.x * tan(phi * 0.017453292519943295))


def right_angles(scene: Scene) -> list[Outline]:
    outlines = (part for part in scene.primitives if isinstance(part, Outline) and not part.closed)
    return [part for part in outlines if part.pen == THIN and len(part.corners) == 3]


def test_normals_to_two_velocities_meet_in_the_pole() -> None:
    scene = crank(40.0, pole_of_rod(40.0))
    (pole,) = dots(scene)
    normals = lines(scene, NORMAL)
    assert len(normals) == 2
    assert [end for _, end in normals if not hypot(*(end - pole)) < 1e-6] == []
    assert symbols(scene) == ["A", "B", "O", "P", "v_A", "v_B"]
    assert faults(scene, TALL.width, TALL.height) == []


def test_a_right_angle_stands_between_each_velocity_and_its_normal() -> None:
    scene = crank(40.0, pole_of_rod(40.0))
    for (start, end), mark in zip(lines(scene, NORMAL), right_angles(scene), strict=True):
        first, corner, last = mark.corners
        assert (corner - first).dot(corner - last) == pytest.approx(0.0, abs=1e-6)
        assert (last - start).cross(end - start) == pytest.approx(0.0, abs=1e-6)


def test_a_pole_far_away_is_pointed_to_and_has_its_letter_nowhere() -> None:
    """At both arrow tips it was the letter of two points."""
    scene = crank(85.0, pole_of_rod(85.0))
    assert dots(scene) == []
    assert symbols(scene).count("P") == 0
    assert len(heads(scene)) == 4
    tips, normals = {head.corners[0] for head in heads(scene)}, lines(scene, NORMAL)
    assert normals
    assert [end for _, end in normals if end not in tips] == []
    assert faults(scene, PICTURE.width, PICTURE.height) == []


def test_a_normal_is_seen_beyond_the_bar_on_which_it_lies() -> None:
    up = Vector(0.0, 1.0)
    assert _shorten_normal(Vector(0.0, 0.0), up, ()) == Vector(0.0, 20.0)
    assert _shorten_normal(Vector(0.0, 0.0), up, [(Vector(0.0, 0.0), Vector(0.0, 35.0))]) == Vector(
        0.0, 45.0
    )
    assert _shorten_normal(Vector(0.0, 0.0), up, [(Vector(0.0, 0.0), Vector(35.0, 1.0))]) == Vector(
        0.0, 20.0
    )


def wheel(points: str, **velocities: Vector) -> Scene:
    """A rolling wheel with its contact C as pole, and velocities of points of it."""
    template = load_template("rolling-wheel-pole-acceleration")
    mechanism = solve_template(template, {}).assembly.mechanism.map(float)
    pole = Pole("P", mechanism.points["C"])
    rays = [
        PointArrow(f"v_{point}", mechanism.points[point], velocities[point]) for point in points
    ]
    return draw_pole_construction(mechanism, template.figure, pole, rays)


def test_a_rolling_wheel_has_its_pole_at_the_contact_without_any_velocity() -> None:
    scene = wheel("")
    assert "P" in symbols(scene)
    assert lines(scene, NORMAL) == []
    assert faults(scene, TALL.width, TALL.height) == []


def test_a_point_close_to_the_pole_has_its_normal_though_its_velocity_is_short() -> None:
    assert len(lines(wheel("OT", O=Vector(1.0, 0.0), T=Vector(30.0, 0.0)), NORMAL)) == 3


def test_a_velocity_that_is_zero_has_no_normal() -> None:
    assert lines(wheel("C", C=Vector(0.0, 0.0)), NORMAL) == []


def test_where_normals_coincide_the_tips_of_the_velocities_find_the_pole() -> None:
    scene = wheel("OT", O=Vector(1.0, 0.0), T=Vector(2.0, 0.0))
    found = lines(scene, NORMAL)
    assert len(found) == 3
    start, end = found[2]
    tips = [head.corners[0] for head in heads(scene)]
    assert any(hypot(*(start - tip)) < 1e-6 or hypot(*(end - tip)) < 1e-6 for tip in tips), tips
    assert [tip for tip in tips if not abs((tip - start).cross(end - start)) < 1e-3] == []


@pytest.mark.parametrize("sense", ["ccw", "cw"])
def test_the_rotation_is_drawn_about_the_pole(sense: str) -> None:
    scene = crank(40.0, pole_of_rod(40.0), Turning(r"\omega", "AB", sense))  # type: ignore[arg-type]
    (bow,) = (part for part in scene.primitives if isinstance(part, Bow) and part.pen != THIN)
    assert bow.centre == dots(scene)[0]
    assert (bow.sweep > 0) == (sense == "ccw")
    assert faults(scene, TALL.width, TALL.height) == []


def test_no_rotation_is_drawn_about_a_pole_outside_the_picture() -> None:
    scene = crank(85.0, pole_of_rod(85.0), Turning(r"\omega", "AB", "ccw"))
    assert [part for part in scene.primitives if isinstance(part, Bow)] == []
    assert [
        part for part in scene.primitives if isinstance(part, Disc) and part.fill == "black"
    ] == []
