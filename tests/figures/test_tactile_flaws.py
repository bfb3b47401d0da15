"""The measures of tactile sheets find what they are to find."""

from __future__ import annotations

import pytest

from kinegrade.figure.back_ends.svg import to_svg
from kinegrade.figure.scene import Disc, Pen, Primitive, Scene, Strokes
from kinegrade.mechanics.vector import Vector
from tests.figures.tactile_flaws import find_tactile_flaws


def stroke(level: float, width: float = 1.0) -> Strokes:
    """A level line of 50 mm."""
    return Strokes(((Vector(50.0, level), Vector(100.0, level)),), Pen(width))


def dot(x: float, y: float) -> Disc:
    """A dot of Braille."""
    return Disc(Vector(x, y), 0.75, None, "black")


@pytest.mark.parametrize(
    ("primitives", "flaw"),
    [
        ((stroke(100.0), stroke(103.5)), "lines 2.50 mm apart"),
        ((stroke(100.0, 0.6),), "a line of 0.6 mm"),
        ((stroke(100.0), dot(75.0, 104.0)), "Braille 2.75 mm from a line"),
        ((dot(75.0, 100.0), dot(75.0, 102.0)), "two dots of Braille on each other"),
        ((stroke(8.0),), "ink at the edge of the page"),
    ],
    ids=["lines", "pen", "label", "dots", "edge"],
)
def test_a_fault_of_each_kind_is_found(primitives: tuple[Primitive, ...], flaw: str) -> None:
    flaws = list(find_tactile_flaws(to_svg(Scene(210.0, 297.0, 1.0, primitives))))
    assert len(flaws) >= 1
    assert flaw in flaws[0]


def test_a_page_of_another_size_is_found() -> None:
    assert "a page of" in next(
        find_tactile_flaws(to_svg(Scene(100.0, 100.0, 1.0, (stroke(50.0),))))
    )


def test_lines_that_keep_apart_or_meet_have_no_flaw() -> None:
    scene = Scene(
        210.0, 297.0, 1.0, (stroke(100.0), stroke(104.6), stroke(100.5), dot(75.0, 120.0))
    )
    assert list(find_tactile_flaws(to_svg(scene))) == []
