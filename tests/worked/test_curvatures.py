"""A profile of which only the curvature at the contact is known is no circle."""

from __future__ import annotations

import pytest

from kinegrade.language import Language
from kinegrade.problem.template.library.library import find_template_names, load_template
from tests.worked.draws import kept
from tests.worked.telling import proses

TRACED = "flat-faced-follower-curvature-radius"


@pytest.mark.parametrize(
    ("language", "order", "circle"),
    [
        ("en", "agrees to second order", "A circle about"),
        ("zh", "二阶吻合", "为圆心的圆与"),
        ("de", "bis zur zweiten Ordnung übereinstimmt", "Ein Kreis um"),
    ],
)
def test_a_circle_of_curvature_takes_the_place_of_a_profile_to_second_order(
    language: Language, order: str, circle: str
) -> None:
    """It said that a circle about K touches the face, of a cam that is none."""
    told = list(proses(kept(TRACED, language=language)))
    assert any(order in text for text in told)
    assert not any(circle in text for text in told)


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_circles_of_curvature_are_told_where_bodies_are_no_circles(name: str) -> None:
    figure = load_template(name).figure
    traced = {circle.body for circle in figure.circles}
    free = {body for body, shape in figure.shapes.items() if shape == "cam"} - traced
    assert any("circle of curvature" in text for text in proses(kept(name))) == bool(free)
