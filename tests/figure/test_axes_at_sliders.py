"""The axes of a frame whose origin is a slider, and what stands beside them."""

from __future__ import annotations

from itertools import pairwise

import pytest
from shapely import LineString

from kinegrade.figure.plane import length
from kinegrade.figure.scene import THIN, Disc, Outline, Scene
from kinegrade.figure.sketch import sketch
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.printed_givens import mark_question
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template
from tests.figure.clear import heads, lines

STROKE = 2.0  # millimetres of a stroke of hatching at most


def draw_rod(b: str, x_b: str) -> Scene:
    """A rod in a swivelling sleeve below the guide of its slider, at which its frame is."""
    template = load_template("pose-sleeve-slider-rod")
    solution = solve_template(template, {"b": b, "x_B": x_b})
    mechanism = solution.motion.frames.mechanism.map(float)
    return sketch(mechanism, mark_question(template, template.asked()))


def find_tip(scene: Scene, symbol: str) -> Vector:
    """The tip of the arrow that is nearest to its letter."""
    (letter,) = (label.centre for label in scene.labels if label.symbol == symbol)
    return min((head.corners[0] for head in heads(scene)), key=lambda tip: length(tip - letter))


def find_slider(scene: Scene) -> Vector:
    """The middle of the slider: the pin that is farthest up."""
    return max(
        (part.centre for part in scene.primitives if isinstance(part, Disc)), key=lambda at: at.y
    )


def find_axis(scene: Scene, symbol: str) -> LineString:
    tip = find_tip(scene, symbol)
    start, end = min(lines(scene, THIN), key=lambda line: length(line[1] - tip))
    return LineString([(start.x, start.y), (end.x, end.y)])


def list_thin(scene: Scene) -> list[LineString]:
    return [LineString([(a.x, a.y), (b.x, b.y)]) for a, b in lines(scene, THIN)]


@pytest.mark.parametrize("x_b", ["-1.2", "-0.7", "0.6", "1.0", "1.4"])
def test_the_hatching_of_a_guide_is_whole_where_an_axis_passes_through_it(x_b: str) -> None:
    scene = draw_rod("1.0", x_b)
    level = find_slider(scene).y
    feet = sorted(
        start.x
        for start, end in lines(scene, THIN)
        if start.y > level and start.y < end.y and length(end - start) < STROKE
    )
    assert max(right - left for left, right in pairwise(feet)) < 1.3


@pytest.mark.parametrize("x_b", ["-1.2", "-0.7", "0.6", "1.0", "1.4"])
def test_nothing_is_wiped_out_about_an_axis_in_the_hatching_of_a_guide(x_b: str) -> None:
    scene = draw_rod("1.0", x_b)
    assert not [
        part
        for part in scene.primitives
        if isinstance(part, Outline) and part.pen is None and part.fill == "white"
    ]


@pytest.mark.parametrize(
    ("x_b", "symbol"), [("-1.2", "x_2"), ("-0.7", "x_2"), ("0.8", "y_2"), ("1.4", "y_2")]
)
def test_an_axis_passes_between_the_strokes_along_it(x_b: str, symbol: str) -> None:
    scene = draw_rod("1.0", x_b)
    level = find_slider(scene).y
    strokes = [
        LineString([start, end])
        for start, end in lines(scene, THIN)
        if start.y > level and start.y < end.y and length(end - start) < STROKE
    ]
    middles = [stroke.centroid for stroke in strokes]
    assert min(find_axis(scene, symbol).distance(middle) for middle in middles) > 0.3


def test_the_number_of_a_body_is_not_at_the_tip_of_an_axis() -> None:
    scene = draw_rod("1.14", "0.78")
    (number,) = (label.centre for label in scene.labels if label.symbol == "2")
    assert length(number - find_tip(scene, "y")) > 6.0


def test_a_dimension_line_does_not_cross_an_axis_of_a_frame() -> None:
    scene = draw_rod("1.06", "-0.64")
    height = 1.06 * scene.scale
    (dimension,) = (line for line in list_thin(scene) if abs(line.length - height) < 0.1)
    assert not dimension.intersects(find_axis(scene, "y_2"))


def test_the_axes_on_which_the_corners_of_a_plate_slide_reach_beyond_these() -> None:
    template = load_template("triangle-pose-three-frames")
    solution = solve_template(template, {"l": "1", "alpha": "60", "phi_1": "35"})
    mechanism = solution.motion.frames.mechanism.map(float)
    scene = sketch(mechanism, mark_question(template, template.asked()))
    assert find_tip(scene, "x").x > mechanism.points["C"].x * scene.scale
    assert find_tip(scene, "y").y > mechanism.points["B"].y * scene.scale
