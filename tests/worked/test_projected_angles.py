"""The angle by which a vector is projected is derived before: from what its line makes with the axis."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from math import atan2, degrees

import pytest

from kinegrade.language import Language
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.library.library import find_template_names
from tests.worked.draws import drawn, kept, stated
from tests.worked.telling import proses

PLAIN = str.maketrans("", "", "_{}")


def _read(name: str, language: Language = "en") -> str:
    return "\n".join(proses(kept(name, 0, None, language)))


def test_a_velocity_normal_to_a_link_has_the_angle_of_the_link_with_the_other_axis() -> None:
    reason = (
        r"$CB$ makes $\beta$ with the $y$ axis, so $\boldsymbol{v}_{B} \perp CB$ makes $\beta$ "
    )
    assert reason + "with the $x$ axis. Projecting on the $x$ axis" in _read("toggle-press")


def test_two_links_have_an_angle_between_them() -> None:
    reason = (
        r"$\angle CBD$ is $180^\circ - 2\beta$, so $\boldsymbol{v}_{B} \perp CB$ "
        r"makes $90^\circ - 2\beta$ with $BD$."
    )
    assert reason in _read("toggle-press")


def test_a_line_that_no_mark_of_the_figure_touches_has_its_angle_from_the_one_marked() -> None:
    # theta is drawn between OE and the vertical, and the flank EF is normal to OE
    assert r"$FE \perp OE$ makes $\theta$ with the $x$ axis" in _read("tangent-cam-with-roller")


def test_vectors_along_one_another_have_the_angle_together() -> None:
    together = (
        r"$\boldsymbol{v}_{\mathrm{a}},\ \boldsymbol{v}_{A} \parallel x$ make $90^\circ - \beta$ with "
        "the normal to $MA$"
    )
    assert together in _read("crank-rod-over-translating-pin")


def test_an_acceleration_known_by_its_two_parts_has_the_angle_of_its_link() -> None:
    reason = (
        r"$\angle DGB$ is $180^\circ - \beta$, so "
        r"$\boldsymbol{a}_{G}^{\mathrm{t}} \perp DG$ makes $90^\circ - \beta$ with $GB$"
    )
    assert reason in _read("stone-crusher")


@pytest.mark.parametrize("name", ["toggle-press", "slider-crank"])
def test_the_angle_of_two_lines_is_told_once(name: str) -> None:
    sentences = [text.split(". ")[0] for text in proses(kept(name)) if "Projecting" in text]
    reasons = [text for text in sentences if not text.startswith("Projecting")]
    assert len(reasons) == len({*reasons}) > 0


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("de", r"also bildet $\boldsymbol{v}_{B} \perp CB$ mit der $x$-Achse den Winkel $\beta$."),
        ("zh", r"故 $\boldsymbol{v}_{B} \perp CB$ 与 $x$ 轴成 $\beta$ 角。"),
    ],
)
def test_it_is_said_in_every_language(language: Language, said: str) -> None:
    assert said in _read("toggle-press", language)


def test_a_line_that_a_sum_of_given_angles_places_has_its_angle_told() -> None:
    # its jaw is upright: v_B lies along x, and the figure has delta and beta, but not their sum
    values = {"OE": "0.34", "BG": "0.7", "AB": "0.65", "d": "0.85", "omega": "4", "alpha": "5"}
    angles = {"delta": "30", "beta": "55", "gamma": "95", "psi": "-70"}
    told = "\n".join(proses(stated("stone-crusher", **values, **angles)))
    assert r"$GB$ makes $\delta + \beta$ with the $y$ axis" in told


def test_two_lines_have_no_angle_beyond_a_straight_one() -> None:
    values = {"a": "45", "b": "170", "c": "100", "d": "160", "phi": "100", "n": "80"}
    told = "\n".join(proses(stated("four-bar-by-lengths", **values)))
    assert r"The angle between $AB$ and $DC$ is $\varphi + \psi_{DC} - 180^\circ$, so" in told
    assert r"Here $\varphi + \psi_{DC} = 100^\circ + 85.9257^\circ \approx 185.9257^\circ$." in told


def test_a_vector_makes_the_acute_angle_with_a_line_where_lines_turn_beyond_a_straight_one() -> (
    None
):
    # it was phi + psi - 90 degrees = 106.2 degrees, the supplement of what the projection takes
    values = {"a": "45", "b": "150", "c": "110", "d": "150", "phi": "130", "n": "160"}
    told = "\n".join(proses(stated("four-bar-by-lengths", **values)))
    acute = r"makes $270^\circ - (\varphi + \psi_{DC})$ with $DC$"
    assert rf"so $\boldsymbol{{v}}_{{B}} \perp AB$ {acute}" in told


def test_lines_make_no_obtuse_angle() -> None:
    """beta = 155 degrees: OA made beta with the x axis, and what is normal to it with the y axis."""
    told = " ".join(proses(stated("rod-sliding-on-driven-wheel", beta="155")))
    assert (
        r"$OA$ makes $180^\circ - \beta$ with the $x$ axis, so $\boldsymbol{v}_{A} \perp OA$ makes "
        r"$180^\circ - \beta$ with the $y$ axis"
    ) in told


LINE = r"\$(?:\\overrightarrow\{)?([A-Z](?:_\{\d\})?)([A-Z](?:_\{\d\})?)(\})?\$"
BETWEEN = re.compile(rf"angle between {LINE} and {LINE} is")
OBTUSE = ("rod-sliding-on-driven-wheel", "stone-crusher")  # have such an angle as published


def _measure_corner(letters: Sequence[str], points: Mapping[str, Vector]) -> float:
    """The angle of two directions, in degrees."""
    first, second, third, fourth = (points[each.translate(PLAIN)] for each in letters)
    one, other = second - first, fourth - third
    return abs(degrees(atan2(float(one.cross(other)), float(one.dot(other)))))


@pytest.mark.sampled(12, first=1, also=OBTUSE)
@pytest.mark.parametrize("name", find_template_names())
def test_an_obtuse_angle_is_one_of_vectors(name: str) -> None:
    """CB and BD were said to make 2 beta = 100 degrees, where the bars make 80 degrees at B."""
    seen = set[bool]()
    for place, solution in enumerate(drawn(name)):
        points = solution.motion.points
        told = "\n".join(proses(kept(name, place)))
        for one, two, arrow, three, four, _ in BETWEEN.findall(told):
            if {each.translate(PLAIN) for each in (one, two, three, four)} <= {*points}:
                obtuse = _measure_corner((one, two, three, four), points) > 90
                assert bool(arrow) == obtuse, (one, two, three, four)
                seen.add(obtuse)
    assert True in seen or name not in OBTUSE


def test_bars_with_a_common_pin_make_the_angle_of_their_triangle() -> None:
    told = "\n".join(proses(stated("toggle-press", beta="50")))
    assert r"$\angle CBD$ is $180^\circ - 2\beta$, so" in told


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", r"$\angle AMB$ is $180^\circ - 2\theta$, so"),
        ("de", r"$\angle AMB$ ist $180^\circ - 2\theta$, also"),
        ("zh", r"$\angle AMB$ 等于 $180^\circ - 2\theta$，故"),
    ],
)
def test_two_sides_of_a_triangle_make_its_angle(language: Language, said: str) -> None:
    # 2 theta, the exterior angle, was said of AM and MB
    page = "\n".join(proses(stated("scissor-lift", language, theta="55")))
    assert said in page
    assert r"$2\theta - 90^\circ$" in page


@pytest.mark.parametrize(
    ("language", "joint"),
    [("en", r"$BA$ and "), ("de", r"$\theta$ und bildet "), ("zh", r"$\theta$ 角，")],
)
def test_angles_of_two_vectors_are_two_clauses(language: Language, joint: str) -> None:
    """A word that joins nouns alone stood between them in Chinese."""
    told = _read("slotted-bar-between-two-rods", language)
    assert rf"{joint}$\boldsymbol{{v}}_{{A}} \parallel y$" in told
