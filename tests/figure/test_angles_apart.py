"""The sides of an angle end at the pins that they reach; its arc keeps off other angles, its letter
is never outside it.
"""

from __future__ import annotations

from math import hypot, radians

import pytest

from kinegrade.figure.marks.angle_arc import AngleArc, LedAngleArc, Neighbours
from kinegrade.figure.marks.angles import mark_angles
from kinegrade.figure.marks.sides import Side, find_sides
from kinegrade.figure.mechanism.layers import Drawing
from kinegrade.figure.mechanism.straight_parts import Bar
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.plane import length
from kinegrade.figure.scene import FIRM, THIN, Bow, Disc
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import Angle
from tests.figure.mechanisms import polar
from tests.figures.sheet import deal

VERTEX = Vector(0.0, 0.0)
HINT = Angle("x", "O", "right", "P")
SIDES = tuple(Side(radians(turn), 0.0, 0.0, broad=False, lag=0.0) for turn in (0.0, 40.0))


def find_leg(end: Vector, *, bars: tuple[Bar, ...] = (), radius: float = 0.85) -> Side:
    """The side towards a point at which there is an open circle."""
    drawing = Drawing((Disc(end, radius, FIRM, "white"),), (), (), bars, (), ())
    return find_sides({"O": VERTEX, "P": end}, HINT, drawing)[1]


def test_a_side_that_runs_on_from_a_bar_begins_at_the_edge_of_its_pin() -> None:
    end = polar(5.0, 40)
    leg = find_leg(end, bars=(Bar("OP", VERTEX, end),))
    line = leg.line(VERTEX, 8.0)
    assert line is not None
    assert length(line[0] - end) == pytest.approx(1.0)
    assert hypot(*line[1]) > 8.0


def test_a_side_up_to_a_point_ends_at_the_edge_of_its_pin() -> None:
    end = polar(20.0, 40)
    line, within = (find_leg(end, radius=size).line(VERTEX, 8.0) for size in (0.85, 20.5))
    assert line is not None
    assert within is not None
    assert length(line[1] - end) == pytest.approx(1.0)
    assert length(within[1] - end) == pytest.approx(0.0)  # the inside of a ring is no pin


@pytest.mark.parametrize(("turn", "kept_off"), [(20.0, True), (40.0, True), (70.0, False)])
def test_an_arc_keeps_off_the_vertex_of_another_angle_between_its_sides(
    turn: float, kept_off: bool
) -> None:
    other = Bow(polar(6.0, turn), 5.0, 0.0, 1.0, THIN)
    demerits = []
    for arcs in ((), (other,)):
        [found] = mark_angles(
            {"O": VERTEX, "P": polar(30.0, 40)}, HINT, SIDES, Neighbours(arcs=arcs)
        )
        demerits.append({arc.bow.radius: arc.demerit for arc in found})
    alone, beside = demerits
    worse = {radius for radius, demerit in beside.items() if demerit > alone[radius]}
    assert (7.0 in worse) is kept_off
    assert 3.2 not in worse


def test_a_letter_that_a_leader_takes_out_of_its_angle_is_without_a_good_place() -> None:
    arc = AngleArc(Bow(VERTEX, 12.0, 0.0, radians(40), THIN), SIDES, HINT, 0.0)
    out = LedAngleArc(arc, polar(12.0, 5), radians(-60), 4.0, 0.0)
    within = LedAngleArc(arc, polar(12.0, 20), radians(20), 4.0, 0.0)
    assert Layout.of(()).marked([out]).crowded == ("x",)
    assert Layout.of(()).marked([within]).crowded == ()


@pytest.mark.parametrize("seed", ["v71a", "s2", "s6"])
def test_no_side_of_an_angle_merges_with_an_axis_at_its_vertex(seed: str) -> None:
    # at 96 degrees the arc up to the incline was read as the right angle between the axes
    gamma = deal("rod-ground-and-incline", seed).parameters["gamma"].number
    assert gamma.half_turns * 180 > 97
