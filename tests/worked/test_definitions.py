"""Words and symbols of the composition of motions: each is defined where it is first used, and
stands for one thing.
"""

from __future__ import annotations

import re

from tests.worked.draws import kept, stated
from tests.worked.telling import displayed, lines, proses

COUPLER = {"b": "0.8", "l_BC": "1.3", "l_CD": "2.1", "d": "1.9"}


def find_rules(name: str) -> list[str]:
    """What the solution of a template says of directions by the right-hand rule."""
    return [text for text in proses(kept(name)) if text.startswith("Coriolis acceleration")]


def test_a_frame_that_turns_clockwise_turns_the_relative_velocity_clockwise() -> None:
    # the cam turns with -8 rad/s; seen from it the contact moves left, so a_C points upwards
    assert find_rules("flat-faced-follower-curvature-radius") == [
        r"Coriolis acceleration by the right-hand rule: $\boldsymbol{a}_{\mathrm{Cor}}=2\,\boldsymbol{\omega}_{\text{cam}}\times"
        r"\boldsymbol{v}_{\mathrm{r}}$ has the direction of "
        r"$\boldsymbol{v}_{\mathrm{r}}$ turned through $90^\circ$ clockwise, with $\omega_{\text{cam}}$."
    ]


def test_the_directions_of_two_frames_are_said_in_one_sentence() -> None:
    first, *_ = find_rules("bent-rod-two-sleeves")
    assert first == (
        r"Coriolis acceleration by the right-hand rule: $\boldsymbol{a}_{\mathrm{Cor}1}=2\,"
        r"\boldsymbol{\omega}_{AE}\times\boldsymbol{v}_{\mathrm{r}1}$ has the direction of "
        r"$\boldsymbol{v}_{\mathrm{r}1}$ turned through $90^\circ$ counter-clockwise, with "
        r"$\omega_{AE}$; $\boldsymbol{a}_{\mathrm{Cor}2}=2\,"
        r"\boldsymbol{\omega}_{CMD}\times\boldsymbol{v}_{\mathrm{r}2}$ has the direction of "
        r"$\boldsymbol{v}_{\mathrm{r}2}$ turned through $90^\circ$ counter-clockwise, with "
        r"$\omega_{CMD}$."
    )


def test_two_relative_motions_have_two_symbols() -> None:
    # v_r is asked for, of A relative to the cam; the step finds that of K relative to the follower
    told = displayed(kept("flat-faced-follower-curvature-radius"))
    starts = {line.split("&", maxsplit=1)[0].strip() for line in told}
    columns = "\n".join(lines(kept("flat-faced-follower-curvature-radius")))
    assert [
        one for one in "va" if f"\\boldsymbol{{{one}}}_{{\\mathrm{{r}}K}} | ?" not in columns
    ] == []
    assert r"v_{\mathrm{r},x}" in starts


def test_a_relative_velocity_along_an_axis_is_not_named_again_by_its_magnitude() -> None:
    # v_r = |v_r,x| stood there, of a negative component, and then |v_r|
    told = displayed(kept("rod-sliding-on-driven-wheel"))
    assert not [line for line in told if line.startswith(r"v_{\mathrm{r}} ")]
    assert (
        r"a_{\mathrm{Cor}} &= 2\left|\omega_{AB}\right|\,\left|v_{\mathrm{r},x}\right| = "
        in "".join(told)
    )


def test_a_relative_velocity_is_that_of_the_body_s_point() -> None:
    # it was called the velocity of B, which the frame AB has too, relative to AB
    told = " ".join(proses(kept("rod-sliding-on-driven-wheel")))
    assert (
        "Relative to $AB$, the point of the wheel that coincides with $B$ has the velocity " in told
    )
    told = " ".join(proses(kept("bent-rod-two-sleeves")))
    assert "Relative to $CMD$, $A$ has the velocity " in told


def test_the_only_relative_motion_has_no_index() -> None:
    told = displayed(kept("bar-through-swivelling-sleeve"))
    assert any(line.startswith(r"v_{\mathrm{r}} ") for line in told), told


def test_an_arm_has_the_symbol_of_the_statement_or_is_worked_out_once() -> None:
    # OA is r_1 + r_2 in the planetary gear, and r itself in the slider-crank
    told = displayed(kept("planetary-gear-external-rim-velocities"))
    assert [line for line in told if line.startswith("OA &=")] == [
        r"OA &= r_{1} + r_{2} = 0.1\,\unit{m} + 0.08\,\unit{m} = 0.18\,\unit{m}"
    ]
    assert [line for line in displayed(kept("slider-crank")) if line.startswith("OA &=")] == []


def test_a_coordinate_that_is_zero_is_not_put_in() -> None:
    # d = 1.9 m and x_B = 0: no "(1.9 m - 0)"
    told = displayed(stated("pose-four-bar-coupler", **COUPLER))
    (side,) = (line for line in told if line.startswith("BD &="))
    assert r"\sqrt{(1.9\,\unit{m})^{2} + (0.8\,\unit{m})^{2}}" in side


def test_a_component_follows_from_what_is_known_of_the_vector() -> None:
    # v_D = l omega is normal to OD, which makes the angle phi with x; v_B is taken from it
    told = displayed(stated("elliptic-trammel-crank-driven", l="0.2", omega="4"))
    (line,) = (line for line in told if line.startswith("v_{B,x} &="))
    assert line.startswith(r"v_{B,x} &= -v_{D}\sin\varphi - \omega_{AB}(y_{B} - y_{D}) = ")


def test_a_given_length_is_not_worked_out_from_coordinates() -> None:
    told = displayed(stated("pose-four-bar-coupler", **COUPLER))
    assert [line for line in told if line.startswith("BC &=")] == [r"BC &= l_{BC} = 1.3\,\unit{m}"]


def test_a_direction_beside_an_answer_is_named_and_a_formula() -> None:
    # it was printed as text, with its dollar signs, then as an angle that nothing derived
    told = displayed(kept("planetary-gear-external-rim-velocities"))
    assert [line for line in told if "$" in line] == []
    assert [line for line in told if "in the direction" in line] == []
    (line,) = (line for line in displayed(kept("crossed-belt-drive")) if line.startswith("v_{A} "))
    assert line.endswith(r"\unit{m/s}\quad\text{(clockwise about }O\text{)}")


def test_an_angle_that_a_triangle_has_given_is_not_found_again_by_its_tangent() -> None:
    told = displayed(stated("pose-four-bar-coupler", **COUPLER))
    assert [line for line in told if "\\tan\\varphi_{2}" in line] == []
    (line,) = (line for line in told if line.startswith(r"\varphi_{2} &="))
    assert r"&= \angle(x,\overrightarrow{BD}) + \angle DBC \approx 50.581^\circ" in line


def test_what_n_and_t_mark_is_said_once_and_before_the_first_table_that_has_them() -> None:
    # a_e^n and a_e^t stood in a table without a word
    said = "The indices n and t mark normal and tangential parts."
    for name in ("rotary-engine", "pin-in-two-rings", "two-rods-driven-ends"):
        told = tuple(lines(kept(name)))
        places = [place for place, line in enumerate(told) if said in line]
        parts = [
            place for place, line in enumerate(told) if re.match(r"    \[.*mathrm\{[nt]\}\}", line)
        ]
        assert [place < parts[0] for place in places] == ([True] if parts else []), name


def test_the_sum_about_a_base_point_says_which_point_that_is() -> None:
    # v_AB stood in a composition, and nothing said what it was
    said = "\n".join(proses(kept("slotted-rocker-and-slider-two-drivers")))
    assert (
        r"Here $\boldsymbol{v}_{\mathrm{a}} = \boldsymbol{v}_{B} + \boldsymbol{v}_{AB}$, from the"
        " base point $B$ of $AB$."
    ) in said


def test_the_law_of_sines_names_the_angles_of_its_triangle() -> None:
    said = "\n".join(proses(kept("rod-ground-incline-fixed-centrode")))
    assert (
        r"in the triangle $SAB$, whose angles are $90^\circ - \theta$ at $A$,"
        r" $\gamma + \theta - 90^\circ$ at $B$ and $180^\circ - \gamma$ at $S$:"
    ) in said


def test_an_acceleration_that_counts_against_the_velocity_says_so() -> None:
    # v_B was positive to the left, a_B to the right, for one point
    values = {"v_B": "-0.6", "a_B": "2"}
    said = list(proses(stated("slotted-rocker-and-slider-two-drivers", **values)))
    assert "Given: the acceleration of $B$, taken positive to the right." in said
    values = {"v_B": "0.6", "a_B": "2"}
    said = list(proses(stated("slotted-rocker-and-slider-two-drivers", **values)))
    assert "Given: the acceleration of $B$." in said


def test_a_given_motion_counts_as_that_of_the_points_beside_it_that_are_asked_for() -> None:
    # v_Q was positive to the left, v_C negative to the left
    told = displayed(stated("spool-pulled-by-cord", u="-15", w="20"))
    assert r"v_{Q} &= -u = -15\,\unit{cm/s}\quad\text{(to the left)}" in told
    assert r"a_{Q} &= a = 20\,\unit{cm/s^2}\quad\text{(to the right)}" in told
