"""Tags follow from what a template asks; an author may add words."""

from __future__ import annotations

import pytest

from kinegrade.errors import TemplateError
from kinegrade.problem.template.library.library import load_template
from kinegrade.problem.template.tags import list_tags, select_asks
from tests.problem.crank import crank

UNASKED = ("points = 2, ", "")


@pytest.mark.parametrize(
    ("change", "tag"),
    [
        (("points = 2", "points = 2"), "velocity"),
        (
            ('"x(velocity(A))", unit = "m/s"', '"x(acceleration(A))", unit = "mm/s^2"'),
            "acceleration",
        ),
        (('"x(velocity(A))", unit = "m/s"', '"x(A)", unit = "m"'), "position"),
        (('means = { en = "along y"', 'points = 1, means = { en = "along y"'), "velocity"),
        (UNASKED, "position"),  # asks without points are on request alone
    ],
)
def test_the_highest_kind_that_has_points_is_the_tag(change: tuple[str, str], tag: str) -> None:
    assert list_tags(crank(change, kept=True)) == {tag}


def test_an_angular_acceleration_beside_velocities_makes_an_acceleration_problem() -> None:
    template = load_template("slider-crank")
    assert list_tags(template) == {"acceleration", "base-point"}
    assert select_asks(template, "velocity") == ("v_B", "omega_AB")
    assert select_asks(template, "acceleration") == ("alpha_AB", "a_B")
    assert select_asks(template, "position") == ()
    assert select_asks(template) == template.asked()


def test_the_author_adds_words() -> None:
    assert list_tags(
        crank(('family = "crank"', 'family = "crank"\ntags = ["dead-point", "easy"]'))
    ) == {
        "velocity",
        "dead-point",
        "easy",
    }


@pytest.mark.parametrize("value", ["[3]", '["Easy"]', '["two words"]', '[""]', f'["{"a" * 31}"]'])
def test_tags_are_short_words(value: str) -> None:
    with pytest.raises(
        TemplateError, match=r"^crank\.toml:3: tags\[1\]: .* - expected a short word"
    ):
        crank(('family = "crank"', f'family = "crank"\ntags = {value}'))


def test_tags_are_a_list() -> None:
    with pytest.raises(TemplateError, match=r'^crank\.toml:3: tags: "easy" - expected a list'):
        crank(('family = "crank"', 'family = "crank"\ntags = "easy"'))
