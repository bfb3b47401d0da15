"""A profile of which only the curvature at the contact is known is no circle."""

from __future__ import annotations

import pytest

from kinegrade.language import Language
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import (
    find_shipped,
    find_template_names,
    load_template,
)
from kinegrade.problem.template.library.reading import read_template
from tests.worked.draws import kept, told
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
    texts = list(proses(kept(TRACED, language=language)))
    assert any(order in text for text in texts), texts
    assert not any(circle in text for text in texts), texts


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_circles_of_curvature_are_told_where_bodies_are_no_circles(name: str) -> None:
    joints = load_template(name).scheme.joints
    curved = [joint.text for joint in joints if " of curvature of " in joint.text]
    said = [text for text in proses(kept(name)) if "circle of curvature" in text]
    assert bool(said) == bool(curved), (curved, said)


def test_how_a_cam_is_drawn_says_nothing_of_its_mechanics() -> None:
    """A round cam whose figure was drawn as a made-up profile was said to have no circle."""
    text = (find_shipped("templates") / f"{TRACED}.toml").read_text(encoding="utf-8")
    whole = text.replace(" of curvature of cam", " of cam")
    drawn = whole.replace("[figure]", '[figure]\nshapes = { cam = "cam" }')
    texts = list(proses(told(solve_template(read_template("round", drawn, kept=True), {}))))
    assert any("A circle about" in text for text in texts), texts
    assert not any("circle of curvature" in text for text in texts), texts
