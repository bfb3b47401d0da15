"""Figures in words, as students read them."""

from __future__ import annotations

from kinegrade.description.description import describe
from kinegrade.description.said import Description
from kinegrade.language import Language
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import find_template_names, load_template
from kinegrade.worked.document import Prose
from tests.description.claims import find_numbers, list_faults
from tests.golden_files import Hold

ENGLISH, CHINESE, GERMAN = (Language(name) for name in ("en", "zh", "de"))


def described(name: str, language: Language = ENGLISH, **given: str) -> Description:
    """The description of a shipped template at these values."""
    template = load_template(name)
    found = describe(solve_template(template, given), language, template.asked())
    assert found is not None
    return found


def test_a_slider_crank_can_be_drawn_from_its_description() -> None:
    found = described("slider-crank", r="0.25", k="3/2", phi="60", omega="4", alpha="5")
    assert found.short == (
        "Slider-crank mechanism, drawn to scale: points O, A, B; OA turns clockwise"
    )
    assert [paragraph.text for paragraph in found.long] == [
        "The $x$ axis points to the right, the $y$ axis upwards. Directions are given by their "
        "angle with the $x$ axis, counter-clockwise. Given: $r = 0.25\\,\\unit{m}$, $k = 1.5$, "
        "$\\varphi = 60^\\circ$.",
        "Points of $OA$: $O$, $A$. Points of $AB$: $A$, $B$.",
        "$OA$ turns about the fixed pin $O$. $OA$ and $AB$ are pinned together at $A$. $B$ of $AB$ "
        "slides in a fixed straight guide along the $x$ axis.",
        "$O$ is the origin. $A$ lies at the distance $r$ from $O$ in the direction $\\varphi$. $B$ "
        "is the right-hand intersection of the $x$ axis and the circle about $A$ of "
        "radius $k\\,r$.",
        "$OA$ turns clockwise with the angular velocity $\\omega = 4\\,\\unit{rad/s}$, speeding up "
        "with the angular acceleration $\\alpha = 5\\,\\unit{rad/s^2}$.",
    ]


def test_each_language_says_it_in_its_own_words() -> None:
    belt = described("crossed-belt-drive", GERMAN, r1="0.25", phi="300")
    assert belt.short == ("Gekreuzter Riemen an einem drehenden Steg, maßstäblich: Punkte O, A, B")
    assert "Gegeben: $r_{1} = 0{,}25\\,\\unit{m}$, " in belt.long[0].text
    assert (
        "Ein gekreuzter Riemen läuft ohne Schlupf um den Kreis um $A$ mit dem Radius $r_{2}$ (fest "
        "mit Riemenscheibe II verbunden) und um den Kreis um $O$ mit dem Radius $r_{1}$ (fest mit "
        "Riemenscheibe I verbunden); der Steg $OA$ trägt beide Mittelpunkte." in belt.long[2].text
    )
    rod = described("slotted-bar-between-two-rods", CHINESE)
    assert rod.long[3].text == (
        "点 $A$ 为坐标原点。在 $A$ 处由竖直向下的方向顺时针转到 $AB$ 的角为 $\\theta$。$A$ 到 $B$ 的"
        "距离为 $l_{AB}$。点 $B$ 在 $A$ 的左下方。"
    )


def test_an_angle_printed_without_its_sign_is_used_without_it() -> None:
    """The statement says 60 degrees, clockwise."""
    places = described("crossed-belt-drive", phi="300").long
    assert "$\\varphi = 60^\\circ$" in places[0].text
    assert "$A$ lies at the distance $l$ from $O$ in the direction $-\\varphi$." in places[3].text


def test_coordinates_that_are_asked_are_not_worked_out() -> None:
    """The corners of the plate follow from marks and guides: their coordinates are asked."""
    places = described("triangle-pose-three-frames").long[3].text
    assert "coordinates" not in places
    assert "The angle at $B$ from $BC$, counter-clockwise, to $BA$ is $\\alpha$." in places
    assert "$C$ lies below and to the right of $B$." in places


def test_what_marks_leave_open_is_constructed() -> None:
    """Nothing in the figure measures how far the wheel is from the pin of the bar."""
    found = described("bar-pushing-rolling-disc").long
    assert "Lengths that follow: $l = \\frac{R\\sin\\varphi}{1 - \\cos\\varphi}$." in found[0].text
    assert "$C$ has the coordinates $x = l$ and $y = R$." in found[3].text


def test_a_motion_relative_to_another_body_says_so() -> None:
    found = described("slider-crank-relative-rotation-driver")
    assert found.long[-1].text.startswith("Relative to $OA$, $AB$ turns counter-clockwise")
    assert "turns" not in found.short


def test_a_motion_without_words_in_the_statement_is_said_by_its_rates() -> None:
    motions = described("two-rods-driven-ends").long[-1].text
    assert motions.startswith(
        "$A$ of the rod $AC$ moves in the direction $\\gamma$ relative to the ground with the "
        "velocity $v_{A}$ and the acceleration $a_{A}$, positive in this direction."
    )


def test_accelerations_are_left_out_where_none_is_asked() -> None:
    template = load_template("slider-crank")
    solution = solve_template(template, {"alpha": "5"})
    found = describe(solution, ENGLISH, ("v_B",))
    assert found is not None
    assert "acceleration" not in found.long[-1].text


def test_points_of_givens_that_are_not_printed_are_left_out() -> None:
    """Where the rim point is not asked for, its angle is not given."""
    template = load_template("wheel-on-circular-track")
    solution = solve_template(template, {})
    found = describe(solution, ENGLISH, ("v_O",))
    assert found is not None
    text = " ".join(paragraph.text for paragraph in found.long)
    assert "$D$" in text
    assert "$B$" not in text
    assert "\\beta" not in text


def test_numbers_and_values_that_must_not_be_there_are_found() -> None:
    assert find_numbers("$r_{2} = 0{,}25\\,\\unit{m/s^2}$ and $\\frac{3R}{2}$") == {
        "0{,}25",
        "3",
        "2",
    }
    solution = solve_template(load_template("slider-crank"), {"r": "0.25", "phi": "15"})
    answer = solution["v_B"].decimal(3)
    told = Description(f"$OA$ {answer}", (Prose(f"$v_{{B}} = {answer}\\,\\unit{{m/s}}$"),))
    assert list(list_faults(told, solution, ("v_B",), ENGLISH)) == [
        f"{answer} is not printed in the statement",
        f"$v_{{B}} = {answer}\\,\\unit{{m/s}}$ is not printed in the statement",
        f"no short text: $OA$ {answer}",
        f"v_B = {{'{answer}'}} is told",
    ]


def test_all_descriptions(hold: Hold) -> None:
    """The figures of all templates in words, at their default values."""
    hold("descriptions.txt", "".join(map(write_described, find_template_names())))


def write_described(name: str) -> str:
    """The description of a template in its first language."""
    found = described(name)
    lines = (f"{name}: {found.short}", *(paragraph.text for paragraph in found.long))
    return "".join(f"{line}\n" for line in lines) + "\n"


def test_a_contact_that_leaves_two_positions_does_not_replace_a_length() -> None:
    """A disc of radius R touches the face from below, and might from above."""
    found = described("flat-faced-follower-eccentric-circle", theta_1="30").long[3].text
    assert "The distance from $O$ to $C$ is $e$." in found


def test_a_length_that_only_its_ends_name_is_no_measure() -> None:
    """Nothing says how long BC is; that C is higher than B by 2b does."""
    found = described("crank-slider-in-floating-link").long[3].text
    assert "The vertical distance from $B$ to $C$ is $2b$." in found
    assert "\\lambda BC" not in found
