"""Nothing is printed that no later line uses."""

from __future__ import annotations

import re

import pytest

from kinegrade.problem.template.library.library import find_template_names
from tests.worked.draws import kept
from tests.worked.telling import displayed, lines, proses


def test_a_coordinate_that_no_later_line_uses_is_not_told_where_a_place_is_asked_for_too() -> None:
    """F ends the flank of the cam and places nothing; y_C, told once as a distance, is in a check."""
    told = displayed(kept("tangent-cam-with-roller", 1))
    assert not [line for line in told if line.startswith(("x_{F}", "y_{F}"))]
    assert len([line for line in told if line.startswith("y_{C}")]) == 1
    assert len([line for line in told if line.startswith("OC &")]) == 1


def test_the_letter_of_a_rotation_stands_where_a_formula_uses_it() -> None:
    told = tuple(lines(kept("scissor-lift")))
    motions = told[told.index("# Types of motion") + 1]
    assert r"$BC$ ($\omega_{BC}$, $\alpha_{BC}$): plane motion" in motions
    assert r"the platform: translation" in motions


def test_a_letter_that_stands_for_a_component_has_no_bars() -> None:
    told = displayed(kept("spool-pulled-by-cord", 1))
    (line,) = (one for one in told if one.startswith("a_{E,x}"))
    assert line.startswith(r"a_{E,x} &= a_{C} - \alpha(y_{E} - y_{C})")


def test_a_primed_corner_of_a_polygon_is_explained_once() -> None:
    told = [
        one
        for one in proses(kept("flat-faced-follower-eccentric-circle"))
        if one.startswith("In the polygon, ")
    ]
    assert told == [
        "In the polygon, $c'$ denotes the point fixed to the follower that coincides with $C$."
    ]


@pytest.mark.sampled(12, first=1, also=("tangent-cam-with-roller", "differential-epicyclic-train"))
@pytest.mark.parametrize("name", find_template_names())
def test_an_origin_is_told_where_coordinates_follow(name: str) -> None:
    told = list(lines(kept(name)))
    for place, line in enumerate(told):
        if line.endswith("is the origin of the coordinates."):
            assert re.search(r"\b[xy]_\{", "\n".join(told[place + 1 :]))
