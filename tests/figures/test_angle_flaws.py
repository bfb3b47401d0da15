"""Each flaw of the letter of an angle is found where there is one, and none where there is none."""

from __future__ import annotations

import pytest
from shapely import Point

from kinegrade.problem.template.hints import Angle
from kinegrade.problem.template.library.library import load_template
from tests.figures.angle_flaws import find_angle_flaws, write_as_printed
from tests.figures.printed import read_printed
from tests.figures.test_flaws import draw, write
from tests.problem.draws import draw_filter, drawn

POINTS = {"O": Point(10.0, 15.0), "A": Point(24.0, 15.0)}
# Quarters of circles of 5 mm about O and A, between right and up
ARC = '<path d="M15 15A5 5 0 0 0 10 10" stroke-width="0.18"/>'
OTHER = '<path d="M29 15A5 5 0 0 0 24 10" stroke-width="0.18"/>'
ANGLES = (Angle(r"\varphi", "O", "right", "up"), Angle(r"\psi", "A", "right", "up"))
OUTWARD = '<path d="M13.54 11.46L16.3 8.7" stroke-width="0.18"/>'
WHEEL = '<circle cx="{}" cy="{}" r="4" fill="#ddd" stroke-width="0.4"/>'
ALONG = '<path d="M13.54 11.46L17 14.9" stroke-width="0.18"/>'


def find(*elements: str) -> list[str]:
    return find_angle_flaws(draw(ARC, OTHER, *elements), POINTS, ANGLES)


@pytest.mark.parametrize(
    "elements",
    [
        (write("φ", 15.0, 11.0), write("ψ", 29.0, 11.0)),  # outside their arcs
        (write("φ", 12.2, 14.2),),  # inside
        (OUTWARD, write("φ", 17.4, 8.4)),  # at a leader
        (write("φ", 35.0, 11.0), write("φ", 15.0, 11.0)),  # two of one letter: it is not read
    ],
)
def test_a_letter_at_its_own_arc_has_no_flaw(elements: tuple[str, ...]) -> None:
    assert find(*elements) == []


@pytest.mark.parametrize(
    ("elements", "flaw"),
    [
        ((write("φ", 20.0, 6.5),), "φ stands off from its arc"),
        (
            (write("φ", 22.0, 10.6), write("ψ", 29.0, 11.0)),
            "φ stands as near to the arc of another angle",
        ),
        ((write("φ", 13.5, 18.5),), "φ stands outside its angle"),
        ((ALONG, write("φ", 18.2, 16.6)), "φ has a leader that runs on from its arc"),
    ],
)
def test_a_flaw_of_an_angle_is_found(elements: tuple[str, ...], flaw: str) -> None:
    assert flaw in find(*elements)


def test_an_arc_through_a_wheel_is_a_flaw_unless_a_side_leads_to_its_centre() -> None:
    letter = write("φ", 15.0, 9.0)
    beside, ahead = WHEEL.format(15.0, 9.5), WHEEL.format(14.5, 15.0)
    assert find_angle_flaws(draw(beside, ARC, letter), POINTS, ANGLES) == [
        "φ has an arc through a wheel beside its angle"
    ]
    assert find_angle_flaws(draw(ahead, ARC, letter), POINTS, ANGLES) == []


@pytest.mark.parametrize(
    ("template", "seed"),
    [
        ("bar-pushing-rolling-disc", "q2"),
        ("bent-rod-tangent-disc", "2911a"),
        ("bar-pushing-rolling-disc", "s1"),
        ("oscillating-flat-faced-follower", "t1"),
        ("stone-crusher", "a3"),
        ("pin-in-disc-slot-and-rod", "bq1"),
        ("pose-cam-tappet", "m4"),
        ("differential-epicyclic-train", "m2"),
    ],
)
def test_arcs_keep_out_of_wheels_and_letters_from_arcs_to_come(template: str, seed: str) -> None:
    [instance] = drawn(draw_filter(load_template(template), seed), 1)
    printed = read_printed(instance.solution)
    assert find_angle_flaws(printed.picture, printed.points, printed.hints.angles) == []


def test_a_letter_nearer_to_another_point_than_to_its_arc_is_found() -> None:
    letter = write("φ", 17.0, 10.5)
    for beside, flaws in (
        (Point(17.6, 10.6), ["φ stands nearer to another point than to its arc"]),
        (Point(22.0, 9.6), []),
    ):
        points = {**POINTS, "B": beside}
        assert find_angle_flaws(draw(ARC, letter), points, ANGLES) == flaws


HEAD = '<path d="M15 15L14.4 13.2L15.3 13.1Z" fill="#000" stroke="none"/>'
HATCHING = '<path d="M{0} 11L{1} 12M{1} 11L{2} 12M{2} 11L{3} 12" stroke-width="0.18"/>'


def test_an_arrowhead_at_another_point_is_found() -> None:
    letter = write("φ", 15.0, 11.0)
    for x, flaws in ((15.9, ["φ has its arrowhead at another point"]), (18.0, [])):
        points = {**POINTS, "B": Point(x, 15.2)}
        assert find_angle_flaws(draw(ARC, HEAD, letter), points, ANGLES) == flaws


def test_an_arc_through_the_hatching_of_a_support_is_found() -> None:
    letter = write("φ", 12.2, 14.2)
    for x, flaws in ((13.6, ["φ has an arc through hatching"]), (17.0, [])):
        support = HATCHING.format(x, x - 0.8, x - 1.6, x - 2.4)
        assert find_angle_flaws(draw(ARC, support, letter), POINTS, ANGLES) == flaws


def test_symbols_are_written_as_they_are_printed() -> None:
    assert write_as_printed(r"\theta_{A}") == "θA"
    assert write_as_printed(r"\psi") == "ψ"
