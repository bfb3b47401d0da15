"""One given misread: what a student gets, by hand in plain floats; where there is no occasion; what
draws keep apart; and that marks name it.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import cos, radians, sin, sqrt
from pathlib import Path

import pytest

import kinegrade
from kinegrade.problem.template.library.library import load_template
from kinegrade.students.mistaking.mistake_kinds import find_candidates
from tests.small_class import asks_of, key_lines, table
from tests.small_class import kinegrade as run
from tests.spellings import type_answers

GIVENS = {"supplementary-angle", "one-length-for-another", "diameter-for-radius"}


def find_labels(template: str) -> set[str]:
    loaded = load_template(template)
    asks = {name: loaded.asks[name] for name in loaded.asked()}
    return {
        mistake.label
        for mistake in find_candidates(loaded, asks)
        if mistake.identifier in GIVENS and mistake.given
    }


@pytest.mark.parametrize(
    ("template", "labels"),
    [
        ("slider-crank", {"supplementary-angle.phi"}),
        ("rolling-wheel-pole-acceleration", set()),  # one radius, no angle
        ("pose-four-bar-coupler", {"supplementary-angle.theta"}),  # its lengths are all rods
        (  # a direction that turns all round has no supplement
            "planetary-gear-external-rim-velocities",
            {
                "one-length-for-another.r1.r2",
                "one-length-for-another.r2.r1",
                "diameter-for-radius.r1",
                "diameter-for-radius.r2",
            },
        ),
        (  # theta runs from -30 to 30 degrees
            "flat-faced-follower-curvature-radius",
            {"one-length-for-another.r.rho", "one-length-for-another.rho.r"},
        ),
        (  # the flange, which no joint knows, is a radius in the figure
            "rolling-wheel-rim-points",
            {"diameter-for-radius.r", "diameter-for-radius.R"},
        ),
    ],
)
def test_which_givens_can_be_misread_alone(template: str, labels: set[str]) -> None:
    assert find_labels(template) == labels


def slide(r: float, k: float, phi: float, omega: float) -> float:
    """The speed of the slider of a crank of length r and a rod k r."""
    return r * omega * sin(phi) * (1 + cos(phi) / sqrt(k * k - sin(phi) ** 2))


def test_the_supplement_of_an_angle() -> None:
    solved = kinegrade.template("slider-crank").solve(r="0.2", k=2, phi=30, omega=3)
    assert solved["v_B"].value == pytest.approx(slide(0.2, 2, radians(30), 3))
    wrong = solved["v_B"].mistakes["supplementary-angle.phi"]
    assert wrong == pytest.approx(slide(0.2, 2, radians(150), 3))


def test_a_right_angle_is_its_own_supplement() -> None:
    solved = kinegrade.template("slider-crank").solve(r="0.2", k=2, phi=90, omega=3, alpha=5)
    assert not [
        name for answer in solved.answers.values() for name in answer.mistakes if "." in name
    ]


def follow(r: float, rho: float, theta: float, omega: float) -> float:
    """The acceleration of a flat-faced follower, upwards, of a cam that turns uniformly."""
    return rho * omega**2 - r * omega**2 * cos(theta)


def test_the_radius_of_curvature_for_the_distance_of_the_contact() -> None:
    template = kinegrade.template("flat-faced-follower-curvature-radius")
    solved = template.solve(r="0.2", rho="0.27", theta=15, omega=4, eps=0)["a_BC_y"]
    theta = radians(15)
    assert solved.value == pytest.approx(follow(0.2, 0.27, theta, 4))
    assert solved.mistakes["one-length-for-another.r.rho"] == pytest.approx(
        follow(0.27, 0.27, theta, 4)
    )
    assert solved.mistakes["one-length-for-another.rho.r"] == pytest.approx(
        follow(0.2, 0.2, theta, 4)
    )


def test_one_wheel_for_the_other_and_the_diameter_of_one() -> None:
    # The planet turns with omega0 (r1 + r2)/r2 about a fixed sun
    template = kinegrade.template("planetary-gear-external-rim-velocities")
    solved = template.solve(r1="0.3", r2="0.2", phi=60, omega0=4)["omega_II"]
    assert solved.value == pytest.approx(4 * 0.5 / 0.2)
    assert solved.mistakes["one-length-for-another.r1.r2"] == pytest.approx(4 * 0.4 / 0.2)
    assert solved.mistakes["one-length-for-another.r2.r1"] == pytest.approx(4 * 0.6 / 0.3)
    assert solved.mistakes["diameter-for-radius.r1"] == pytest.approx(4 * (0.6 + 0.2) / 0.2)
    assert solved.mistakes["diameter-for-radius.r2"] == pytest.approx(4 * (0.3 + 0.4) / 0.4)
    assert "diameter-for-radius" not in solved.mistakes  # of both, which changes nothing


def test_the_diameter_of_a_track_and_of_a_flange() -> None:
    # A wheel of 0.2 on a track of 1, turning uniformly with 3: its centre runs about 1.2
    template = kinegrade.template("wheel-on-circular-track")
    solved = template.solve(R=1, r="0.2", theta=30, beta=60, omega=3, alpha=0)["a_O"]
    assert solved.value == pytest.approx(0.6**2 / 1.2)
    assert solved.mistakes["diameter-for-radius.R"] == pytest.approx(0.6**2 / 2.2)
    flange = kinegrade.template("rolling-wheel-rim-points").solve(r="0.4", R="0.6", v_O=2)["v_A3"]
    assert flange.value == pytest.approx(2 + 0.6 * 5)
    assert flange.mistakes["diameter-for-radius.R"] == pytest.approx(2 + 1.2 * 5)


BANK = """title = "Misread"
course = "Mechanics"
date = 2026-05-01
tolerance = { relative = "1 %" }

[[questions]]
template = "slider-crank"
draw = { phi = [30, 60, 75] }
asks = { v_B = 3 }

[[questions]]
template = "flat-faced-follower-curvature-radius"
draw = { eps = [0] }
asks = { a_BC_y = 2 }

[[questions]]
template = "planetary-gear-external-rim-velocities"
asks = { omega_II = 2 }
"""
Work = Mapping[str, float]  # what is given, by name, angles in degrees


def misread_slider_crank(given: Work) -> float:
    return slide(given["r"], given["k"], radians(180 - given["phi"]), given["omega"])


def misread_cam(given: Work) -> float:
    return follow(given["rho"], given["rho"], radians(given["theta"]), given["omega"])


def misread_planet(given: Work) -> float:
    return given["omega0"] * (2 * given["r1"] + given["r2"]) / given["r2"]


MISREAD = {
    "q1.v_B": (misread_slider_crank, "supplementary-angle"),
    "q2.a_BC_y": (misread_cam, "one-length-for-another"),
    "q3.omega_II": (misread_planet, "diameter-for-radius"),
}


def read_drawn(text: str) -> float:
    """A number as it was drawn: a decimal, a fraction or a square root."""
    if text.startswith("sqrt("):
        return sqrt(float(text[5:-1]))
    above, _, below = text.partition("/")
    return float(above) / float(below or 1)


def test_marks_name_what_was_misread_and_give_no_points(tmp_path: Path) -> None:
    (tmp_path / "bank.toml").write_text(BANK, encoding="utf-8")
    (tmp_path / "roster.csv").write_text("student,name\n1,A\n2,B\n3,C\n4,D\n", encoding="utf-8")
    exam, answers = tmp_path / "EXAM", tmp_path / "answers.csv"
    files = tmp_path / "bank.toml", tmp_path / "roster.csv"
    options = "--reproducible", "misread"
    assert run("generate", *files, "-o", exam, *options).exit_code == 0
    drawn = {
        (line["student"], question["question"]): {
            name: read_drawn(text) for name, text in question["drawn"].items()
        }
        for line in key_lines(exam)
        for question in line["questions"]
    }

    def misread(student: str, column: str) -> str:
        return f"{MISREAD[column][0](drawn[student, column[:2]]):.4g}"

    type_answers(exam, answers, misread)
    policy = tmp_path / "policy.toml"
    policy.write_text('credit.mistakes = { diameter-for-radius = "1/2" }', encoding="utf-8")
    result = run("grade", exam, answers, "-o", tmp_path / "MARKS", "--policy", policy)
    assert result.exit_code == 0, result.stderr
    assert len(asks_of(exam)) == 12
    for mark in table(tmp_path / "MARKS" / "marks.csv"):
        name = MISREAD[f"{mark['question']}.{mark['ask']}"][1]
        assert (mark["verdict"], mark["points"]) == (
            "mistake",
            "1" if name == "diameter-for-radius" else "0",
        )
        assert name in mark["mistakes"].split()
