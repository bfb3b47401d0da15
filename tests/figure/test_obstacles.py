"""What a rectangle covers: exactly what it overlaps, and nothing that it only touches."""

from __future__ import annotations

from math import cos, hypot, pi, sin

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.figure.placing.joining import find_join
from kinegrade.figure.placing.obstacles import (
    COST_BOLD,
    COST_FIRM,
    COST_LABEL,
    COST_THIN,
    Obstacles,
    Segment,
)
from kinegrade.figure.scene import (
    BOLD,
    FIRM,
    THIN,
    Disc,
    Fill,
    Label,
    Outline,
    Pen,
    Primitive,
    Strokes,
)
from kinegrade.mechanics.vector import Vector

REACH = st.floats(-20, 20)
POINT = st.builds(Vector, REACH, REACH)


def line(start: tuple[float, float], end: tuple[float, float], pen: Pen = THIN) -> Strokes:
    return Strokes(((Vector(*start), Vector(*end)),), pen)


def under(
    primitive: Primitive, centre: tuple[float, float], width: float = 2.0, height: float = 2.0
) -> float:
    return Obstacles.of((primitive,)).under_box(*centre, width, height)


def along(primitive: Primitive, *pieces: Segment, shared: bool = False) -> float:
    return Obstacles.of((primitive,)).along(pieces, shared)


def test_the_ground_of_a_shape_has_no_line_of_its_own_and_an_arrowhead_has() -> None:
    corners = (Vector(0.0, 0.0), Vector(4.0, 0.0), Vector(0.0, 4.0))
    fills: tuple[Fill, ...] = ("grey", "white", "black")
    grey, white, black = (under(Outline(corners, None, fill), (0.0, 2.0)) for fill in fills)
    assert grey == white == 0.0 < black


@pytest.mark.parametrize(
    ("pen", "cost"),
    [(THIN, COST_THIN), (FIRM, COST_FIRM), (BOLD, COST_BOLD)],
    ids=["thin", "firm", "bold"],
)
def test_a_box_that_touches_the_edge_of_a_line_is_free_and_a_hair_closer_is_not(
    pen: Pen, cost: float
) -> None:
    rule = line((-10, 0), (10, 0), pen)
    assert under(rule, (0, 1 + pen.width / 2)) == 0
    assert under(rule, (0, 1 + pen.width / 2 - 1e-4)) == cost


def test_a_box_inside_a_circle_is_free_and_across_its_line_is_not() -> None:
    ring = Disc(Vector(0, 0), 10.0, FIRM)
    assert under(ring, (0, 0)) == 0
    assert under(ring, (0, 10)) == COST_FIRM
    assert under(ring, (0, 12)) == 0


def test_a_small_filled_disc_counts_whole() -> None:
    assert under(Disc(Vector(0, 0), 0.85, FIRM, "white"), (0, 0), 0.1, 0.1) == COST_BOLD


@given(POINT, POINT, st.floats(1, 5), st.floats(1, 5))
def test_a_label_is_covered_exactly_when_the_boxes_overlap(
    one: Vector, other: Vector, width: float, height: float
) -> None:
    label = Label("A", one, width, height)
    apart = max(abs(one.x - other.x) - width / 2, abs(one.y - other.y) - height / 2) - 1.0
    if abs(apart) > 1e-3:
        assert (under(label, other) >= COST_LABEL) == (apart < 0)


@given(POINT, POINT, st.floats(0, 2 * pi))
def test_what_a_strip_covers_does_not_depend_on_its_direction(
    one: Vector, other: Vector, turn: float
) -> None:
    def turned(point: Vector) -> Vector:
        return Vector(
            point.x * cos(turn) - point.y * sin(turn), point.x * sin(turn) + point.y * cos(turn)
        )

    piece = (Vector(-6.0, 1.0), Vector(5.0, 2.0))
    near = min(abs(point.y - piece[0].y) for point in (one, other))
    if hypot(*(other - one)) > 0.1 and near > 0.01:
        upright = along(Strokes(((one, other),), FIRM), piece)
        assert (
            along(
                Strokes(((turned(one), turned(other)),), FIRM), (turned(piece[0]), turned(piece[1]))
            )
            == upright
        )


def test_a_path_pays_once_for_what_it_meets_twice() -> None:
    there, back = (Vector(-5, 0), Vector(5, 0)), (Vector(5, 0), Vector(-5, 1))
    assert along(line((0, -5), (0, 5), BOLD), there, back) == COST_BOLD


def test_only_a_shared_thin_line_on_the_same_axis_is_free() -> None:
    piece = (Vector(0, 0), Vector(10, 0))
    assert along(line((2, 0), (30, 0)), piece, shared=True) == 0
    assert along(line((2, 0), (30, 0)), piece) == COST_THIN
    assert along(line((2, 0), (30, 0), BOLD), piece, shared=True) == COST_BOLD
    assert along(line((2, -3), (2, 3)), piece, shared=True) == COST_THIN


@given(POINT, POINT, POINT, st.floats(0, 2 * pi))
def test_what_is_near_covers_as_much_as_all(
    start: Vector, end: Vector, at: Vector, turn: float
) -> None:
    drawn = Obstacles.of(
        (line(start, end, BOLD), Disc(end, 2.0, FIRM), Label("A", start, 4.0, 2.0))
    )
    reach = Vector(3 * cos(turn), 3 * sin(turn))
    across, upward = zip(at - reach, at + reach, strict=True)
    near = drawn.near((min(across) - 1, min(upward) - 1, max(across) + 1, max(upward) + 1))
    assert near.along([(at - reach, at + reach)], False) == drawn.along(
        [(at - reach, at + reach)], False
    )
    assert near.under_box(*at, 2.0, 2.0) == drawn.under_box(*at, 2.0, 2.0)


def test_nothing_drawn_covers_nothing() -> None:
    assert along(line((0, -5), (0, 5), BOLD)) == 0


def test_two_points_are_joined_by_a_line_that_ends_at_both() -> None:
    drawn = Obstacles.of((line((1, 0), (20, 0)),))
    assert find_join(drawn, Vector(0, 0), Vector(20, 0), 2.0) == "whole"
    assert find_join(drawn, Vector(0, 0), Vector(10, 0), 2.0) == "part"
    assert find_join(drawn, Vector(0, 0), Vector(30, 0), 2.0) == "none"
    assert find_join(drawn, Vector(0, 0), Vector(20, 1), 2.0) == "none"
