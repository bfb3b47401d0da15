"""Points are placed, and coordinates worked out, only where a solution refers to them."""

from __future__ import annotations

import re

import pytest

from kinegrade.expressions.tree import Call, walk
from kinegrade.language import Language
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import find_template_names, load_template
from kinegrade.problem.template.notation import write_point_symbol
from kinegrade.worked.answers.poses import is_positional
from kinegrade.worked.case import Case
from kinegrade.worked.document import Heading, Prose
from kinegrade.worked.positions.positions import explain_positions
from kinegrade.worked.solution import write_worked_solution
from tests.problem.draws import draw_filter
from tests.problem.draws import drawn as draws_of
from tests.worked.chains import chains
from tests.worked.draws import stated
from tests.worked.telling import displayed as lines
from tests.worked.telling import proses


def test_only_the_points_wanted_and_those_they_need_are_told() -> None:
    solution = solve_template(load_template("slider-crank"), {})
    assert {left for left, _ in chains(explain_positions(Case(solution, "en"), ["A"]).write())} == {
        "x_{A}",
        "y_{A}",
    }


@pytest.mark.parametrize(
    ("name", "place", "told"),
    [
        ("stone-crusher", "$F$ lies at", False),  # only drawn
        ("wheel-on-circular-track", "$E$ lies at", False),  # marks an angle in the figure
        ("wheel-on-circular-track", "$D$ lies at", True),  # the pole, about which B turns
        ("slider-crank", "$A$ lies at", True),
    ],
)
def test_a_point_is_placed_only_where_the_solution_uses_it(
    name: str, place: str, told: bool
) -> None:
    template = load_template(name)
    blocks = write_worked_solution(solve_template(template, {}), template.asked(), "en").blocks
    places = [text for text in proses(blocks) if text.startswith(place)]
    assert bool(places) == told


def is_plainly_placed(name: str) -> bool:
    """Whether no point is met or reached by a longer construction, which is told as a whole."""
    trees = load_template(name).scheme.points.values()
    calls = {part.function for tree in trees for part in walk(tree) if isinstance(part, Call)}
    return not calls & {"meet", "foot", "toward"}


@pytest.mark.parametrize("name", list(filter(is_plainly_placed, find_template_names()))[::4])
def test_coordinates_are_worked_out_where_something_refers_to_them(name: str) -> None:
    [drawn] = draws_of(draw_filter(load_template(name), "used"), 1)
    template = drawn.solution.template
    asked = (template.asks[name] for name in template.asked())
    moving = [ask.name for ask in asked if not is_positional(ask)]
    blocks = write_worked_solution(drawn.solution, moving, "en").blocks
    told = [*lines(blocks), *(block.text for block in blocks if isinstance(block, Prose))]
    letters = {write_point_symbol(point) for point in template.scheme.points}
    coordinates = {f"{axis}_{{{letter}}}" for axis in "xy" for letter in letters}
    for left in coordinates & {left for left, parts in chains(blocks) if parts != ["0"]}:
        assert sum(left in line for line in told) > 1, left


def test_a_coordinate_that_only_its_square_refers_to_is_worked_out() -> None:
    [drawn] = draws_of(draw_filter(load_template("rolling-wheel-rim-points"), "square"), 1)
    asked = drawn.solution.template.asked()
    blocks = write_worked_solution(drawn.solution, asked, "en").blocks
    lefts = {left for left, _ in chains(blocks)}
    squared = set(re.findall(r"([xy]_\{[A-Z]_?\{?\d?\}?\})\^", " ".join(lines(blocks))))
    assert squared
    assert squared <= lefts


def test_a_solution_without_coordinates_has_no_chapter_on_positions() -> None:
    [drawn] = draws_of(draw_filter(load_template("stepped-drum-on-two-ropes"), "used"), 1)
    asked = drawn.solution.template.asked()
    blocks = write_worked_solution(drawn.solution, asked, "en").blocks
    assert "Positions" not in [block.text for block in blocks if isinstance(block, Heading)]


@pytest.mark.parametrize(
    ("language", "reason"),
    [
        ("en", "$A$ slides along the $x$ axis."),
        ("de", "$A$ gleitet auf der $x$-Achse."),
        ("zh", "$A$ 沿 $x$ 轴滑动。"),
    ],
)
def test_a_coordinate_that_a_track_gives_is_not_worked_out(language: Language, reason: str) -> None:
    """y_A = 0.9464 m - 1.65 m sin 35 degrees was said to be about 0: A is on the ground."""
    page = stated("rod-ground-and-incline", language, l="1.65", theta="35", gamma="98")
    texts = tuple(proses(page))
    assert any(text.startswith(reason) for text in texts), texts
    assert [line for line in lines(page) if line.startswith("y_{A}")] == ["y_{A} &= 0"]
