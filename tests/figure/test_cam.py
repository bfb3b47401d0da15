"""The made-up profile of a cam keeps what is known of the real one."""

from __future__ import annotations

from math import pi, radians

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.figure.mechanism.layers import draw
from kinegrade.figure.mechanism.paper import scale_to_paper
from kinegrade.figure.mechanism.wheels.cam import trace_cam_profile
from kinegrade.figure.plane import angle_of, length, polar
from kinegrade.figure.scene import PITCH, Disc, Outline, Primitive, Strokes
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template
from tests.figure.guided_mechanisms import pointed_follower
from tests.figure.mechanisms import follower_curvature


@given(st.floats(0.1, 0.5), st.integers(-30, 30), st.floats(0.4, 1.6))
def test_the_profile_lies_below_the_face_touches_it_and_holds_the_pivot(
    r: float, theta: int, rho: float
) -> None:
    contact = polar(radians(90 - theta), r)
    profile = trace_cam_profile(Vector(0.0, 0.0), contact, contact - Vector(0.0, rho), rho)
    assert max(corner.y for corner in profile) == pytest.approx(contact.y, abs=1e-3 * rho)
    edges = list(zip(profile, profile[1:] + profile[:1], strict=True))
    assert [(start, end) for start, end in edges if not (end - start).cross(-start) > 0] == []


@given(st.floats(0.1, 0.5), st.integers(-30, 30), st.floats(0.4, 1.6))
def test_the_profile_has_the_given_curvature_around_the_contact(
    r: float, theta: int, rho: float
) -> None:
    contact = polar(radians(90 - theta), r)
    centre = contact - Vector(0.0, rho)
    profile = trace_cam_profile(Vector(0.0, 0.0), contact, centre, rho)
    at = min(range(len(profile)), key=lambda place: length(profile[place] - contact))
    assert length(profile[at] - contact) < 1e-9
    assert radius_at(profile, at) == pytest.approx(rho, rel=0.02)


def radius_at(profile: tuple[Vector, ...], at: int) -> float:
    """The radius of the circle through a corner and its neighbours."""
    before, here, after = (profile[(at + step) % len(profile)] for step in (-1, 0, 1))
    area = (here - before).cross(after - before) / 2
    return length(here - before) * length(after - here) * length(after - before) / (4 * area)


@given(st.floats(0.1, 0.5), st.integers(-30, 30), st.floats(0.4, 1.6))
def test_the_curvature_changes_gradually_all_around(r: float, theta: int, share: float) -> None:
    contact, rho = polar(radians(90 - theta), r), share * r
    profile = trace_cam_profile(Vector(0.0, 0.0), contact, contact - Vector(0.0, rho), rho)
    radii = [radius_at(profile, at) for at in range(len(profile))]
    assert min(radii) > 0.2 * min(rho, r)
    steps = zip(radii, radii[1:] + radii[:1], strict=True)
    assert [
        (before, after) for before, after in steps if not abs(after - before) < 0.3 * before
    ] == []


def test_a_base_circle_touches_the_profile_from_inside() -> None:
    mechanism, hints = follower_curvature(0.3, 15.0, 0.25)
    primitives = draw(scale_to_paper(mechanism, 100.0), hints).primitives
    (base,) = [part for part in primitives if isinstance(part, Disc) and part.pen == PITCH]
    (profile,) = [part for part in primitives if isinstance(part, Outline) and part.fill == "grey"]
    assert base.centre == mechanism.points["O"] * 100.0
    assert base.radius == pytest.approx(min(length(at - base.centre) for at in profile.corners))


def draw_tangent_cam() -> tuple[Primitive, ...]:
    """That of the shipped template, in millimetres at half its size."""
    solution = solve_template(
        load_template("tangent-cam-with-roller"), {"r": "40", "q": "20", "theta": "30"}
    )
    mechanism = solution.assembly.mechanism.map(float)
    return draw(scale_to_paper(mechanism, 500.0), solution.template.figure).primitives


def test_the_circles_of_a_cam_lie_within_one_outline_with_straight_flanks() -> None:
    primitives = draw_tangent_cam()
    (base,) = [part for part in primitives if isinstance(part, Disc) and part.pen == PITCH]
    (cam,) = [part for part in primitives if isinstance(part, Outline) and part.fill == "grey"]
    edges = zip(cam.corners, cam.corners[1:] + cam.corners[:1], strict=True)
    flanks = [end - start for start, end in edges if length(end - start) > base.radius / 4]
    assert base.radius == pytest.approx(20.0)
    assert min(length(at - base.centre) for at in cam.corners) == pytest.approx(base.radius)
    assert len(flanks) == 2  # tangents of the base circle and of the nose
    assert angle_of(-flanks[1]) % pi == pytest.approx(radians(30), abs=0.02)


def test_the_guide_of_a_rod_is_clear_of_the_wheel_that_it_carries() -> None:
    primitives = draw_tangent_cam()
    discs = [part for part in primitives if isinstance(part, Disc) and part.fill == "grey"]
    (roller,) = [disc for disc in discs if disc.radius == pytest.approx(10.0)]
    guides = [part for part in primitives if isinstance(part, Strokes) and len(part.lines) > 4]
    ends = [at for part in guides for line in part.lines for at in line if at.y > roller.centre.y]
    assert ends
    assert min(length(at - roller.centre) for at in ends) > roller.radius


def test_a_follower_whose_point_runs_on_a_cam_has_a_pointed_head_and_no_dot() -> None:
    mechanism, hints = pointed_follower()
    primitives = draw(scale_to_paper(mechanism, 100.0), hints).primitives
    contact = mechanism.points["A"] * 100.0
    heads = [part for part in primitives if isinstance(part, Outline) and contact in part.corners]
    assert [min(head.corners, key=lambda at: at.y) for head in heads] == [contact]
    assert [part for part in primitives if isinstance(part, Disc) and part.centre == contact] == []
