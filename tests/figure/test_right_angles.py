"""The mark of a right angle: a small square between two legs."""

from __future__ import annotations

from math import hypot

import pytest

from kinegrade.errors import TemplateError
from kinegrade.figure.marks.right_angles import add_right_angle
from kinegrade.figure.mechanism.layers import Drawing
from kinegrade.figure.mechanism.straight_parts import Bar
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.scene import FIRM, THIN, Disc, Outline, Scene
from kinegrade.figure.sketch import sketch
from kinegrade.figure.symbols.bars import BAR_WIDTH
from kinegrade.mechanics.joints import GROUND, Pin
from kinegrade.mechanics.mechanism import Body, Mechanism
from kinegrade.mechanics.vector import Vector
from tests.figure.guided_mechanisms import corner_in_two_sleeves, sleeve_with_arm
from tests.figure.mechanisms import Case, hinted, polar


def bent_rod(degrees: float) -> Case:
    points = {"O": polar(0.4, degrees), "C": Vector(0.0, 0.0), "A": polar(0.5, 0)}
    mechanism = Mechanism(points, (Body("rod", ("O", "C", "A")),), (Pin("O", ("rod", GROUND)),), ())
    return hinted(mechanism, shapes={"rod": "bent"}, right_angles=[["O", "C", "A"]])


def squares(scene: Scene) -> list[Outline]:
    return [
        part
        for part in scene.primitives
        if isinstance(part, Outline) and part.pen == THIN and not part.closed
    ]


def test_a_right_angle_is_marked_by_a_square_whose_ends_are_on_its_legs() -> None:
    scene = sketch(*bent_rod(90))
    (square,) = squares(scene)
    first, far, second = square.corners
    assert (first - far).dot(second - far) == pytest.approx(0.0)
    assert hypot(*(first - far)) == pytest.approx(hypot(*(second - far)))


def test_the_square_goes_round_a_sleeve() -> None:
    mechanism, _ = sleeve_with_arm()
    case = hinted(mechanism, right_angles=[["A", "B", "D"]])
    (square,) = squares(sketch(*case))
    first, far, _ = square.corners
    assert hypot(*(first - far)) > 3.2  # half the length of the sleeve


def test_the_square_is_smaller_than_its_legs_whatever_that_covers() -> None:
    at = {"A": Vector(4.5, 0.0), "B": Vector(0.0, 0.0), "C": Vector(0.0, 30.0)}
    layout = Layout.of([Disc(at["B"], radius, FIRM) for radius in (2.6, 3.4)])
    layout = add_right_angle(layout, at, ("A", "B", "C"), Drawing((), (), (), (), (), ()))
    *_, square = layout.lines
    assert isinstance(square, Outline)
    first, far, _ = square.corners
    assert hypot(*(first - far)) < 4.0


def test_at_a_broad_bar_the_square_stands_on_its_edge() -> None:
    at = {"A": Vector(0.0, -20.0), "B": Vector(0.0, 0.0), "C": Vector(30.0, 0.0)}
    slotted = Bar("rocker", at["C"], Vector(-8.0, 0.0), "slot")
    drawing = Drawing((), (), (), (slotted,), (), ())
    *_, square = add_right_angle(Layout.of(()), at, ("A", "B", "C"), drawing).lines
    assert isinstance(square, Outline)
    assert max(corner.y for corner in square.corners) == pytest.approx(-BAR_WIDTH / 2)


def test_an_angle_that_is_no_right_one_is_not_marked_as_such() -> None:
    with pytest.raises(TemplateError) as caught:
        sketch(*bent_rod(87))
    assert caught.value.problems == (
        'figure.right_angles: the angle at "C" is 87.0° and no right one; '
        "mark only angles that are right at all values",
    )


def test_where_a_bar_runs_on_the_square_may_be_on_its_other_side() -> None:
    """Beside the sleeve of the arm, where the other bar does not leave room for it."""
    mechanism, _ = corner_in_two_sleeves(0.015)
    case = hinted(mechanism, right_angles=[["A", "E", "M"]])
    (square,) = squares(sketch(*case))
    on_arm, far, _ = square.corners
    assert (far - on_arm).dot(mechanism.points["M"] - mechanism.points["E"]) < 0
