"""An arc of an angle that seems to end elsewhere is found, and none where its ends stand free."""

from __future__ import annotations

import pytest

from tests.figures.arc_end_flaws import find_arc_end_flaws
from tests.figures.printed import read_printed
from tests.figures.sheet import deal
from tests.figures.test_flaws import draw

# A quarter of a circle of 8 mm about (10, 15) from right to up, with its head on the upright side
ARC = (
    '<path d="M18 15A8 8 0 0 0 10 7" stroke-width="0.18"/>'
    '<path d="M10 7L11.8 6.7L11.9 7.7Z" fill="#000" stroke="none"/>'
    '<path d="M10 15L10 5M10 15L20 15" stroke-width="0.18"/>'
)


def find(*elements: str) -> list[str]:
    return [flaw.split(" at ")[0] for flaw in find_arc_end_flaws(draw(*elements, ARC))]


def test_an_arc_between_its_sides_has_no_flaw() -> None:
    assert find() == []
    assert find('<path d="M14 2L14 18M5 6L25 6" stroke-width="0.18"/>') == []


def test_a_line_through_the_head_of_an_arc_is_found() -> None:
    assert find('<path d="M11.2 2L11.2 18" stroke-width="0.18"/>') == [
        "an arrowhead of an arc lies across a line"
    ]


def test_a_head_on_the_edge_of_a_bar_is_found() -> None:
    bar = '<path d="M8.6 20L8.6 2L11.4 2L11.4 20Z" fill="#ddd" stroke-width="0.4"/>'
    assert find(bar) == ["an arrowhead of an arc lies on an edge"]


def test_a_line_through_the_foot_of_an_arc_is_found() -> None:
    assert find('<path d="M16 13L20 17" stroke-width="0.18"/>') == [
        "a line runs through the end of an arc"
    ]


@pytest.mark.parametrize(
    ("template", "seed"),
    [
        ("crank-rocker-towed-wheel", "v71a"),
        ("guide-tube-rod-fixed-centrode", "w2"),
        ("eccentric-cam-offset-follower", "x91b"),
        ("guide-tube-rod-fixed-centrode", "x91a"),
        ("pin-in-disc-slot-and-rod", "x91a"),
        ("slotted-bar-between-two-rods", "v71a"),
    ],
)
def test_arcs_of_templates_end_where_nothing_else_is(template: str, seed: str) -> None:
    assert find_arc_end_flaws(read_printed(deal(template, seed)).picture) == []
