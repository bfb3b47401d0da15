"""What is read from a picture is what it shows, and each flaw is found where there is one."""

from __future__ import annotations

import pytest
from shapely import Point

from kinegrade.problem.template.library.library import find_template_names
from tests.figure.mechanisms import slider_crank
from tests.figures.flaws import find_flaws, find_part_flaws
from tests.figures.known import KNOWN
from tests.figures.svg_shapes import Picture, read_picture

LINE = '<path d="M2 10L38 10" stroke-width="0.4"/>'
COVER = '<circle cx="20" cy="10" r="4" fill="#fff" stroke-width="0.4"/>'
ARC = '<path d="M20 5A5 5 0 0 1 25 10" stroke-width="0.2"/>'
RACK = '<path d="M2 8L38 8L38 12L2 12Z" fill="#ddd" stroke-width="0.2"/>'
PINION = '<path d="M10 2L16 2L13 8.5Z" fill="#ddd" stroke-width="0.2"/>'
HEAD = '<path d="M39 5L41 5L40 7Z" fill="#000" stroke="none"/>'


def draw(*elements: str) -> Picture:
    """A picture of 40 mm by 20 mm."""
    return read_picture(
        '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 40 20">'
        f'<g font-size="3.2">{"".join(elements)}</g></svg>'
    )


def write(text: str, x: float, y: float) -> str:
    """A letter about x, on the baseline y."""
    return f'<text x="{x}" y="{y}"><tspan font-style="italic">{text}</tspan></text>'


def find(*elements: str) -> list[str]:
    return [flaw.split(" at ")[0] for flaw in find_flaws(draw(*elements))]


def test_a_letter_on_its_own_has_no_flaw() -> None:
    assert find(LINE, ARC, write("A", 10, 8)) == []


@pytest.mark.parametrize(
    ("elements", "flaw"),
    [
        ((LINE, write("A", 10, 11)), "A touches a line"),
        ((LINE, write("ψ", 10, 9.4)), "ψ touches a line"),
        ((ARC, write("A", 23.5, 7)), "A touches a line"),
        ((COVER, LINE, write("A", 20, 11)), "A touches a line"),
        ((write("A", 10, 8), write("B", 11, 8)), "A touches B"),
        ((write("A", 0.5, 8),), "A beyond the paper"),
        ((HEAD,), "an arrow beyond the paper"),
        ((RACK, PINION), "tooth on tooth"),
    ],
)
def test_a_flaw_is_found(elements: tuple[str, ...], flaw: str) -> None:
    assert find(*elements) == [flaw]


def test_gears_that_touch_or_lie_within_another_have_no_flaw() -> None:
    assert find(RACK, PINION.replace("8.5", "8")) == []
    assert find(RACK, '<path d="M9 9L13 9L11 11Z" fill="#ddd" stroke-width="0.2"/>') == []


def test_what_a_filled_shape_covers_is_not_seen() -> None:
    assert find(LINE, COVER, write("A", 20, 11)) == []


def test_an_arc_runs_on_the_side_that_its_flag_says() -> None:
    clockwise, other = ARC, ARC.replace("0 0 1", "0 0 0")
    on_it = Point(20 + 5 * 0.5**0.5, 10 - 5 * 0.5**0.5)
    assert draw(clockwise).ink[0].distance(on_it) == 0
    assert draw(other).ink[0].distance(on_it) > 1


def test_a_small_part_and_a_letter_at_another_point_are_found() -> None:
    mechanism, hints = slider_crank(0.2, 1.75, 60)
    pins = {name: (20 + 10 * at.x, 10 - 10 * at.y) for name, at in mechanism.points.items()}
    circles = [
        f'<circle cx="{x:.2f}" cy="{y:.2f}" r="0.5" stroke-width="0.2"/>' for x, y in pins.values()
    ]
    picture = draw(*circles, write("O", pins["A"][0], pins["A"][1] - 1), write("A", 22, 1))
    found = [flaw.split(" at ")[0] for flaw in find_part_flaws(picture, mechanism, hints, 10.0)]
    small = ["AB is 3.5 mm", "AO is 2.0 mm"]
    assert sorted(found) == [*small, "O stands nearer to A"]


@pytest.mark.parametrize(
    ("element", "message"),
    [
        ('<rect width="3"/>', "an element rect in a figure"),
        ('<path d="M1 1C2 2 3 3 4 4" stroke-width="1"/>', "a command C in a path"),
        (ARC.replace("0 0 1", "0 1 1"), "an arc of more than half a turn"),
    ],
)
def test_what_is_not_known_is_not_passed_over(element: str, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        draw(element)


def test_exceptions_name_templates() -> None:
    assert [name for name in KNOWN if name not in find_template_names()] == []
