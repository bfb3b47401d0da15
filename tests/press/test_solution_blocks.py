"""What of a worked solution stands beside the question's figure, and beside the drawings of a step."""

from __future__ import annotations

from kinegrade.press.solution_blocks import Passage, Placed, set_course
from kinegrade.worked.document import Display, Heading, Pictures, Prose, TermTable

KINDS, STEP = Heading("Types of motion", 1), Heading("1. AB", 2)
SAID, EQUATION, TABLE, DRAWN = Prose("So:"), Display(()), TermTable(()), Pictures(())


def test_what_comes_before_the_first_table_may_stand_beside_the_figure() -> None:
    course = set_course((KINDS, SAID, SAID, EQUATION, STEP, TABLE, EQUATION))
    assert [[placed.block for placed in chain] for chain in course.leading] == [
        [KINDS, SAID],
        [SAID, EQUATION],
    ]
    assert [part.block for part in course.following if isinstance(part, Placed)] == [
        STEP,
        TABLE,
        EQUATION,
    ]


def test_what_follows_from_a_table_stands_beside_its_drawings_up_to_the_next_heading() -> None:
    course = set_course((TABLE, DRAWN, SAID, EQUATION, EQUATION, STEP, SAID))
    table, passage, *others = course.following
    assert table == Placed(TABLE, stays=False)
    assert isinstance(passage, Passage)
    assert [len(chain) for chain in passage.beside] == [2, 1]
    assert others == [Placed(STEP, stays=True), Placed(SAID, stays=False)]


def test_a_solution_that_ends_with_drawings_has_nothing_beside_them() -> None:
    assert set_course((TABLE, DRAWN)).following[1] == Passage(DRAWN, ())
