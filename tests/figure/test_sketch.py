"""What every figure keeps, whatever the mechanism: to scale, on its paper, nothing written over
anything.
"""

from __future__ import annotations

from collections.abc import Callable
from math import hypot
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec.structs import replace

from kinegrade.errors import TemplateError
from kinegrade.figure import sketch as sketching
from kinegrade.figure.mechanism.fitting import fit_scene
from kinegrade.figure.mechanism.layers import draw
from kinegrade.figure.mechanism.paper import scale_to_paper
from kinegrade.figure.placing.extent import measure_symbol
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.scene import (
    BOLD,
    FIRM,
    THIN,
    Bow,
    Disc,
    Outline,
    Scene,
    Strokes,
)
from kinegrade.figure.sketch import HEIGHT, WIDTH, draw_unit_figure, sketch
from kinegrade.mechanics.vector import Vector
from tests.figure.clear import faults
from tests.figure.guided_mechanisms import GUIDED
from tests.figure.mechanisms import (
    EIGHT,
    Case,
    follower_curvature,
    hinted,
    planetary_accelerations,
    planetary_velocities,
    slider_crank,
    slotted_bar,
)
from tests.figure.wheel_mechanisms import WITH_WHEELS

CASES = [
    pytest.param(build, values, id=f"{name}-{number}")
    for name, (build, postures) in {**EIGHT, **GUIDED, **WITH_WHEELS}.items()
    for number, values in enumerate(postures)
]


def check(scene: Scene) -> None:
    assert faults(scene, scene.width, scene.height) == []
    assert scene.width <= WIDTH
    assert scene.height <= HEIGHT


@pytest.mark.parametrize(("build", "values"), CASES)
def test_labels_are_clear_and_everything_is_on_the_paper(
    build: Callable[..., Case], values: tuple[float, ...]
) -> None:
    check(sketch(*build(*values)))


@settings(max_examples=15, deadline=None)
@given(st.floats(0.1, 0.5), st.floats(1.5, 4.0), st.integers(10, 170))
def test_slider_cranks_of_any_draw_are_clear(r: float, k: float, phi: int) -> None:
    check(sketch(*slider_crank(r, k, phi)))


@settings(max_examples=10, deadline=None)
@given(st.floats(0.04, 0.12), st.integers(15, 70))
def test_slotted_bars_of_any_draw_are_clear(length: float, theta: int) -> None:
    check(sketch(*slotted_bar(length, theta)))


def centres(scene: Scene) -> list[Vector]:
    return [part.centre for part in scene.primitives if isinstance(part, Disc)]


def test_the_scale_is_true_for_both_axes() -> None:
    scene = sketch(*slider_crank(0.2, 1.75, 60))
    o, a, b = sorted(centres(scene), key=lambda centre: centre.x)
    assert hypot(a.x - o.x, a.y - o.y) == pytest.approx(0.2 * scene.scale)
    assert hypot(b.x - a.x, b.y - a.y) == pytest.approx(0.35 * scene.scale)


def test_gears_touch_and_are_drawn_by_their_pitch_circles() -> None:
    case = planetary_velocities(0.3, 0.2, 30)
    drawing = draw(scale_to_paper(case[0], 40.0), case[1])
    sun, planet = drawing.rims
    assert (sun.kind, planet.kind) == ("gear", "gear")
    assert hypot(planet.at.x - sun.at.x, planet.at.y - sun.at.y) == pytest.approx(
        sun.radius + planet.radius
    )


def test_a_cam_is_a_closed_profile_not_its_circle_of_curvature() -> None:
    mechanism, hints = follower_curvature(0.3, 30, 0.25)
    parts = draw(scale_to_paper(mechanism, 60.0), hints).primitives
    closed = [part for part in parts if isinstance(part, Outline) and part.closed]
    assert max(len(part.corners) for part in closed) > 60
    curvature_centre = mechanism.points["K"] * 60.0
    assert [
        part for part in parts if isinstance(part, Disc) and part.centre == curvature_centre
    ] == []


def symbols(case: Case) -> set[str]:
    return {label.symbol for label in sketch(*case).labels}


def test_free_ends_carry_the_letters_of_their_bodies() -> None:
    assert {"A", "B", "C", "D", "E"} <= symbols(slotted_bar(0.06, 30))


def test_a_link_between_its_two_points_carries_its_length_as_a_letter() -> None:
    scene = sketch(*slider_crank(0.2, 1.75, 60))
    thin = [part for part in scene.primitives if isinstance(part, Strokes) and part.pen == THIN]
    assert {"r", "k r"} <= {label.symbol for label in scene.labels}
    # No dimension: two extensions and a line
    assert sum(len(part.lines) for part in thin if len(part.lines) == 3) == 0


def test_a_length_divided_by_another_point_gets_a_dimension_line() -> None:
    scene = sketch(*planetary_accelerations(0.6, 0.2, 40))  # C lies between O1 and O
    thin = [part for part in scene.primitives if isinstance(part, Strokes) and part.pen == THIN]
    assert 3 in [len(part.lines) for part in thin]


def test_an_angle_of_zero_has_no_mark() -> None:
    assert "\\varphi" not in symbols(planetary_velocities(0.3, 0.2, 0))
    assert "\\varphi" in symbols(planetary_velocities(0.3, 0.2, 200))


def test_an_arrow_follows_the_sign_of_what_is_imposed() -> None:
    mechanism, hints = slider_crank(0.2, 1.75, 60)
    bows = [
        part
        for part in sketch(mechanism, hints).primitives
        if isinstance(part, Bow) and part.pen == FIRM
    ]
    assert [bow.sweep < 0 for bow in bows] == [True]


def test_without_hints_the_mechanism_and_its_points_are_drawn() -> None:
    mechanism, _ = slider_crank(0.2, 1.75, 60)
    scene = sketch(mechanism)
    assert {label.symbol for label in scene.labels} == {"O", "A", "B"}
    bold = [part for part in scene.primitives if isinstance(part, Strokes) and part.pen == BOLD]
    assert len(bold) == 2


def test_the_same_mechanism_gives_the_same_figure() -> None:
    assert sketch(*slotted_bar(0.06, 30)) == sketch(*slotted_bar(0.06, 30))


@pytest.mark.parametrize(
    ("table", "message"),
    [
        ({"radii": [{"symbol": "r", "centre": "O"}]}, 'figure.radii: no circle about "O"'),
        (
            {"radii": [{"symbol": "r", "centre": "O", "through": "B"}]},
            'no circle through "B" about "O"',
        ),
        (
            {"labels": {"ground": "1"}},
            'figure.labels.ground: no circle and no bar of "ground" is drawn',
        ),
    ],
)
def test_a_hint_about_what_is_not_there_is_refused(table: dict[str, Any], message: str) -> None:
    mechanism, _ = slider_crank(0.2, 1.75, 60)
    with pytest.raises(TemplateError, match=message):
        sketch(*hinted(mechanism, **table))


def test_a_crowded_figure_is_tried_otherwise_and_smaller_before_it_is_given_up(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    mechanism, hints = slider_crank(0.2, 1.75, 47)
    scales: list[float] = []
    first: list[bool] = []  # whether the letter of a point came before that of a length

    def crowd(compose: Callable[[float], Layout], scale: float, span: tuple[float, float]) -> Scene:
        scene = fit_scene(compose, scale, span)
        order = [label.symbol for label in compose(scale).labels]
        first.append(order.index("A") < order.index("r"))
        scales.append(scene.scale)
        return replace(scene, crowded=("r", "k r") if len(scales) == 1 else ("r",))

    draw_unit_figure.cache_clear()
    monkeypatch.setattr(sketching, "fit_scene", crowd)
    tried = sketch(mechanism, hints)
    draw_unit_figure.cache_clear()
    assert tried.crowded == ("r",)
    assert scales == sorted(scales, reverse=True)
    assert first[:3] == [False, False, True]
    assert scales[1] == scales[2] == scales[0]
    assert scales[3] < 0.97 * scales[0]


def test_the_room_of_a_letter_holds_what_rises_above_and_falls_below_it() -> None:
    assert measure_symbol(r"\beta")[1] > measure_symbol("A")[1]
    assert measure_symbol(r"\beta_{1}")[1] > measure_symbol("A_{1}")[1]
