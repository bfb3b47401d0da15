"""A letter that stands off from its point is led to it."""

from __future__ import annotations

import numpy as np
import pytest
from msgspec.structs import replace

from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.placing.letters import is_misread, trace_wished_leader
from kinegrade.figure.placing.obstacles import Obstacles
from kinegrade.figure.placing.place import Wish
from kinegrade.figure.scene import BOLD, FIRM, THIN, Disc, Label, Strokes
from kinegrade.mechanics.vector import Vector

POINT = Vector(0.0, 0.0)


def write(distance: float, *drawn: Strokes) -> list[tuple[Vector, Vector]]:
    """The thin lines of a letter E whose only place is so many millimetres to the right."""
    wish = Wish("E", np.array([[distance, 0.0]]), names=POINT)
    layout = Layout.of(drawn).written((wish,))
    thin = [each for each in layout.lines if isinstance(each, Strokes) and each.pen == THIN]
    return [line for strokes in thin for line in strokes.lines]


def test_a_letter_at_its_point_has_no_leader() -> None:
    assert write(3.0) == []


def test_a_leader_goes_from_a_letter_that_stands_off_to_just_before_its_point() -> None:
    [(start, end)] = write(7.0)
    assert (start.y, end.y) == (0.0, 0.0)
    assert 1.0 < end.x < 1.6
    assert 5.0 < start.x < 6.5


def test_a_leader_to_a_pin_beside_its_bar_ends_on_its_half_circle_or_at_the_bar() -> None:
    wish = Wish("E", np.array([[7.0, 0.0]]), names=POINT)
    for side, end in ((1.0, BOLD.width / 2 + 1.15), (-1.0, BOLD.width / 2)):
        led = trace_wished_leader(replace(wish, pin_side=Vector(side, 0.0)), wish.label_at(0))
        assert led is not None
        assert led[1] == Vector(end, 0.0)


def test_no_leader_crosses_a_bar() -> None:
    assert write(7.0, Strokes(((Vector(3.0, -5.0), Vector(3.0, 5.0)),), BOLD)) == []


def test_a_long_leader_may_cross_two_outlines_without_which_its_point_would_not_be_found() -> None:
    outlines = [Strokes(((Vector(x, -9.0), Vector(x, 9.0)),), FIRM) for x in (2.5, 3.2, 3.9)]
    assert [len(write(distance, *outlines[:2])) for distance in (5.3, 7.0)] == [0, 1]
    assert write(7.0, *outlines) == []


def test_a_leader_crosses_only_what_its_point_lies_amid() -> None:
    wish = Wish("E", np.array([[9.0, 0.0]]), names=POINT)
    for teeth, amid, led in ((2.0, 2.0, True), (2.0, 0.0, False), (4.5, 2.0, False)):
        fence = Strokes(((Vector(teeth, -5.0), Vector(teeth, 5.0)),), BOLD)
        layout = Layout.of((fence,)).written((replace(wish, amid=amid),))
        assert any(isinstance(each, Strokes) and each.pen == THIN for each in layout.lines) == led


def test_a_letter_amid_teeth_is_led_to_its_dot_from_less_far_off_but_not_by_a_stub() -> None:
    for away, amid, led in ((4.6, 0.0, False), (4.6, 2.0, True), (4.2, 2.0, False)):
        wish = Wish("E", np.array([[away, 0.0]]), names=POINT)
        layout = Layout.of(()).written((replace(wish, amid=amid),))
        assert bool(layout.lines) == led


def test_a_letter_that_would_stand_off_is_looked_a_closer_place_for() -> None:
    far = Wish("E", np.array([[7.0, 0.0]]), names=POINT)
    near = replace(far, spots=np.array([[2.0, 2.5], [0.0, 3.0]]))
    fence = Strokes(((Vector(1.0, 2.5), Vector(3.0, 2.5)),), FIRM)
    for drawn, centre in (((), Vector(2.0, 2.5)), ((fence,), Vector(7.0, 0.0))):
        only = replace(near, spots=near.spots[:1])
        layout = Layout.of(drawn).written((replace(far, closely=lambda _, only=only: only),))
        assert layout.labels[0].centre == centre


def test_a_letter_that_stands_off_is_no_index_of_another_label() -> None:
    wish = Wish("C", np.array([[0.0, 7.0], [0.0, -7.0]]), names=POINT)
    beside = Label(r"\omega", Vector(2.9, 7.0), 3.0, 3.0)
    start = replace(Layout.of((beside,)), labels=(beside,))
    [_, letter] = start.written((wish,)).labels
    assert letter.centre == Vector(0.0, -7.0)


def test_a_letter_does_not_stand_behind_a_wall_if_there_is_room_before_it() -> None:
    wall = (Vector(-5.0, 1.7), Vector(5.0, 1.7))
    behind, before = [0.0, 3.4], [2.4, -2.4]
    close = Wish("B", np.array([behind, before]), names=POINT)
    wish = Wish("B", np.array([behind]), names=POINT, closely=lambda _: close, walls=(wall,))
    fence = Strokes(((Vector(2.0, -3.0), Vector(3.0, -2.0)),), FIRM)
    for drawn, level in (((), -2.4), ((fence,), 3.4)):
        [letter] = Layout.of(drawn).written((wish,)).labels
        assert letter.centre.y == level


@pytest.mark.parametrize(("end", "misread"), [(4.6, True), (5.6, True), (6.4, False), (3.0, False)])
def test_a_leader_that_ends_at_the_rim_that_it_crosses_would_be_a_radius(
    end: float, misread: bool
) -> None:
    centre = Vector(20.0, 20.0)
    rings = Obstacles.of([Disc(centre, 5.0, FIRM, "grey")]).rings
    leader = (centre + Vector(end, 0.0), centre + Vector(1.3, 0.0))
    assert is_misread(leader, (), rings) == misread
