"""Marks and labels take the nicest place that covers nothing."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from msgspec import structs

from kinegrade.figure.placing.extent import measure_symbol
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.placing.obstacles import Segment
from kinegrade.figure.placing.place import LOST, Wish, list_spots_around
from kinegrade.figure.scene import BOLD, FIRM, THIN, Label, Primitive, Strokes
from kinegrade.mechanics.vector import Vector


@dataclass(frozen=True)
class Rule:
    """A level line with its symbol above its middle."""

    height: float
    demerit: float
    shared: bool = False

    def path(self) -> tuple[Segment, ...]:
        return ((Vector(-5.0, self.height), Vector(5.0, self.height)),)

    def wish(self) -> Wish:
        return Wish("l", np.array([[0.0, self.height + 2.0]]))

    def primitives(self) -> tuple[Primitive, ...]:
        return (Strokes(self.path(), THIN),)


WALL = Strokes(((Vector(0.0, -1.0), Vector(0.0, 1.0)),), BOLD)


def heights(layout: Layout) -> list[float]:
    return [
        part.lines[0][0].y
        for part in layout.lines
        if isinstance(part, Strokes) and part.pen == THIN
    ]


def test_the_nicest_mark_is_taken_when_it_crosses_nothing() -> None:
    assert heights(Layout.of(()).marked([Rule(6.0, 1.0), Rule(0.0, 0.5)])) == [0.0]


def test_a_mark_gives_way_to_what_is_drawn() -> None:
    assert heights(Layout.of((WALL,)).marked([Rule(0.0, 0.5), Rule(6.0, 1.0)])) == [6.0]


def test_only_those_marks_are_rated_that_may_be_the_nicest() -> None:
    rated: list[float] = []

    def rate(rule: Rule) -> Rule:
        rated.append(rule.height)
        return replace(rule, demerit=rule.demerit + 2.0 * (rule.height == 0.0))

    ways = [*(Rule(10.0 + place, 30.0) for place in range(9)), Rule(0.0, 0.5), Rule(6.0, 1.0)]
    assert heights(Layout.of(()).chosen(ways, rate=rate)[0]) == [6.0]
    assert rated == [0.0, 6.0, 10.0, 11.0, 12.0]


def test_a_mark_whose_label_has_no_room_gives_way() -> None:
    assert heights(Layout.of((WALL,)).marked([Rule(-2.0, 0.5), Rule(6.0, 1.0)])) == [6.0]


def test_labels_still_to_come_are_spared() -> None:
    letter = Label("A", Vector(0.0, 0.0), 2.0, 2.0)
    layout = Layout.of(()).marked([Rule(0.0, 0.5), Rule(6.0, 1.0)], [letter])
    assert heights(layout) == [6.0]
    assert letter not in layout.labels


def test_a_letter_stands_as_near_as_what_is_drawn_lets_it() -> None:
    free = Layout.of(()).written([Wish("A", list_spots_around("A", Vector(0.0, 0.0)))]).labels[0]
    crowded = (
        Layout.of((WALL,))
        .written([Wish("A", list_spots_around("A", Vector(0.0, 0.0), away=Vector(0.0, 1.0)))])
        .labels[0]
    )
    assert abs(free.centre.x) < 3.0
    assert crowded.centre.y > 1.0 or abs(crowded.centre.x) > 1.0


def test_the_leader_of_a_letter_does_not_run_on_from_a_line_at_its_point() -> None:
    walls = [
        Strokes(((Vector(-30.0, y), Vector(-1.5, y)), (Vector(1.5, y), Vector(4.5, y))), FIRM)
        for y in (-3.6, -2.4, -1.2, 1.2, 2.4, 3.6)
    ]
    leg = Strokes(((Vector(-4.5, 0.0), Vector(0.0, 0.0)),), THIN)
    at = Vector(0.0, 0.0)
    right = np.array([(8.0, 0.0), (8.0, 4.5)])
    for legs, height in (((), 0.0), ((leg,), 4.5)):
        layout = Layout.of((*walls, *legs)).written([Wish("A", right, names=at)])
        assert layout.labels[0].centre.y == height


def test_a_symbol_without_a_free_place_is_named() -> None:
    walls = [Strokes(((Vector(-30.0, y / 2), Vector(30.0, y / 2)),), THIN) for y in range(-60, 61)]
    wish = Wish("A", list_spots_around("A", Vector(0.0, 0.0)))
    assert Layout.of(walls).written([wish]).crowded == ("A",)
    assert Layout.of((WALL,)).written([wish]).crowded == ()


def test_a_symbol_that_could_be_read_as_that_of_another_point_is_named() -> None:
    wish = Wish("A", np.array([[0.0, 0.0]]), demerits=np.array([20.0]))
    assert Layout.of(()).written([wish]).crowded == ("A",)


def test_a_mark_through_a_letter_is_named_by_its_symbol() -> None:
    written = Layout.of(()).written([Wish("A", np.array([[0.0, 0.0]]))])
    assert written.marked([Rule(0.0, 0.0)]).crowded == ("l",)
    assert written.marked([Rule(6.0, 0.0)]).crowded == ()


def test_what_is_only_spared_crowds_nothing() -> None:
    letter = Label("A", Vector(0.0, 2.0), 2.0, 2.0)
    assert Layout.of(()).marked([Rule(0.0, 0.0)], [letter]).crowded == ()


def test_the_symbol_of_a_mark_does_not_stand_in_one_row_with_another_as_if_they_were_a_product() -> (
    None
):
    for aside, row in ((2.0, False), (4.0, True)):
        letter = Label("d", Vector(0.0, 0.0), 2.0, 3.0)
        layout = structs.replace(Layout.of((letter,)), labels=(letter,))
        width, _ = measure_symbol("a")
        beside = np.array([[1.0 + aside + width / 2, 0.0], [10.0, 6.0]])
        [_, symbol] = layout.captioned(Wish("a", beside)).labels
        assert (symbol.centre.y == 0.0) is row


def test_a_symbol_too_far_from_its_mark_to_be_found_has_no_good_place() -> None:
    for demerit, crowded in ((LOST, ("x",)), (LOST / 2, ())):
        wish = Wish("x", np.array([[0.0, 0.0]]), demerits=np.array([demerit]))
        assert Layout.of(()).captioned(wish).crowded == crowded


@dataclass(frozen=True)
class Leaning:
    """A line whose symbol stands at one place, on the line or not."""

    foot: float
    at: float
    demerit: float
    shared: bool = False

    def path(self) -> tuple[Segment, ...]:
        return ((Vector(self.foot, 0.0), Vector(self.foot, 5.0)),)

    def wish(self) -> Wish:
        return Wish("l", np.array([[self.at, 2.0]]))

    def primitives(self) -> tuple[Primitive, ...]:
        return (Strokes(self.path(), THIN),)


def test_a_mark_whose_label_would_stand_on_its_own_line_gives_way_to_another() -> None:
    on_itself, beside_itself = Leaning(0.0, 0.0, 0.5), Leaning(10.0, 14.0, 1.0)
    alone = Layout.of(()).marked([on_itself])
    assert alone.crowded == ("l",)
    layout = Layout.of(()).marked([on_itself, beside_itself])
    assert (layout.crowded, layout.marks, len(layout.labels)) == ((), (beside_itself,), 1)


def test_a_label_leaves_the_row_of_another_one_for_a_spot_farther_down_its_list() -> None:
    beside = np.array([[3.0, 0.2]] * 14)
    wish = Wish("l", np.concatenate((beside, np.array([[3.0, 6.0]]))))
    other = Label("m", Vector(0.0, 0.0), 2.5, 2.5)
    written = structs.replace(Layout.of(()), labels=(other,)).captioned(wish)
    assert written.labels[-1].centre == Vector(3.0, 6.0)
    assert written.crowded == ()


def test_a_label_stays_in_the_row_of_another_one_where_it_has_no_other_place() -> None:
    wish = Wish("l", np.array([[3.0, 0.2]]))
    other = Label("m", Vector(0.0, 0.0), 2.5, 2.5)
    written = structs.replace(Layout.of(()), labels=(other,)).captioned(wish)
    assert written.labels[-1].centre == Vector(3.0, 0.2)
    assert written.crowded == ()
