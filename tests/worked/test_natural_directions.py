"""Directions in a worked solution are those of the statement, its figure and its triangles."""

from __future__ import annotations

import pytest

from kinegrade.expressions.reading import read_expression
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import find_shipped, load_template
from kinegrade.problem.template.library.reading import read_template
from kinegrade.worked.positions.algebra import ZERO
from kinegrade.worked.positions.right_angles import make_unit, split_right_angles, turn_back
from kinegrade.worked.solution import write_worked_solution
from tests.worked.draws import kept, told
from tests.worked.telling import lines


def _page(name: str) -> str:
    return "\n".join(lines(kept(name)))


@pytest.mark.parametrize(
    ("angle", "sign", "rest", "quarters"),
    [
        ("phi", 1, "phi", 0),
        ("phi + pi/2", 1, "phi", 1),
        ("pi/2 - phi", -1, "phi", 1),
        ("-phi", -1, "phi", 0),
        ("beta - pi", 1, "beta", 2),
        ("-theta + pi/2 + beta", -1, "theta - beta", 1),
        ("delta + beta - pi/2", 1, "delta + beta", 3),
        ("3*pi/2", 1, "0", 3),
    ],
)
def test_right_angles_are_taken_out_of_an_angle(
    angle: str, sign: int, rest: str, quarters: int
) -> None:
    found = split_right_angles(read_expression(angle))
    assert found == (sign, read_expression(rest), quarters)


@pytest.mark.parametrize(
    ("angle", "x", "y"),
    [
        ("phi", "cos(phi)", "sin(phi)"),
        ("-phi", "cos(phi)", "-sin(phi)"),
        ("phi + pi/2", "-sin(phi)", "cos(phi)"),
        ("pi - phi", "-cos(phi)", "sin(phi)"),
        ("phi - pi/2", "sin(phi)", "-cos(phi)"),
        ("pi", "-1", "0"),
    ],
)
def test_a_unit_vector_has_the_given_angle_alone(angle: str, x: str, y: str) -> None:
    assert make_unit(read_expression(angle)) == (read_expression(x), read_expression(y))


def test_a_point_beyond_a_right_angle_is_placed_by_the_given_angle() -> None:
    assert r"y_{O} &= y_{B} - R\cos\varphi" in _page("rolling-wheel-pin-slotted-rocker")


def test_a_line_whose_angle_the_figure_marks_has_no_angle_of_its_own() -> None:
    # it was psi_AB = 20 degrees, found by a tangent, beside the given phi = 20 degrees
    page = _page("elliptic-trammel-end-driven")
    assert r"\psi" not in page
    assert r"PA &= l\sin\varphi" in page
    assert r"\psi" not in _page("bar-through-swivelling-sleeve")


def test_a_mark_serves_every_pair_of_points_on_its_line() -> None:
    # A slides on BC, whose angle with the vertical is marked at B
    assert r"\psi" not in _page("crank-slider-in-floating-link")


def test_a_side_that_a_triangle_has_placed_goes_by_its_angle() -> None:
    assert r"v_{\mathrm{e}1}\sin(\angle O_{2}O_{1}M - \psi_{CM})" in _page("pin-in-two-rings")


def test_a_side_between_centres_that_is_given_is_not_worked_out_from_coordinates() -> None:
    page = _page("two-wheels-on-cylinder")
    assert r"OA &= R + r_{1}" in page
    assert r"x_{B} &= (R + r_{2})\sin(\angle AOB - \theta)" in page


def test_a_distance_along_a_line_is_not_found_twice() -> None:
    page = _page("rotary-engine")
    assert r"OB \cdot \omega" in page
    assert page.count("OB &= ") == 1


def test_a_contact_that_the_figure_does_not_show_is_introduced_where_the_page_uses_it() -> None:
    for name in ("rolling-wheel-pin-slotted-rocker", "planetary-gear-external-rim-velocities"):
        assert "touches its track" not in _page(name)
    shipped = find_shipped("templates") / "rolling-wheel-pin-slotted-rocker.toml"
    text = shipped.read_text(encoding="utf-8").replace(
        '"magnitude(velocity(B, wheel))", unit = "m/s", sign = "magnitude"',
        '"y(velocity(B))", unit = "m/s", sign = "+y"',
    )
    solution = solve_template(read_template("wheel", text, kept=True), {})
    page = "\n".join(lines(write_worked_solution(solution, ["v_B"], "en").blocks))
    assert "The wheel touches its track at $P$." in page
    assert "is normal to $PB$" in page


def test_the_angle_between_two_velocities_goes_by_directions_that_are_found() -> None:
    page = _page("planetary-gear-external-rim-velocities")
    assert r"\angle(x,v_{A}) &= \varphi + 90^\circ = 105^\circ" in page
    assert (
        r"\angle(v_{A},v_{B}) &= \angle(x,v_{B}) - \angle(x,v_{A}) = 150^\circ - 105^\circ" in page
    )


def test_right_angles_alone_leave_nothing() -> None:
    assert split_right_angles(read_expression("pi/2 + pi"))[1] == ZERO


@pytest.mark.parametrize(
    ("given", "told"),
    [
        ("e*sin(-theta)", "-(e*sin(theta))"),
        ("R + e*cos(-theta)", "R + e*cos(theta)"),
        ("d + e*sin(-theta)", "d - e*sin(theta)"),
        ("-sin(-theta)", "sin(theta)"),
        ("2*l*cos(phi)", "2*l*cos(phi)"),
    ],
)
def test_no_angle_of_a_sine_or_cosine_is_negative(given: str, told: str) -> None:
    assert turn_back(read_expression(given)) == read_expression(told)


def test_a_known_vector_along_an_axis_has_the_axis_for_its_direction() -> None:
    # it had 180 degrees
    assert r"\boldsymbol{v}_{\mathrm{a}} | $0.9\,\unit{m/s}$ | $-x$" in _page(
        "extended-rod-driving-rocker"
    )


def test_a_projection_on_the_line_of_a_vector_names_the_sense_that_it_counts_positive() -> None:
    page = _page("crank-slider-in-floating-link").splitlines()
    places = [place for place, line in enumerate(page) if "direction opposite to" in line]
    assert places
    for place in places:
        vector = page[place].partition("opposite to $")[2].partition("$")[0]
        plain = vector.replace(r"\boldsymbol{v}", "v").replace(r"\boldsymbol{a}", "a")
        assert f"-{plain}" in page[place + 1].replace(" ", ""), page[place : place + 2]


def test_an_arc_cosine_says_of_which_vectors_it_is() -> None:
    page = list(lines(kept("planetary-gear-external-rim-accelerations")))
    (place,) = [place for place, line in enumerate(page) if r"\arccos" in line]
    assert (
        r"The cosine of $\theta$ is the component of $\boldsymbol{a}_{B}$ in the direction of "
        in (page[place - 1])
    )
    assert page[place - 1].endswith(r"$\overrightarrow{BO}$, divided by $a_{B}$:")


def test_a_direction_in_right_angles_has_the_value_that_is_printed_beside_it() -> None:
    """It said 135 and 90 degrees were -135 degrees."""
    template = load_template("planetary-gear-external-rim-velocities")
    page = "\n".join(lines(told(solve_template(template, {"phi": "135"}))))
    assert r"\varphi - 270^\circ = -135^\circ" in page


def test_a_track_that_an_angle_gives_serves_as_one_that_two_points_give() -> None:
    """The angles were cos 36 degrees and 144 degrees, and there was no check."""
    shipped = find_shipped("templates") / "tangent-cam-with-roller.toml"
    text = shipped.read_text(encoding="utf-8").replace("line(F, E)", "line(F, theta)")
    page = "\n".join(lines(told(solve_template(read_template("cam", text, kept=True), {}))))
    assert r"v_{\mathrm{r}} &= -\frac{v_{\mathrm{e}}}{\cos\theta} = " in page
    assert r"$-\theta$" in page
    assert r"(at }180^\circ - \theta" in page
    assert "Check by the time derivative" in page


def test_the_second_leg_of_an_isosceles_triangle_has_the_angle_of_the_first() -> None:
    """It was found from coordinates, as the arctangent of 0.5774."""
    page = "\n".join(lines(kept("scissor-lift")))
    assert "isosceles with its apex at $M$, so $BM$ too makes the angle $\\theta$" in page
    assert r"v_{M}\sin 2\theta &= v_{B}\cos\theta" in page
    assert r"\psi" not in page


def test_a_point_of_a_rod_has_components_along_its_arm_and_across_it() -> None:
    """They were along x and y, with the coordinates of the point, which nothing else needs."""
    page = _page("watt-linkage")
    assert "along $BP$ and across it" in page
    assert r"v_{B}\cos(\psi_{BC} - \varphi)" in page
    assert "v_{P,x}" not in page
    assert "x_{P} &=" not in page


def test_a_pin_that_slides_in_a_slot_normal_to_its_arm_leaves_one_component_in_each_equation() -> (
    None
):
    page = _page("rolling-wheel-pin-slotted-rocker")
    assert r"v_{\mathrm{e}} &= v_{B,OB}" in page.replace("-v", "v")
    assert r"a_{B,BO} &=" in page
    assert "a_{B,x}" not in page


def test_components_along_an_arm_are_those_that_a_question_asks_for() -> None:
    asked = ("v_O", "v_B", "a_O", "a_B_n", "a_B")
    solution = solve_template(load_template("wheel-on-circular-track"), {"beta": "30"}, asked)
    page = "\n".join(lines(write_worked_solution(solution, asked, "en").blocks))
    assert r"a_{B,BO} &= a_{O}^{\mathrm{n}}\cos\beta" in page
    assert "a_{B,x}" not in page


def test_components_along_the_axes_stay_where_they_are_asked_for() -> None:
    assert "a_{C,x} &=" in _page("two-rods-driven-ends")


def test_a_component_along_an_axis_that_nothing_takes_up_is_left_out() -> None:
    # the y component alone was asked for, and both were worked out
    solution = solve_template(
        load_template("flat-faced-follower-curvature-radius"), {}, ("a_rel_y",)
    )
    page = "\n".join(lines(write_worked_solution(solution, ("a_rel_y",), "en").blocks))
    assert r"a_{\mathrm{r},x} &=" not in page


def test_the_arm_of_a_point_of_a_rim_is_the_radius_of_what_rolls() -> None:
    # BM = -y_M/cos(phi) was worked out, and came to r
    asked = ("a_M",)
    solution = solve_template(load_template("roller-rolling-on-rotating-bar"), {}, asked)
    page = "\n".join(lines(write_worked_solution(solution, asked, "en").blocks))
    assert r"+ r \cdot \omega_{B}^{2}" in page
    assert "BM &=" not in page
