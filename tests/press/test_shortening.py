"""A solution that would take more than two pages does without pictures that it can spare."""

from __future__ import annotations

from dataclasses import replace

import pytest

from kinegrade.press.binding.part import count_pages
from kinegrade.press.sheet import WorkedQuestion
from kinegrade.press.solutions.course import TextArea
from kinegrade.press.solutions.settings import Column
from kinegrade.press.solutions.shortening import list_shorter, shorten
from kinegrade.press.typst.press import TypstPress
from kinegrade.worked.document import Block, Heading, Picture, Pictures, Prose
from tests.press.solutions import ENGLISH_SOLUTION, polygon_scene

AREA = TextArea(Column(174.0, "latin"), 260.0)
SKETCH = Picture(polygon_scene(), "velocities", kind="velocities")
POLYGON = Picture(polygon_scene(), "velocity polygon", kind="polygon")
POLE = Picture(polygon_scene(), "pole")
CORNER = Prose("In the polygon, $c'$ is the point of the rod.", on_polygon=True)
LINES = tuple(Prose(f"Line {number}.", compact=True) for number in range(200))


def question(*blocks: Block) -> WorkedQuestion:
    return WorkedQuestion(1, "q1", "A crank", "It turns.", blocks, None)


def shown(asked: WorkedQuestion) -> list[str]:
    """The captions of the pictures, and the sentences on polygons."""
    told = list[str]()
    for block in asked.blocks:
        if isinstance(block, Pictures):
            told += [picture.caption for picture in block.pictures]
        elif isinstance(block, Prose) and block.on_polygon:
            told.append("corner")
    return told


STEPS = (Pictures((SKETCH, POLYGON)), CORNER, Pictures((POLYGON,)), Pictures((SKETCH,)))


def test_polygons_go_first_with_what_is_said_of_them_then_later_sketches() -> None:
    shorter = list_shorter(question(*STEPS, Pictures((POLE,))))
    assert [shown(one) for one in shorter] == [
        ["velocities", "velocities", "pole"],
        ["velocities", "pole"],
        ["pole"],
    ]


def test_the_second_check_goes_last_with_the_length_that_it_needs() -> None:
    first, length, second = (
        Prose("Check by a projection.", compact=True, on_check=True),
        Prose("Here AB = 3 m.", on_check=True),
        Prose("Check by a derivative.", compact=True, on_check=True),
    )
    shorter = list(list_shorter(question(first, Pictures((POLYGON,)), length, second)))
    assert [one.blocks for one in shorter] == [
        (first, length, second),
        (first, Pictures((POLYGON,))),
        (first,),
    ]


def test_a_solution_without_pictures_to_spare_stays_as_it_is() -> None:
    assert list(list_shorter(question(*LINES[:9], Pictures((POLE,))))) == []


@pytest.mark.parametrize(
    ("lines", "left"),
    [
        (80, ["velocities", "velocity polygon", "corner", "velocity polygon", "velocities"]),
        (95, ["velocities", "velocities"]),
        (108, ["velocities"]),
    ],
)
def test_only_so_many_pictures_go_that_two_pages_are_enough(lines: int, left: list[str]) -> None:
    assert shown(shorten(question(*LINES[:lines], *STEPS), AREA)) == left


def test_pictures_go_that_would_leave_a_second_page_nearly_empty() -> None:
    said = [shown(shorten(question(*LINES[:lines], *STEPS), AREA)) for lines in (20, 30, 60)]
    assert [len(one) for one in said] == [5, 2, 5]


@pytest.mark.parametrize(("lines", "left"), [(140, 5), (160, 2), (195, 5)])
def test_pictures_stay_where_no_page_is_saved_without_them(lines: int, left: int) -> None:
    assert len(shown(shorten(question(*LINES[:lines], *STEPS), AREA))) == left


def test_the_press_counts_the_pages_that_it_has_set() -> None:
    """Heights of parts are only about right."""
    for lines in range(84, 92):
        question_of_lines = question(Heading("Velocities", 1), *LINES[:lines], *STEPS)
        sheet = replace(ENGLISH_SOLUTION, questions=(question_of_lines,))
        assert count_pages(TypstPress().solution(sheet)) <= 2
