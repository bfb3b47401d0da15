"""A leader ends where nothing but its own line is, and runs on from no other thin line."""

from __future__ import annotations

from math import cos

import numpy as np
import pytest
from msgspec.structs import replace

from kinegrade.figure.marks.lengths.dimension_lines import DimensionLine
from kinegrade.figure.marks.lengths.length_leaders import list_leaders
from kinegrade.figure.marks.names import keep_from_marks
from kinegrade.figure.marks.straight.moving_arrow import MovingArrow
from kinegrade.figure.placing.aligned import list_thin_lines, runs_on
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.placing.letters import trace_leader
from kinegrade.figure.placing.obstacles import Segment
from kinegrade.figure.placing.place import Wish
from kinegrade.figure.plane import angle_of, length
from kinegrade.figure.scene import BOLD, THIN, Bow, Label, Primitive, Strokes
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import Moving

START, END = Vector(0.0, 0.0), Vector(30.0, 0.0)
GIVEN = Moving("v", "B")
BAR = Strokes(((START, END),), BOLD)


def make_line(*numbers: float) -> Segment:
    x, y, to_x, to_y = numbers
    return Vector(x, y), Vector(to_x, to_y)


@pytest.mark.parametrize(
    ("numbers", "same"),
    [
        ((12.0, 0.2, 20.0, 0.2), True),  # ahead, on its line
        ((-9.0, 0.0, -2.0, 0.5), True),  # behind, leaning a little
        ((3.0, 0.0, 6.0, 0.0), True),  # on it
        ((14.0, 0.0, 20.0, 0.0), False),  # far ahead
        ((12.0, 2.0, 20.0, 2.0), False),  # beside
        ((12.0, 0.0, 20.0, 4.0), False),  # in another direction
    ],
)
def test_a_line_runs_on_from_one_that_ends_near_in_its_direction(
    numbers: tuple[float, ...], same: bool
) -> None:
    assert runs_on(make_line(0.0, 0.0, 10.0, 0.0), [make_line(*numbers)]) is same


def test_hatching_is_no_line_to_run_on_from() -> None:
    drawn = [Strokes((make_line(0, 0, 1, 1), make_line(0, 0, 8, 0)), THIN), BAR]
    assert list_thin_lines(drawn) == (make_line(0, 0, 8, 0),)


def find_best(*drawn: Primitive) -> tuple[Vector, float]:
    """Where the best leader to a bar ends and its direction."""
    found = list_leaders(Layout.of([BAR, *drawn]), (START, END), "l", 99.0)
    best = min(found, key=lambda leader: leader.demerit)
    return best.middle, best.angle


def test_a_leader_ends_at_the_middle_of_its_bar_and_stands_off_from_it() -> None:
    at, turn = find_best()
    assert at == Vector(15.0, 0.0)
    assert abs(cos(turn)) < 0.8


def test_a_leader_does_not_end_where_another_line_crosses_its_bar() -> None:
    at, _ = find_best(Strokes((make_line(15.3, -9, 15.3, 9),), THIN))
    assert abs(at.x - 15.3) > 2.0


def test_a_leader_crosses_no_arc() -> None:
    arc = Bow(Vector(15.0, 0.0), 3.0, 0.1, 2.9, THIN)
    at, turn = find_best(arc)
    assert turn > 3.2 or turn < 0 or length(at - arc.centre) > arc.radius


def test_a_leader_does_not_run_on_from_a_thin_line() -> None:
    aside = make_line(15.0, 6.5, 15.0, 12.0)
    below = make_line(15.0, -6.5, 15.0, -12.0)
    at, turn = find_best(Strokes((aside, below), THIN))
    along = abs(cos(turn - angle_of(aside[1] - aside[0])))
    assert along < 0.98 or abs(at.x - 15.0) > 1.0


def test_leaders_that_are_too_dear_are_not_made() -> None:
    assert list(list_leaders(Layout.of([BAR]), (START, END), "l", 5.0)) == []


def test_a_letter_behind_the_rim_of_its_point_has_a_leader_sooner() -> None:
    label, point = Label("P", Vector(4.2, 0.0), 2.0, 2.4), Vector(0.0, 0.0)
    rim = ((Vector(2.0, -3.0), Vector(2.0, 3.0)),)
    assert trace_leader(label, point) is None
    line = trace_leader(label, point, rim)
    assert line is not None
    assert line[1].x == pytest.approx(1.3)


def test_the_letter_of_a_point_is_rather_not_beside_an_arrow() -> None:
    at = Vector(0.0, 0.0)
    arrow = MovingArrow(Vector(1.0, 1.5), Vector(1.0, 0.0), GIVEN, 0.0, at)
    wish = Wish("B", np.array([(4.0, 3.0), (-2.0, 0.0)]), names=at)
    kept = keep_from_marks(wish, [arrow])
    assert kept.demerits is not None
    assert kept.demerits[0] > kept.demerits[1] == 0.0
    spots = np.array([[6.0, 1.5], [0.0, 2.5]])
    led = replace(wish, closely=lambda _: Wish("B", spots))
    look = keep_from_marks(led, [arrow]).closely
    assert look is not None
    demerits = look(3.0).demerits
    assert demerits is not None
    assert (demerits > 0.5).tolist() == [True, False]


def test_the_heads_of_a_dimension_lie_between_its_feet_or_outside() -> None:
    for size, inward in ((12.0, 1.0), (4.0, -1.0)):
        feet = Vector(0.0, 5.0), Vector(size, 5.0)
        line = DimensionLine((Vector(0.0, 0.0), Vector(size, 0.0)), feet, "a", 0.0, (1.6, 1.6))
        (_, first), (_, last) = line.heads()
        assert (first.x, last.x) == (2.0 * inward, size - 2.0 * inward)
