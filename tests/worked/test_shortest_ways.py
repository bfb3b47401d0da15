"""Solutions take what is known as it is known: components that have been found, a rigid triangle, a
length of the statement, an angle told under one name.
"""

from __future__ import annotations

import pytest

from kinegrade.language import Language
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import find_shipped
from kinegrade.problem.template.library.reading import read_template
from kinegrade.worked.document import Pictures
from kinegrade.worked.solution import write_worked_solution
from tests.worked.chapters import solve_small, write_blocks
from tests.worked.draws import drawn, kept, stated, told
from tests.worked.telling import displayed, lines, proses

SCISSORS = """
joints = [
  "pin A: ground AD", "pin M: AD BC", "B of BC slides on line(A, 0)", "C of BC slides on line(A, pi/2)",
]
inputs = [{ motion = "B of BC moves along +x", velocity = "2" }]
[points]
A = "(0, 0)"
B = "(4*l/5, 0)"
C = "(0, 3*l/5)"
D = "(4*l/5, 3*l/5)"
M = "midpoint(A, D)"
[bodies]
AD = "A M D"
BC = "B M C"
[figure]
lengths = [{ symbol = "l", from = "A", to = "D" }]
"""


def find_lines(name: str, start: str, place: int = 0) -> list[str]:
    """The equations of a template's solution whose left side begins so."""
    return [line for line in displayed(kept(name, place)) if line.startswith(start)]


def test_a_vector_found_by_its_components_is_projected_by_these() -> None:
    # v_D was projected with the cosine of an angle that nothing told
    (speed,) = find_lines("extended-rod-driving-rocker", r"v_{\mathrm{r}} &=", 1)
    assert speed.startswith(r"v_{\mathrm{r}} &= v_{D,x}\cos\delta - v_{D,y}\sin\delta")
    table = [line for line in lines(kept("extended-rod-driving-rocker", 1)) if "] " in line]
    assert any(line.endswith(r"_{\mathrm{a}} | $v_{D,x},\;v_{D,y}$ | known") for line in table), (
        table
    )


def test_a_component_along_a_line_of_the_statement_has_its_angle() -> None:
    (normal,) = find_lines("wheel-on-circular-track", "a_{B,BO} &=")
    assert r"a_{B,x}\sin(\theta - \beta)" in normal


def test_two_points_on_circles_about_one_centre_turn_with_it_as_a_rigid_triangle() -> None:
    name = "two-wheels-on-cylinder"
    (turning,) = find_lines(name, r"\omega_{AB} &=")
    assert turning.startswith(r"\omega_{AB} &= -\frac{v_{A}}{OA} = ")
    (speed,) = find_lines(name, "v_{B} &=")
    assert speed.startswith(r"v_{B} &= -OB \cdot \omega_{AB} = ")
    assert "$OAB$ is a rigid triangle: $AB$ turns about" in "\n".join(proses(kept(name)))
    turning = r"$AB$ ($\omega_{AB}$, $\alpha_{AB}$): rotation about the fixed"
    texts = tuple(proses(kept(name)))
    assert any(text.startswith(turning) for text in texts), texts
    assert not [block for block in kept(name) if isinstance(block, Pictures)]


def test_a_method_that_is_asked_for_is_taken_in_place_of_the_rigid_triangle() -> None:
    by_pole = told(drawn("two-wheels-on-cylinder")[0], "pole")
    assert [text for text in proses(by_pole) if "rigid triangle" in text] == []


def test_a_line_makes_one_angle_and_has_one_length_whatever_the_order_of_its_points() -> None:
    told = displayed(kept("crank-bar-through-sleeve-with-arm"))
    assert len([line for line in told if line.startswith(r"\tan\psi")]) == 1
    assert not [line for line in told if line.startswith("BA &=")]
    # no "Here $BD = DB" beside them
    texts = proses(kept("rolling-wheel-pin-slotted-rocker"))
    assert [text for text in texts if "Here" in text] == [
        r"Here $\boldsymbol{v}_{\mathrm{a}} = \boldsymbol{v}_{B}$.",
        r"Here $\boldsymbol{a}_{\mathrm{a}} = \boldsymbol{a}_{B}$.",
    ]


def test_the_radius_of_a_circle_on_which_a_point_moves_is_told() -> None:
    (arm,) = find_lines("wheel-on-circular-track", "O_{1}O &=")
    assert arm.startswith("O_{1}O &= R + r = ")


def test_the_distance_of_a_pole_is_worked_out() -> None:
    (distance,) = find_lines("pole-sleeve-slider-rod", "SB &=")
    assert "y_{S}" in distance


def test_a_point_that_only_draws_a_level_track_is_not_placed() -> None:
    assert not find_lines("crank-rocker-towed-wheel", "x_{K} &=")


def test_a_point_of_contact_is_placed_for_points_that_turn_about_it_alone() -> None:
    solution = drawn("slider-driven-gear-on-rack")[0]
    turning = displayed(write_worked_solution(solution, ("omega_O",), "en").blocks)
    assert [line for line in turning if "_{C} &=" in line] == []
    rim = displayed(write_worked_solution(solution, ("v_A", "omega_O"), "en").blocks)
    assert any(line.startswith(r"v_{A,x} &= -\omega_{O}(y_{A} - y_{C})") for line in rim), rim
    assert any(line.startswith("y_{C} &= -r") for line in rim), rim
    assert not find_lines("rolling-wheel-pin-slotted-rocker", "x_{P} &=")
    assert find_lines("wheel-on-circular-track", "x_{D} &=")


def test_a_coriolis_acceleration_is_told_from_the_acceleration_of_a_point_c() -> None:
    # asked in the one, beside the acceleration of C in the other
    for name in ("crank-bar-through-sleeve-with-arm", "bar-pushing-rolling-disc"):
        equations = "".join(displayed(kept(name)))
        assert r"a_{\mathrm{Cor}}" in equations
        assert r"a_{\mathrm{C}}" not in equations


def test_roman_numerals_of_bodies_stand_upright_and_apart_from_chinese_words() -> None:
    told = list(proses(kept("crossed-belt-drive", language="zh")))
    assert any(r"已知 $\omega_{\mathrm{I}} = " in text for text in told), told
    assert any("带轮 II 的角速度" in text for text in told), told


def test_equal_rim_speeds_are_solved_in_symbols() -> None:
    (result,) = find_lines("crossed-belt-drive", r"\omega_{\mathrm{II}} &=")
    assert (
        r"&= \omega_{OA} - \frac{r_{1}}{r_{2}} \cdot (\omega_{\mathrm{I}} - \omega_{OA}) ="
        in result
    )


def test_a_wheel_has_the_number_of_the_figure() -> None:
    texts = tuple(proses(kept("two-wheels-on-cylinder")))
    assert any(
        text.startswith("$AB$") and r"wheel 1 ($\omega_{1}$, $\alpha_{1}$): plane" in text
        for text in texts
    ), texts


def test_the_centre_of_a_wheel_on_a_straight_track_goes_along_it() -> None:
    """The bar that pushes it gives its speed alone; the link to the rocker comes after."""
    texts = [line.lstrip("# ") for line in lines(kept("bar-pushing-rolling-disc")) if "##" in line]
    assert texts == [
        "1. Composition of motions: moving point $C$, moving frame on $O_{1}A$",
        "2. The disc $C$ rolls without slipping on a fixed straight track",
        "3. $BC$: velocity pole",
        "1. Composition of motions: moving point $C$, moving frame on $O_{1}A$",
        "2. The disc $C$ rolls without slipping on a fixed straight track",
        "3. $BC$: base point $C$",
    ]


def test_the_arm_to_a_midpoint_is_half_of_a_given_length() -> None:
    # it was worked out by the coordinates of both ends, with a root
    told = proses(write_blocks(solve_small(SCISSORS, omega="omega(AD) in rad/s")))
    (arms,) = [text for text in told if "Here $AM = " in text]
    assert r"Here $AM = \frac{l}{2} = \frac{1\,\unit{m}}{2} = 0.5\,\unit{m}$" in arms


@pytest.mark.parametrize("name", ["toggle-press", "two-rods-driven-ends"])
def test_a_rod_placed_by_a_given_angle_needs_no_angle_from_coordinates(name: str) -> None:
    assert not [line for line in displayed(kept(name)) if r"\tan\psi" in line]


def test_a_slanting_line_meets_a_circle_by_the_law_of_sines() -> None:
    """It took half the chord, a letter more, and then the tangent of coordinates for the angle."""
    blocks = stated("rotary-engine", r="50", l="140", phi="30", n="600")
    said = r"in the triangle $OAB$ the law of sines gives the angle $\delta$ at $B$"
    assert said in "\n".join(proses(blocks))
    told = displayed(blocks)
    place = next(at for at, line in enumerate(told) if line.startswith(r"\sin\delta"))
    assert told[place].startswith(r"\sin\delta &= \frac{x_{A}\sin\varphi}{l} =")
    assert told[place + 1] == r"\delta &\approx 10.287^\circ"
    assert told[place + 2].startswith(r"OB &= x_{A}\cos\varphi + l\cos\delta =")
    assert told[place + 2].endswith(r"\approx 0.18105\,\unit{m}")
    assert not [line for line in told if r"\psi" in line]


def test_the_angle_of_a_triangle_is_taken_off_where_its_corner_lies_on_the_other_side() -> None:
    """With the crank to the left the rod leans back from the cylinder."""
    text = (find_shipped("templates") / "rotary-engine.toml").read_text(encoding="utf-8")
    template = read_template("rotary-engine", text.replace('A = "(r, 0)"', 'A = "(-r, 0)"'))
    solution = solve_template(template, {"r": "50", "l": "140", "phi": "30", "n": "600"})
    lines = displayed(told(solution))
    (place,) = (line for line in lines if line.startswith("OB &="))
    assert place.endswith(r"\approx 0.094449\,\unit{m}")
    assert any(r"v_{\mathrm{e}}\sin\delta" in line for line in lines), lines


def test_the_other_end_of_a_chord_takes_half_the_chord_off() -> None:
    text = (find_shipped("templates") / "rotary-engine.toml").read_text(encoding="utf-8")
    template = read_template("rotary-engine", text.replace(", upper)", ", lower)"))
    solution = solve_template(template, {"r": "50", "l": "140", "phi": "30", "n": "600"})
    (place,) = (line for line in displayed(told(solution)) if line.startswith("s &="))
    assert place == r"s &= x_{A}\cos\varphi - \sqrt{l^{2} - (x_{A}\sin\varphi)^{2}}"


def test_a_point_on_a_ray_along_an_axis_is_its_distance_away() -> None:
    # it was a share p/DG of the difference of both coordinates, with the length DG
    told = displayed(stated("square-on-two-fixed-points", side="0.4", p="0.1", q="0.1"))
    assert r"x_{A} &= x_{D} = -0.2\,\unit{m}" in told
    assert r"y_{A} &= y_{D} + p = -0.2\,\unit{m} + 0.1\,\unit{m} = -0.1\,\unit{m}" in told
    assert not [line for line in told if line.startswith(("DG", "DE"))]


@pytest.mark.parametrize(
    ("language", "likewise"), [("en", "Likewise for $B$"), ("zh", "同理，对 $B$ 点有")]
)
def test_the_composition_of_motions_is_explained_once_for_the_points_of_a_body(
    language: Language, likewise: str
) -> None:
    told = list(proses(kept("square-on-two-fixed-points", language=language)))
    assert sum(likewise in text for text in told) == 2
    assert sum("$B'$" in text for text in told) == 1


def test_the_angle_of_a_rod_of_given_length_follows_from_one_side_of_its_triangle() -> None:
    told = displayed(stated("slider-crank", phi="60", k="sqrt(3)", r="1"))
    assert any(line.startswith(r"\sin\psi_{AB} &= \frac{y_{A}}{k\,r} =") for line in told), told
    steep = displayed(kept("four-bar-by-lengths"))
    assert any(line.startswith(r"\cos\psi_{DC} &= \frac{x_{C} - x_{D}}{c} =") for line in steep), (
        steep
    )


def test_a_length_on_a_line_of_given_angle_follows_from_a_given_one() -> None:
    # it was a root of both coordinates, and stood in the table before it was found
    told = list(lines(kept("pin-in-disc-slot-and-rod")))
    found = [at for at, line in enumerate(told) if r"OM &= \frac{b}{\cos\varphi}" in line]
    used = [at for at, line in enumerate(told) if r"| $OM \cdot" in line]
    assert len(found) == 1
    assert found[0] < used[0]


def test_an_arm_is_found_before_the_table_that_takes_it() -> None:
    told = list(lines(kept("geneva-drive")))
    (found,) = (at for at, line in enumerate(told) if "Here $CP = " in line)
    used = [at for at, line in enumerate(told) if r"$CP \cdot" in line]
    assert found < min(used)


def test_rotations_that_are_given_stand_in_one_sentence() -> None:
    """Each had a sentence and a line of its own."""
    given = [text for text in proses(kept("pin-in-two-rings")) if text.startswith("Given")]
    velocities, accelerations = given
    assert velocities.count(r"\omega_{\text{ring ") == 2
    assert accelerations.count(r"\alpha_{\text{ring ") == 2


def test_coriolis_accelerations_in_one_frame_have_one_rule() -> None:
    (rule,) = (
        text for text in proses(kept("square-on-two-fixed-points")) if "right-hand rule" in text
    )
    assert rule.count("turned through") == 1
    assert [number for number in "12" if f"\\mathrm{{Cor}}{number}" not in rule] == []
