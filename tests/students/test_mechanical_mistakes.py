"""Mistakes in the mechanics, each worked out by hand on a mechanism of the textbooks."""

from __future__ import annotations

from collections.abc import Mapping
from math import cos, hypot, radians, sin, sqrt

import pytest

import kinegrade
from kinegrade.problem.template.library.library import load_template
from kinegrade.students.mistaking.mistake_kinds import find_candidates


def mistaken(template: str, **given: float | str) -> Mapping[str, Mapping[str, float]]:
    """For each answer of a template the values that known mistakes lead to."""
    answers = kinegrade.template(template).solve(**given)
    return {name: answers[name].mistakes for name in answers}


def planetary() -> Mapping[str, Mapping[str, float]]:
    """The arm of 0.6 turns with 3 and 4, the planet of 0.2 with three times as much: of A, opposite
    to the contact, O's normal part is 0.6 * 9 = 5.4 and that about O 0.2 * 81 = 16.2; the
    tangential ones are 0.6 * 4 = 2.4 and 0.2 * 12 = 2.4.
    """
    return mistaken(
        "planetary-gear-external-rim-accelerations", R="0.4", r="0.2", phi=30, omega1=3, alpha1=4
    )


def test_terms_of_a_planet_that_are_dropped_turned_round_and_not_squared() -> None:
    a_A = planetary()["a_A"]
    assert a_A["tangential-dropped"] == pytest.approx(5.4 + 16.2)
    assert a_A["relative-normal-outwards"] == pytest.approx(hypot(16.2 - 5.4, 4.8))
    assert a_A["path-normal-outwards"] == pytest.approx(hypot(16.2 - 5.4, 4.8))
    assert a_A["omega-not-squared"] == pytest.approx(hypot(0.6 * 3 + 0.2 * 9, 4.8))


def test_a_term_forgotten_in_a_sum_leaves_the_angular_acceleration_itself() -> None:
    found = planetary()
    assert found["a_O"]["tangential-dropped"] == pytest.approx(5.4)
    assert "tangential-dropped" not in {**found["alpha"], **found["v_A"], **found["a_AO_n"]}
    assert found["a_AO_n"]["omega-not-squared"] == pytest.approx(0.2 * 9)


def test_an_inverse_ratio_of_radii() -> None:
    assert planetary()["omega"]["inverse-ratio"] == pytest.approx(3 * 0.2 / 0.6)
    # relative to the arm I turns with 8 - 2 = 6, II of half its radius with 12, and not 3: crossed
    belt = mistaken(
        "crossed-belt-drive", r1="0.2", r2="0.1", l="0.7", phi=30, omega1=8, omega0=2, alpha0=4
    )
    assert belt["omega_II"]["inverse-ratio"] == pytest.approx(2 - 3)
    assert belt["omega_r"]["inverse-ratio"] == pytest.approx(-3)
    # on a straight track and without any wheel there is no ratio
    for name in ("rolling-wheel-rim-points", "slider-crank"):
        assert not [ask for ask, leads in mistaken(name).items() if "inverse-ratio" in leads]


def test_terms_of_a_slider_crank() -> None:
    # r = 1 at 60 degrees, AB = sqrt(3) at a right angle to OA, so that along AB the crank gives its
    # tangential part 2 alone and the rod its normal part sqrt(3)/9: a_B cos 30 = 2 - sqrt(3)/9
    found = mistaken("slider-crank", r=1, k="sqrt(3)", phi=60, omega=1, alpha=2)
    a_B, part = found["a_B"], cos(radians(30))
    assert a_B["tangential-dropped"] == pytest.approx(-sqrt(3) / 9 / part)
    assert a_B["relative-normal-outwards"] == pytest.approx((2 + sqrt(3) / 9) / part)
    assert a_B["omega-not-squared"] == pytest.approx((2 - sqrt(3) / 3) / part)
    assert "path-normal-outwards" not in a_B
    assert "coriolis-wrong-omega" not in a_B


def test_a_crank_without_angular_acceleration_has_no_tangential_term_to_forget() -> None:
    assert "tangential-dropped" not in mistaken("slider-crank", phi=75, alpha=0)["a_B"]


def test_a_coriolis_acceleration_in_a_frame_that_translates() -> None:
    # v_C = (-omega e cos, ...) along the face, and 2 omega v_r is e cos 30 omega^2 twice
    e, angle, omega, eps = 0.05, radians(30), 4, 10
    a_y = mistaken(
        "flat-faced-follower-eccentric-circle", R="0.2", e="0.05", theta_1=30, omega=4, eps=10
    )["a_BC_y"]
    right = -e * omega**2 * cos(angle) + e * eps * sin(angle)
    assert a_y["coriolis-wrong-omega"] == pytest.approx(right + 2 * e * omega**2 * cos(angle))


def test_a_coriolis_acceleration_with_the_omega_of_the_crank() -> None:
    # OC, upright, turns with -1; of AB, 1 long and at 30 degrees, B has 0.8 and the end A slides in
    # OC: along x 0.8 - omega/2 = 1/2, along OC v_r = -omega cos 30
    omega, part = 0.6, cos(radians(30))
    found = mistaken(
        "slotted-rocker-and-slider-two-drivers",
        l=1,
        theta=30,
        psi=90,
        omega=-1,
        eps=0,
        v_B="0.8",
        a_B=0,
    )["alpha_AB"]
    coriolis = 2 * omega * (omega * part)  # and not 2 (-1) omega cos 30
    assert found["coriolis-wrong-omega"] == pytest.approx(2 * (omega**2 * part - coriolis))


def test_what_is_taken_for_the_angular_velocity_of_a_connecting_rod() -> None:
    # r = 1 at 60 degrees, AB = sqrt(3) at a right angle to OA: v_A = 1 along AB and
    # a_B cos 30 = -sqrt(3) omega_AB^2
    found = mistaken("slider-crank", r=1, k="sqrt(3)", phi=60, omega=1, alpha=0)
    for name, omega in {
        "neighbours-omega": -1,
        "far-end-for-pole": 1 / sqrt(3),
        "translation-assumed": 0,
    }.items():
        assert found["omega_AB"][name] == pytest.approx(omega)
        assert found["a_B"][name] == pytest.approx(-2 * omega**2)
    assert found["v_B"]["translation-assumed"] == pytest.approx(1)
    assert not {"neighbours-omega", "far-end-for-pole"} & set(found["v_B"])
    assert not [ask for ask, leads in found.items() if "far-pivot-for-pole" in leads]


def test_a_pole_on_the_velocities_of_a_connecting_rod() -> None:
    # at 30 degrees the line along v_A = (1/2, -cos 30) meets the guide at tan 30 from A
    found = mistaken("slider-crank", r=1, k="sqrt(3)", phi=30, omega=1, alpha=0)
    omega = 1 / (sin(radians(30)) / cos(radians(30)))
    place = cos(radians(30)) + sin(radians(30)) * sin(radians(30)) / cos(radians(30))
    slider = cos(radians(30)) + sqrt(3 - sin(radians(30)) ** 2)
    assert found["omega_AB"]["pole-on-velocities"] == pytest.approx(omega)
    assert found["v_B"]["pole-on-velocities"] == pytest.approx(omega * (slider - place))


RODS = {"far-end-for-pole", "pole-on-velocities", "translation-assumed"}


@pytest.mark.parametrize(
    ("name", "offered"),
    [
        ("four-bar-parallel-coupler", {*RODS, "neighbours-omega", "far-pivot-for-pole"}),
        ("slider-crank", {*RODS, "neighbours-omega"}),  # the slider has no pivot
        ("elliptic-trammel-end-driven", RODS),  # nor is a body beside the only one
        ("planetary-gear-external-rim-accelerations", set()),
        ("bar-through-swivelling-sleeve", set()),
    ],
)
def test_mistakes_with_rods_are_offered_where_there_are_such_rods(
    name: str, offered: set[str]
) -> None:
    template = load_template(name)
    found = {mistake.identifier for mistake in find_candidates(template, template.asks)}
    assert found & {*RODS, "neighbours-omega", "far-pivot-for-pole"} == offered


def test_a_body_that_cannot_turn_has_no_angular_velocity_to_be_taken_for_the_frame_s() -> None:
    # the moving frame is the cam, and the follower in it translates
    found = mistaken("eccentric-cam-offset-follower")
    assert not [ask for ask, leads in found.items() if "coriolis-wrong-omega" in leads]


def test_magnitudes_added_in_place_of_vectors() -> None:
    found = planetary()
    # v_O = 0.6 * 3 and, of both rim points, 0.2 * 9 about O: along it at A, across it at B
    assert found["v_B"]["added-as-scalars"] == pytest.approx(1.8 + 1.8)
    assert found["a_A"]["added-as-scalars"] == pytest.approx(5.4 + 16.2 + 2.4 + 2.4)
    assert not [ask for ask in ("v_A", "omega", "a_A_x") if "added-as-scalars" in found[ask]]


def test_the_transport_motion_in_the_other_of_two_moving_frames() -> None:
    # M at (0.1, 0.1 tan 30) moves with -0.8 along the disc's slot, where its relative acceleration is
    # 16 sqrt(3)/5 and the Coriolis one 2 * 9 * 0.8 along x: with the rod's 3 for the disc's 9
    found = mistaken(
        "pin-in-disc-slot-and-rod", b="0.1", phi=30, omega_1=9, omega_2=3, alpha_1=0, alpha_2=0
    )
    height = 0.1 / sqrt(3)
    for ask, value in {
        "v_M_x": -3 * height,
        "v_M_y": 3 * 0.1 - 0.8,
        "a_M_x": -9 * 0.1 + 14.4,
        "a_M_y": -9 * height + 16 * sqrt(3) / 5,
    }.items():
        assert found[ask]["transport-of-other-frame"] == pytest.approx(value)
    assert "transport-of-other-frame" not in {**found["v_rel_1"], **found["a_rel_2"]}
    one_frame = mistaken("slotted-rocker-and-slider-two-drivers")
    assert not [ask for ask, leads in one_frame.items() if "transport-of-other-frame" in leads]
