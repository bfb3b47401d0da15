"""Constructions: each on a figure that can be checked with ruler and compass."""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.expressions.evaluation import evaluate, make_elementary_functions
from kinegrade.expressions.reading import read_expression
from kinegrade.mechanics.branches import BRANCHES
from kinegrade.mechanics.geometry import make_constructions
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.field import Field
from tests.laws.growing import DIRECTIONS, RADII
from tests.numbers.numbers import rationals


def construct(text: str, field: Field | None = None) -> Any:
    """What a construction comes to with O, A = (3, 0), B = (0, 4) and phi = 30 degrees."""
    field = field or Field()
    points: dict[str, Vector] = {}
    functions = {**make_elementary_functions(field), **make_constructions(field, points)}
    values: dict[str, Any] = {"pi": field.turns(1), **{branch: branch for branch in BRANCHES}}
    for name, place in {"O": "(0, 0)", "A": "(3, 0)", "B": "(0, 4)", "phi": "pi/6"}.items():
        values[name] = evaluate(read_expression(place), values, functions, field)
    return evaluate(read_expression(text), values, functions, field)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("polar(A, 2, pi/2)", "(3, 2)"),
        ("polar(O, 2, phi)", "(sqrt(3), 1)"),
        ("midpoint(A, B)", "(3/2, 2)"),
        ("A + B - O", "(3, 4)"),
        ("2*A", "(6, 0)"),
        ("A*2", "(6, 0)"),
        ("-A", "(-3, 0)"),
        ("(A + 2*B)/3", "(1, 8/3)"),
        ("turned(A)", "(0, 3)"),
        ("foot(O, line(A, B))", "(48/25, 36/25)"),
        ("toward(A, B, 10)", "(-3, 8)"),
        ("meet(line(O, pi/4), line(A, pi/2))", "(3, 3)"),
        ("meet(line(A, B), line(O, pi/4))", "(12/7, 12/7)"),
        ("meet(circle(O, 5), line(A, pi/2), upper)", "(3, 4)"),
        ("meet(line(A, pi/2), circle(O, 5), lower)", "(3, -4)"),
        ("meet(circle(B, 5), line(O, 0), right)", "(3, 0)"),
        ("meet(circle(B, 5), line(O, 0), left)", "(-3, 0)"),
        ("meet(circle(O, 3), circle(B, 5), right)", "(3, 0)"),
        ("meet(circle(O, 3), circle(B, 5), left)", "(-3, 0)"),
        (
            "meet(circle(O, 3), circle(B, 5), clockwise)",
            "(3, 0)",
        ),  # to the right of the way from O to B
        ("meet(circle(O, 3), circle(B, 5), counterclockwise)", "(-3, 0)"),
        ("meet(circle(O, 3), line(A, pi/2), upper)", "(3, 0)"),  # touching
        ("meet(circle(O, 3), circle(B, 5), right of O->B)", "(3, 0)"),
        ("meet(circle(O, 3), circle(B, 5), left of O->B)", "(-3, 0)"),
        ("meet(circle(O, 3), circle(B, 5), left of B->O)", "(3, 0)"),
        ("meet(circle(O, 5), line(A, pi/2), left of O->A)", "(3, 4)"),
        ("meet(line(A, pi/2), circle(O, 5), right of O->A)", "(3, -4)"),
    ],
)
def test_points(text: str, expected: str) -> None:
    field = Field()
    assert construct(text, field) == construct(expected, field)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("distance(A, B)", "5"),
        ("distance(O, line(A, B))", "12/5"),
        ("x(B) + y(B)", "4"),
        ("sin(direction(A, B))", "4/5"),
        ("cos(direction(O, B))", "0"),
    ],
)
def test_numbers(text: str, expected: str) -> None:
    assert construct(text) == construct(expected)


@given(rationals, rationals, DIRECTIONS, RADII, RADII)
def test_both_common_points_of_a_line_and_a_circle_lie_on_both(
    x: Any, y: Any, along: Vector, radius: Any, depth: Any
) -> None:
    field = Field()
    build = make_constructions(field, {})
    centre = Vector(x, y)
    through = centre + along.turned() * (radius * depth / (depth + 1))
    line, circle = build["line"](through, through + along), build["circle"](centre, radius)
    sides = (["right", "left"] if along.x != 0 else []) + (
        ["upper", "lower"] if along.y != 0 else []
    )
    points = [build["meet"](line, circle, side) for side in sides]
    for point in points:
        assert (point - centre).squared() == radius * radius
        assert along.cross(point - through) == 0
    if along.x != 0:
        assert field.sign(points[0].x - points[1].x) > 0
    if along.y != 0:
        assert field.sign(points[-2].y - points[-1].y) > 0


@given(rationals, rationals, DIRECTIONS, RADII, st.sampled_from(["clockwise", "counterclockwise"]))
def test_the_named_turn_is_the_side_of_the_way_from_the_first_centre_to_the_second(
    x: Any, y: Any, along: Vector, radius: Any, turn: str
) -> None:
    field = Field()
    build = make_constructions(field, {})
    first, second = Vector(x, y), Vector(x, y) + along * radius
    point = build["meet"](build["circle"](first, radius), build["circle"](second, radius), turn)
    assert (point - first).squared() == radius * radius == (point - second).squared()
    assert field.sign(along.cross(point - first)) == (1 if turn == "counterclockwise" else -1)


def test_vectors_multiply_from_both_sides_but_not_with_each_other() -> None:
    vector = Vector(1, 2)
    assert 2 * vector == vector * 2 == (2, 4)
    assert vector / 2 == (0.5, 1)
    assert -vector == (-1, -2)
    assert vector.dot(Vector(3, 4)) == 11
    assert vector.cross(Vector(3, 4)) == -2
    assert vector.turned() == (-2, 1)
    assert vector.squared() == 5
    with pytest.raises(TypeError):
        vector * vector
