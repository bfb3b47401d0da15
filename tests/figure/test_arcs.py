"""Of a round track an author may want only the arc around its wheels."""

from __future__ import annotations

import re
from math import degrees, hypot

import pytest

from kinegrade.figure.back_ends.typst import write_typst
from kinegrade.figure.mechanism.layers import draw
from kinegrade.figure.mechanism.paper import scale_to_paper
from kinegrade.figure.plane import angle_of
from kinegrade.figure.scene import FIRM, THIN, Bow, Disc, Outline, Primitive, Scene
from kinegrade.figure.sketch import sketch
from kinegrade.mechanics.joints import GROUND, Circle, Roll
from kinegrade.mechanics.mechanism import Body, Mechanism
from kinegrade.mechanics.vector import Vector
from tests.figure.mechanisms import Case, hinted, polar
from tests.figure.wheel_mechanisms import wheel_in_track

ORIGIN = Vector(0.0, 0.0)
ARC = {"shapes": {"ground": "arc"}, "radii": [{"symbol": "R", "centre": "O1"}]}


def wheels_on_track(*angles: float, **table: object) -> Case:
    names = [f"C{number}" for number in range(len(angles))]
    points = {"O1": ORIGIN} | {
        name: polar(0.6, angle) for name, angle in zip(names, angles, strict=True)
    }
    joints = tuple(Roll(name, Circle(name, 0.1), GROUND, Circle("O1", 0.5)) for name in names)
    bodies = tuple(Body(name, (name,)) for name in names)
    return hinted(Mechanism(points, bodies, joints, ()), **table)


def arcs(case: Case) -> list[Bow]:
    primitives = draw(scale_to_paper(case[0], 100.0), case[1]).primitives
    return [part for part in primitives if isinstance(part, Bow)]


def rims_about(primitives: tuple[Primitive, ...], centre: Vector) -> list[Disc]:
    return [part for part in primitives if isinstance(part, Disc) and part.centre == centre]


def test_a_track_is_a_full_circle_unless_its_arc_is_wanted() -> None:
    assert arcs(wheels_on_track(90)) == []
    (arc,) = arcs(wheels_on_track(90, **ARC))
    assert (arc.radius, arc.pen) == (pytest.approx(50.0), FIRM)
    primitives = draw(
        scale_to_paper(wheels_on_track(90)[0], 100.0), hinted(wheels_on_track(90)[0], **ARC)[1]
    ).primitives
    assert rims_about(primitives, ORIGIN) == []


def test_the_arc_around_a_wheel_goes_on_to_where_an_arrow_passes_beside_it() -> None:
    points = {"O1": ORIGIN, "O": Vector(0.0, -0.4)}
    joint = Roll("W", Circle("O", 0.2), GROUND, Circle("O1", 0.6), inside=True)
    (arc,) = arcs(hinted(Mechanism(points, (Body("W", ("O",)),), (joint,), ()), **ARC))
    ends = sorted((degrees(arc.start), degrees(arc.start + arc.sweep)))
    beside_the_wheel = 30.0 + 15.0
    assert ends[0] < -90.0 - beside_the_wheel
    assert -90.0 + beside_the_wheel < ends[1] < 0.0


def test_the_arc_goes_on_to_both_sides_of_all_wheels_on_it() -> None:
    (arc,) = arcs(wheels_on_track(170, -150, **ARC))
    ends = sorted((degrees(arc.start) % 360, degrees(arc.start + arc.sweep) % 360))
    assert ends == pytest.approx([170 - 37.2, 210 + 37.2], abs=0.1)


def test_an_arc_leaves_more_room_for_the_wheel_than_the_circle() -> None:
    mechanism, hints = wheel_in_track()
    whole = sketch(mechanism, hints)
    part = sketch(*hinted(mechanism, **ARC))
    assert part.scale > 1.4 * whole.scale


def test_the_radius_of_an_arc_ends_on_it() -> None:
    mechanism, hints = wheels_on_track(60, **ARC)
    scene = sketch(mechanism, hints)
    (arc,) = [part for part in scene.primitives if isinstance(part, Bow) and part.radius > 10]
    (head,) = [
        part for part in scene.primitives if isinstance(part, Outline) and part.fill == "black"
    ]
    tip = head.corners[0] - arc.centre
    assert hypot(*tip) == pytest.approx(arc.radius)
    assert 0 < (angle_of(tip) - arc.start) % 6.283 < arc.sweep


def test_a_wide_arc_is_as_smooth_as_a_narrow_one_in_typst() -> None:
    def count_corners(radius: float) -> int:
        scene = Scene(100.0, 100.0, 1.0, (Bow(ORIGIN, radius, 0.0, 1.0, THIN),))
        return len(re.findall(r"\([\d.-]+mm, [\d.-]+mm\)", write_typst(scene)))

    assert count_corners(50.0) > 2 * count_corners(5.0) > 0
