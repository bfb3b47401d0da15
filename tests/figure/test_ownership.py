"""A symbol stands where it is not taken for that of something else than its own mark."""

from __future__ import annotations

import numpy as np

from kinegrade.figure.placing.ownership import Claims, list_places
from kinegrade.figure.scene import FIRM, Disc
from kinegrade.mechanics.vector import Vector

OWN = (Vector(0.0, 10.0), Vector(2.0, 10.0))  # places along a mark
SPOTS = np.array([[1.0, 12.5], [1.0, 4.0]])  # at the mark, and away from it


def rate(around: Claims) -> list[bool]:
    return [worse > 0 for worse in around.rate("n", SPOTS, OWN).tolist()]


def test_nothing_else_owns_a_symbol_where_nothing_is_around() -> None:
    assert rate(Claims()) == [False, False]


def test_a_symbol_nearer_to_a_pin_is_not_that_of_its_mark() -> None:
    assert rate(Claims(pins=(Vector(0.0, 0.0),))) == [False, True]


def test_a_symbol_nearer_to_a_line_is_not_that_of_its_mark() -> None:
    line = (Vector(-5.0, 2.0), Vector(5.0, 2.0))
    places = tuple(list_places([line], Vector(0.0, 0.0), 20.0))
    assert rate(Claims(lines=places)) == [False, True]


def test_a_bar_or_a_rim_cuts_a_symbol_off_from_its_mark() -> None:
    assert rate(Claims(bars=((Vector(-5.0, 7.0), Vector(5.0, 7.0)),))) == [False, True]
    assert rate(Claims(circles=(Disc(Vector(0.0, 0.0), 7.0, FIRM),))) == [False, True]


def test_places_on_a_line_are_those_near_a_point() -> None:
    line = (Vector(0.0, 0.0), Vector(100.0, 0.0))
    found = list(list_places([line], Vector(0.0, 0.0), 4.0))
    assert len(found) > 4
    assert [place for place in found if not place.x < 4.0] == []
