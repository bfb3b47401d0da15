"""Answers about poses: what they compare, which angles they mean, and where these come from."""

from __future__ import annotations

import re

import pytest

from kinegrade.language import Language
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template
from tests.worked.chains import chains
from tests.worked.draws import drawn, kept, stated
from tests.worked.telling import proses
from tests.worked.test_checks import RELATION, find_checks
from tests.worked.test_independent_checks import write

TRIANGLE = "triangle-pose-three-frames"
POSES = [TRIANGLE, "pose-cam-tappet", "pose-four-bar-coupler", "pose-sleeve-slider-rod"]
GIVEN = {"l": "0.38", "alpha": "70", "phi_1": "15"}
NAMELESS = re.compile(
    r"\b(?:The|the) angle (?:is|lies)\b|\b[Dd]er Winkel (?:wird|ist|liegt)\b|该角[由在为]"
)


@pytest.mark.parametrize("name", POSES)
def test_no_check_compares_a_quantity_with_the_formula_that_has_given_it(name: str) -> None:
    """BA from coordinates, and the same coordinates again."""
    blocks = write(drawn(name)[0]).blocks
    derived = {frozenset((left, parts[0])) for left, parts in chains(blocks) if parts}
    for check in find_checks(blocks):
        first = frozenset(RELATION.split(side)[0].strip() for side in (check.left, check.right))
        assert first not in derived


def test_a_distance_by_which_a_point_was_placed_is_no_check() -> None:
    """cos^2 + sin^2 = 1 was all that it found."""
    solution = solve_template(load_template(TRIANGLE), GIVEN)
    ways = [check.way for check in find_checks(write(solution).blocks)]
    assert [way for way in ways if "distance" in way] == []


def test_a_point_on_a_line_and_a_circle_is_checked_by_the_law_of_cosines() -> None:
    """Its coordinates were put back into the equation of the circle from which they came."""
    given = {"r": "0.4", "e": "0.2", "psi": "30"}
    (check,) = find_checks(write(solve_template(load_template("pose-cam-tappet"), given)).blocks)
    assert check.way == "the law of cosines in the triangle $OCA$"
    assert check.left.startswith(r"e^{2} + y_{A}^{2} - 2e\,y_{A}\sin\psi = (0.2\,\unit{m})^{2} + ")
    assert check.right == r"r^{2} = (0.4\,\unit{m})^{2} = 0.16\,\unit{m^2}"


def test_the_law_of_cosines_has_no_negative_angle() -> None:
    given = {"r": "0.66", "e": "0.3", "psi": "325"}
    (check,) = find_checks(write(solve_template(load_template("pose-cam-tappet"), given)).blocks)
    assert check.left.startswith(r"e^{2} + y_{A}^{2} + 2e\,y_{A}\sin\psi = ")


@pytest.mark.parametrize("language", ["en", "de", "zh"])
@pytest.mark.parametrize("name", POSES)
def test_an_angle_that_is_counted_or_lies_somewhere_is_named(name: str, language: Language) -> None:
    said = list(proses(kept(name, language=language)))
    assert [text for text in said if NAMELESS.search(text)] == []


@pytest.mark.parametrize(
    ("language", "told"),
    [
        ("en", r"$\varphi_{3}$ is the angle from the $x$ axis to "),
        ("de", r"$\varphi_{3}$ ist der Winkel von der $x$-Achse zum "),
        ("zh", r"$\varphi_{3}$ 为由 $x$ 轴转到 "),
    ],
)
def test_an_angle_is_named_before_its_tangent(language: Language, told: str) -> None:
    said = list(proses(stated(TRIANGLE, language=language, **GIVEN)))
    assert any(text.startswith(told) for text in said), said


def test_the_angle_in_a_sum_is_not_the_answer() -> None:
    r"""theta_2 = 360 degrees + \angle(u, v), of which the quadrant is told."""
    said = list(proses(stated(TRIANGLE, **GIVEN)))
    letters = r"$\angle(\boldsymbol{u},\boldsymbol{v})$"
    assert any(text.startswith(f"{letters} is the angle from ") for text in said), said
    assert any(f"{letters} lies between $-90^\\circ$ and $0^\\circ$" in text for text in said), said


@pytest.mark.parametrize(
    ("language", "told"),
    [
        (
            "en",
            r"$BA$ makes $\varphi_{1}$ with the $x$ axis and points upwards to the right, and "
            r"$\angle ABC = \alpha$; hence $BC$ makes $\alpha - \varphi_{1}$ with the $x$ axis and "
            "points downwards to the right.",
        ),
        (
            "zh",
            r"$BA$ 与 $x$ 轴成 $\varphi_{1}$ 角，指向右上方，且 $\angle ABC = \alpha$，"
            r"故 $BC$ 与 $x$ 轴成 $\alpha - \varphi_{1}$ 角，指向右下方。",
        ),
    ],
)
def test_an_inclination_that_coordinates_take_is_derived(language: Language, told: str) -> None:
    said = list(proses(stated(TRIANGLE, language=language, **GIVEN)))
    place = said.index(told)
    assert "$B$" in said[place + 1]
    assert said.count(told) == 1
