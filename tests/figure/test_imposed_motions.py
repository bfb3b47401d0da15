"""The arrows of imposed motions: the true sense of each rate, none for what is zero, and a rotation
relative to a body told from one relative to the ground.
"""

from __future__ import annotations

from dataclasses import replace
from math import degrees, hypot

import pytest

from kinegrade.figure.scene import FIRM, Bow, Disc, Scene
from kinegrade.figure.sketch import sketch
from kinegrade.mechanics.drivers import Component, Rotation
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.given_marks import mark_givens
from kinegrade.problem.template.hints import Moving, Turning
from kinegrade.problem.template.library.library import load_template
from tests.figure.clear import heads
from tests.figure.mechanisms import slider_crank
from tests.problem.draws import draw_filter, drawn


def crank_with(velocity: float, acceleration: float, of: str = "ground") -> Scene:
    """A crank drawn with the arrows of both rates that a driver gives it."""
    mechanism, hints = slider_crank(0.2, 1.75, 60)
    drivers = (Rotation("OA", velocity, acceleration, of),)
    both = (
        Turning(r"\omega", "OA", None, "velocity", of),
        Turning(r"\alpha", "OA", None, "acceleration", of),
    )
    return sketch(replace(mechanism, drivers=drivers), replace(hints, arrows=both))


def turned_arrows(scene: Scene) -> list[Bow]:
    return [part for part in scene.primitives if isinstance(part, Bow) and part.pen == FIRM]


def test_an_angular_acceleration_is_drawn_in_its_own_sense_with_one_head_more() -> None:
    faster, slower, steady = crank_with(2, 1), crank_with(2, -1), crank_with(2, 0)
    assert [bow.sweep > 0 for bow in turned_arrows(faster)] == [True, True]
    assert [bow.sweep > 0 for bow in turned_arrows(slower)] == [True, False]
    assert [len(heads(scene)) for scene in (faster, slower, steady)] == [3, 3, 1]


def test_a_rate_of_zero_has_no_arrow_and_no_symbol() -> None:
    assert r"\alpha" in {label.symbol for label in crank_with(2, 1).labels}
    assert r"\alpha" not in {label.symbol for label in crank_with(2, 0).labels}
    assert turned_arrows(crank_with(0, 0)) == []


def test_a_straight_acceleration_points_as_it_is_imposed() -> None:
    mechanism, hints = slider_crank(0.2, 1.75, 60)
    drivers = (Component("B", "AB", Vector(1.0, 0.0), 2.0, -1.0),)
    both = (Moving("v", "B"), Moving("a", "B", None, "acceleration"))
    scene = sketch(replace(mechanism, drivers=drivers), replace(hints, arrows=both))
    senses = [head.corners[0].x - head.corners[1].x > 0 for head in heads(scene)]
    assert senses == [True, False, False]


def test_each_of_two_motions_of_a_point_points_as_its_own_driver_has_it() -> None:
    """Both pointed along the first."""
    mechanism, hints = slider_crank(0.2, 1.75, 60)
    drivers = (
        Component("A", "AB", Vector(1.0, 0.0), -2.0, 0.0),
        Component("A", "AB", Vector(0.0, 1.0), 3.0, 0.0),
    )
    both = tuple(Moving(letter, "A", driver=number) for number, letter in enumerate("uw"))
    scene = sketch(replace(mechanism, drivers=drivers), replace(hints, arrows=both))
    ways = set()
    for head in heads(scene):
        tip, *feet = head.corners
        away = tip - (feet[0] + feet[1]) * 0.5
        ways.add((round(away.x / hypot(*away)), round(away.y / hypot(*away))))
    assert ways == {(-1, 0), (0, 1)}


def test_a_rotation_relative_to_a_body_starts_on_that_body_at_their_pin() -> None:
    mechanism, hints = slider_crank(0.2, 1.75, 60)
    arrow = Turning(r"\omega_r", "AB", None, "velocity", "OA")
    drivers = (Rotation("AB", -1.0, 0.0, "OA"),)
    scene = sketch(replace(mechanism, drivers=drivers), replace(hints, arrows=(arrow,)))
    (bow,) = turned_arrows(scene)
    pins = [part.centre for part in scene.primitives if isinstance(part, Disc)]
    assert min(hypot(*(pin - bow.centre)) for pin in pins) < 1e-6
    assert degrees(bow.start) % 360 == pytest.approx(240)  # from A towards O
    assert bow.sweep < 0


def test_a_wheel_beside_an_arm_on_one_pivot_has_its_arrow_at_its_rim() -> None:
    template = load_template("pin-in-disc-slot-and-rod")
    (draw,) = drawn(draw_filter(template), 1)
    scene = sketch(draw.solution.assembly.mechanism.map(float), mark_givens(template))
    disc = max(part.radius for part in scene.primitives if isinstance(part, Disc))
    of_disc, of_rod = (turned_arrows(scene)[first : first + 2] for first in (0, 2))
    assert (len(of_disc), len(of_rod)) == (2, 2)
    assert [bow for bow in of_disc if not abs(bow.radius - disc) < 3.0] == []
    assert [bow for bow in of_rod if not bow.radius < disc / 2] == []


@pytest.mark.parametrize("eccentricity", ["0.06", "0.08"])
def test_the_arrows_of_an_eccentric_disc_stand_within_it_where_there_is_room(
    eccentricity: str,
) -> None:
    template = load_template("eccentric-cam-offset-follower")
    values = {"r": "0.70", "e": eccentricity, "h": "0.20", "phi": "165", "omega": "2", "alpha": "1"}
    solution = solve_template(template, values)
    scene = sketch(solution.assembly.mechanism.map(float), mark_givens(template))
    discs = (part for part in scene.primitives if isinstance(part, Disc))
    disc = max(discs, key=lambda part: part.radius)
    points = [point for bow in turned_arrows(scene) for point in bow.path()]
    assert points
    assert [point for point in points if not hypot(*(point - disc.centre)) < disc.radius] == []


def test_the_arrow_of_an_eccentric_disc_without_room_stands_beyond_its_rim() -> None:
    template = load_template("eccentric-cam-offset-follower")
    (draw,) = drawn(draw_filter(template, fixed={"phi": ("60",)}), 1)
    scene = sketch(draw.solution.assembly.mechanism.map(float), mark_givens(template))
    discs = (part for part in scene.primitives if isinstance(part, Disc))
    disc = max(discs, key=lambda part: part.radius)
    points = [point for bow in turned_arrows(scene) for point in bow.path()]
    assert points
    assert [point for point in points if not hypot(*(point - disc.centre)) > disc.radius] == []


@pytest.mark.parametrize("phi", [40.0, 75.0, 120.0])
def test_an_arrow_is_not_drawn_into_the_angle_at_its_pivot_or_along_its_arc(phi: float) -> None:
    mechanism, hints = slider_crank(0.2, 1.75, phi)
    both = (Turning("w", "OA"), Turning("e", "OA", None, "acceleration"))
    drivers = (Rotation("OA", 2.0, -1.0),)
    scene = sketch(replace(mechanism, drivers=drivers), replace(hints, arrows=both))
    for bow in turned_arrows(scene):
        middle = degrees(bow.start + bow.sweep / 2) % 360
        assert not 5.0 < middle < phi - 5.0
