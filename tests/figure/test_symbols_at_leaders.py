"""A leader points at its symbol, and is no side of an angle."""

from __future__ import annotations

from math import cos, radians

import numpy as np
import pytest

from kinegrade.figure.marks.angle_arc import AngleArc, LedAngleArc
from kinegrade.figure.marks.in_angles import lies_in_angle, list_arcs
from kinegrade.figure.marks.lengths.length_leaders import list_leaders
from kinegrade.figure.marks.sides import Side
from kinegrade.figure.placing.extent import measure_symbol
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.placing.leading import list_spots_at_leader
from kinegrade.figure.scene import THIN, Bow
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import Angle
from tests.figure.mechanisms import polar

VERTEX = Vector(0.0, 0.0)
SIDES = tuple(Side(turn, 0.0, 0.0, broad=False, lag=0.0) for turn in (0.0, 1.0))
ARC = AngleArc(Bow(VERTEX, 7.0, 0.0, 1.0, THIN), SIDES, Angle("x", "O", "right", "P"), 0.0)


def test_a_wide_symbol_stands_before_a_level_leader_and_not_above_it() -> None:
    wide, high = measure_symbol("l_{O_{1}A}")
    for across, upward in list_spots_at_leader("l_{O_{1}A}", VERTEX, Vector(1.0, 0.0)).tolist():
        assert across > wide / 2 - 1.0
        assert abs(upward) < high / 2


@pytest.mark.parametrize("turn", range(0, 360, 30))
def test_every_leader_meets_its_symbol(turn: int) -> None:
    toward = polar(1.0, turn)
    spots = list_spots_at_leader("r_{EF}", VERTEX, toward)
    half = np.abs([toward.y, toward.x]) @ np.array(measure_symbol("r_{EF}")) / 2
    assert len(spots) > 0
    assert (np.abs(spots @ np.array([-toward.y, toward.x])) < half).all()


def test_a_line_from_a_side_into_the_angle_lies_in_it() -> None:
    led = LedAngleArc(ARC, polar(7.0, 30), 0.5, 4.0, 0.0)
    arcs = tuple(list_arcs([led]))
    assert arcs == (ARC,)
    on_side = Vector(5.0, 0.0)
    assert lies_in_angle((on_side, on_side + polar(4.0, 90)), arcs)
    assert not lies_in_angle((on_side, on_side + polar(4.0, -90)), arcs)
    assert not lies_in_angle((polar(14.0, 20), polar(18.0, 20)), arcs)


def test_the_leader_of_a_length_is_rather_not_in_an_angle_at_its_bar() -> None:
    layout = Layout.of(()).marked([ARC])
    leaders = list(list_leaders(layout, (VERTEX, Vector(12.0, 0.0)), "r", 60.0))
    into = [leader.worse for leader in leaders if 0.1 < leader.angle < radians(179)]
    out = [leader.worse for leader in leaders if leader.angle > radians(181)]
    assert min(into) > min(out) + 10.0


def test_a_leader_rather_slants_than_standing_upright_as_a_line_of_reference_does() -> None:
    leaders = list(list_leaders(Layout.of(()), (VERTEX, Vector(12.0, 0.0)), "r", 60.0))
    upright = [leader.worse for leader in leaders if abs(cos(leader.angle)) < 0.1]
    slanted = [leader.worse for leader in leaders if 0.1 < abs(cos(leader.angle)) < 0.6]
    assert min(upright) > min(slanted) + 3.0
