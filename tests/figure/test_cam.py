"""The made-up profile of a cam keeps what is known of the real one."""

from __future__ import annotations

from math import radians

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.figure.mechanism.cam import trace_cam_profile
from kinegrade.figure.plane import length, polar
from kinegrade.mechanics.vector import Vector


@given(st.floats(0.1, 0.5), st.integers(-40, 40), st.floats(0.05, 0.6))
def test_the_profile_lies_below_the_face_touches_it_and_holds_the_pivot(
    r: float, theta: int, rho: float
) -> None:
    contact = polar(radians(90 - theta), r)
    profile = trace_cam_profile(Vector(0.0, 0.0), contact, contact - Vector(0.0, rho), rho)
    assert max(corner.y for corner in profile) == pytest.approx(contact.y, abs=1e-3 * rho)
    edges = list(zip(profile, profile[1:] + profile[:1], strict=True))
    assert all((end - start).cross(-start) > 0 for start, end in edges)


@given(st.floats(0.1, 0.5), st.integers(-40, 40), st.floats(0.05, 0.6))
def test_the_profile_has_the_given_curvature_around_the_contact(
    r: float, theta: int, rho: float
) -> None:
    contact = polar(radians(90 - theta), r)
    centre = contact - Vector(0.0, rho)
    profile = trace_cam_profile(Vector(0.0, 0.0), contact, centre, rho)
    near = sorted(profile, key=lambda corner: length(corner - contact))[:5]
    assert all(length(corner - centre) == pytest.approx(rho, rel=1e-6) for corner in near)
