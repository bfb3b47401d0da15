"""A figure that cannot be read well is told from one that can, and why."""

from __future__ import annotations

from dataclasses import replace

import pytest
from msgspec import structs

from kinegrade.figure.legibility import SMALLEST, find_illegible
from kinegrade.figure.scene import Scene
from kinegrade.figure.sketch import sketch
from kinegrade.language import ENGLISH
from kinegrade.language.catalogue import open_catalogue
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.problem.template.hints import FigureHints
from tests.figure.mechanisms import follower_circle, hinted, slider_crank


def explain(ratio: float, **changes: object) -> str:
    """Why the figure of a crank of 0.1 m and a rod so many times as long is refused, with changes
    to its scene; "" where it is not.
    """
    mechanism, hints = slider_crank(0.1, ratio, 60)

    def draw(shown: Mechanism, marked: FigureHints) -> Scene:
        return structs.replace(sketch(shown, marked), **changes)

    why = find_illegible(mechanism, hints, draw)
    return "" if why is None else open_catalogue(ENGLISH).write(why)


def test_an_ordinary_figure_is_legible() -> None:
    assert explain(2.0) == ""


@pytest.mark.parametrize(
    ("changes", "reason"),
    [
        ({"width": 75.1}, "the figure is larger than 75 mm by 55 mm"),
        ({"height": 55.1}, "the figure is larger than 75 mm by 55 mm"),
        ({"scale": 39.0}, "the length r from O to A is less than 4 mm in the figure"),
        ({"crowded": ("r", "k r")}, "r has no good place in the figure"),
    ],
)
def test_a_figure_is_refused_for_a_reason(changes: dict[str, object], reason: str) -> None:
    assert explain(2.0, **changes) == reason


@pytest.mark.parametrize(("along", "least"), [("horizontal", 0.05), ("vertical", 0.0866)])
def test_a_projected_length_counts_as_far_as_it_is_drawn(along: str, least: float) -> None:
    length = {"symbol": "h", "from": "O", "to": "A", "along": along}
    mechanism, hints = hinted(slider_crank(0.1, 2.0, 60)[0], lengths=[length])

    def draw(shown: Mechanism, marked: FigureHints) -> Scene:
        return structs.replace(sketch(shown, marked), scale=scale, crowded=())

    for share, refused in ((0.99, True), (1.01, False)):
        scale = share * SMALLEST / least
        assert (find_illegible(mechanism, hints, draw) is not None) is refused


def test_what_is_too_small_on_any_paper_is_not_drawn() -> None:
    def draw(shown: Mechanism, marked: FigureHints) -> Scene:
        raise AssertionError(shown, marked)

    assert find_illegible(*slider_crank(0.1, 30.0, 60), draw) is not None


@pytest.mark.parametrize(
    ("through", "said"),
    [
        (None, "the radius R about C is less than 4 mm in the figure"),
        ("O", "the radius about C is less than 4 mm in the figure"),  # it stands at another circle
    ],
)
def test_a_radius_that_is_too_small_has_its_symbol(through: str | None, said: str) -> None:
    mechanism, hints = follower_circle(0.05, 1.0, 30.0)
    marked = replace(hints, radii=(replace(hints.radii[0], through=through),))
    why = find_illegible(mechanism, marked)
    assert why is not None
    assert open_catalogue(ENGLISH).write(why) == said
