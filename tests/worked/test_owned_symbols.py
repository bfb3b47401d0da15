"""The symbol of each arrow in a worked solution stands nearest to its own arrow, or has a thin line
to it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import pytest

from kinegrade.figure.plane import length
from kinegrade.figure.scene import Scene
from kinegrade.figure.vectors.arrows import VectorArrow, spare_short
from kinegrade.figure.vectors.chains import Arrow
from kinegrade.figure.vectors.mechanism import PointArrow
from kinegrade.figure.vectors.polygon import draw_polygon
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import find_template_names, load_template
from kinegrade.worked.steps import pictures, polygons
from tests.figure.vector_flaws import find_vector_flaws, list_arrows
from tests.problem.draws import draw_filter
from tests.problem.draws import drawn as draws_of
from tests.worked.draws import told

TWO_RINGS = {"omega_1": "5", "alpha_1": "-3", "omega_2": "1", "alpha_2": "5"}


def find_flaws(monkeypatch: pytest.MonkeyPatch, name: str, **values: str) -> list[list[str]]:
    """What is wrong in the pictures of vectors of one solution, each with a fault."""
    found: list[list[str]] = []

    def watch(
        draw: Callable[..., Scene], sides: Callable[..., Sequence[Arrow | PointArrow]]
    ) -> Any:
        def draw_and_judge(*given: Any) -> Scene:
            scene = draw(*given)
            found.append(
                find_vector_flaws(scene, [(one.symbol, one.value) for one in sides(*given)])
            )
            return scene

        return draw_and_judge

    with monkeypatch.context() as patch:
        on_mechanism = watch(pictures.draw_with_vectors, lambda *given: given[2])
        in_polygon = watch(polygons.draw_polygon, lambda *given: [*given[0], *given[1]])
        patch.setattr(pictures, "draw_with_vectors", on_mechanism)
        patch.setattr(polygons, "draw_polygon", in_polygon)
        told(solve_template(load_template(name), values))
    return [flaws for flaws in found if flaws]


@pytest.mark.sampled(12, first=3)
@pytest.mark.parametrize("name", find_template_names())
def test_each_symbol_stands_nearest_to_its_own_arrow(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    (draw,) = draws_of(draw_filter(load_template(name)), 1)
    for given in ({}, draw.values):
        assert find_flaws(monkeypatch, name, **given) == []


def test_the_symbol_of_a_short_arrow_beside_a_long_one_has_a_line(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """v_e2 stood beyond the long v_e1, that starts at the same pin."""
    assert find_flaws(monkeypatch, "pin-in-two-rings", R="0.3", d="-1.04", **TWO_RINGS) == []


def test_the_law_finds_a_symbol_that_stands_at_another_arrow() -> None:
    left = [Arrow("v_B", Vector(6.0, 0.0), known=False)]
    right = [Arrow("v_A", Vector(3.0, 4.0)), Arrow("v_{BA}", Vector(3.0, -4.0), known=False)]
    scene = draw_polygon(left, right)
    named = [(one.symbol, one.value) for one in (*left, *right)]
    assert find_vector_flaws(scene, named) == []
    swapped = [("v_A", right[1].value), ("v_{BA}", right[0].value), named[0]]
    assert len(find_vector_flaws(scene, swapped)) == 2


def test_the_heads_at_a_short_vector_leave_it_to_be_seen() -> None:
    """It was hidden under the head of the arrow before it."""
    arrows = [
        VectorArrow("a_1", Vector(0.0, 0.0), Vector(20.0, 0.0)),
        VectorArrow("a_2", Vector(20.0, 0.0), Vector(20.0, 2.0)),
        VectorArrow("a_3", Vector(20.0, 2.0), Vector(0.0, 9.0)),
    ]
    sizes = []
    for arrow in spare_short(arrows):
        tip, left, right = arrow.head_corners
        sizes.append(length((left + right) / 2 - tip))
    assert sizes == pytest.approx([1.2, 1.2, 2.4])


def test_a_vector_that_is_no_more_than_a_dot_is_left_out_and_the_polygon_is_closed() -> None:
    dot = Vector(0.08, 0.0)
    right = [Arrow("a_1", Vector(3.0, 4.0)), Arrow("a_2", dot), Arrow("a_3", Vector(3.0, -4.0))]
    scene = draw_polygon([Arrow("a", Vector(6.08, 0.0))], right)
    assert "a_2" not in {label.symbol for label in scene.labels}
    tips = [one.tip for one in list_arrows(scene.primitives)]
    assert sum(length(tip - tips[0]) < 0.01 for tip in tips) == 2
