"""Figures that are alike are found, and those that differ are not taken for alike."""

from __future__ import annotations

import pytest

from kinegrade.problem.template.library.library import find_template_names
from tests.figures.likeness import (
    ALIKE,
    SELDOM,
    find_share_of_repeats,
    find_typical_difference,
    list_alike,
    measure_difference,
    trace,
)
from tests.figures.sheet import deal_figures, deal_subjects
from tests.figures.svg_shapes import read_picture
from tests.figures.test_flaws import draw

FLOOR = '<path d="M2 18L38 18" stroke-width="0.4"/>'
WALL = '<path d="M2 2L2 18" stroke-width="0.4"/>'
ROD = '<path d="M2 2L38 18" stroke-width="0.4"/>'
MIRRORED = '<path d="M38 2L2 18" stroke-width="0.4"/>'
SHORT_ROD = '<path d="M4 3L36 17" stroke-width="0.4"/>'


def compare(one: tuple[str, ...], other: tuple[str, ...]) -> float:
    return measure_difference(trace(draw(*one)), trace(draw(*other)))


def test_one_picture_twice_does_not_differ() -> None:
    assert compare((FLOOR, WALL, ROD), (FLOOR, WALL, ROD)) == 0
    assert compare((FLOOR, WALL, ROD), (FLOOR, WALL, SHORT_ROD)) == 0


def test_a_drawing_at_another_scale_does_not_differ() -> None:
    halved = [each.replace("38", "20").replace("18", "10") for each in (FLOOR, WALL, ROD)]
    assert compare((FLOOR, WALL, ROD), tuple(halved)) < 0.01


def test_every_stroke_counts_alike() -> None:
    assert compare((FLOOR, WALL, ROD), (FLOOR, WALL, MIRRORED)) == pytest.approx(0.3, abs=0.05)


def test_a_template_whose_papers_are_alike_is_named() -> None:
    alike = [draw(FLOOR, WALL, ROD)] * 3
    assert list_alike("slider-crank", alike) == [
        "slider-crank: two papers differ in 0% of their strokes, not 8%"
    ]
    assert list_alike(next(iter(ALIKE)), alike) == []


def test_papers_of_a_template_differ() -> None:
    figures = deal_figures("crossed-belt-drive", "spring", 3)
    assert find_typical_difference(list(map(read_picture, figures))) > 0.3


def test_exceptions_name_templates() -> None:
    assert [name for name in ALIKE if name not in find_template_names()] == []


def test_the_share_of_repeats_is_that_of_pairs() -> None:
    [subject] = deal_subjects("slider-crank", "spring", 1)
    assert find_share_of_repeats([subject, subject]) == 1
    assert find_share_of_repeats(deal_subjects("slider-crank", "spring", 2)) == 0


@pytest.mark.parametrize(
    "template",
    [
        "elliptic-trammel-end-driven",
        "guide-tube-rod-fixed-centrode",
        "planetary-gear-external-rim-accelerations",
        "ring-gear-planet-relative-spin",
        "rod-ground-and-incline",
        "slotted-bar-between-two-rods",
        "triangle-pose-three-frames",
    ],
)
def test_a_picture_is_seldom_dealt_twice(template: str) -> None:
    assert find_share_of_repeats(deal_subjects(template, "law", 30)) <= SELDOM
