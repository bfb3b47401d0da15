"""Pins of bars that run on through them."""

from __future__ import annotations

from math import hypot

from kinegrade.figure.mechanism.layers import Drawing, draw
from kinegrade.figure.mechanism.paper import scale_to_paper
from kinegrade.figure.scene import BOLD, Disc
from kinegrade.mechanics.drivers import Rotation
from kinegrade.mechanics.joints import GROUND, Pin
from kinegrade.mechanics.mechanism import Body, Mechanism
from kinegrade.mechanics.vector import Vector
from tests.figure.mechanisms import Case, hinted

MIDDLE = Vector(0.2, 0.2)


def crossed_bars() -> Case:
    """Two bars pinned to each other at their middles, one of them to the ground as well."""
    points = {
        "A": Vector(0.0, 0.0),
        "D": MIDDLE * 2,
        "B": Vector(0.4, 0.0),
        "C": Vector(0.0, 0.4),
        "M": MIDDLE,
    }
    joints = (Pin("A", ("AD", GROUND)), Pin("M", ("AD", "BC")))
    bodies = (Body("AD", ("A", "M", "D")), Body("BC", ("B", "M", "C")))
    return hinted(Mechanism(points, bodies, joints, (Rotation("AD", 2.0, 0.0),)))


def drawing_of(case: Case) -> Drawing:
    return draw(scale_to_paper(case[0], 100.0), case[1])


def test_bars_that_cross_at_a_pin_are_seen_to_run_on_through_it() -> None:
    discs = [
        part
        for part in drawing_of(crossed_bars()).primitives
        if isinstance(part, Disc) and hypot(*(part.centre - MIDDLE * 100.0)) < 0.01
    ]
    boss, hole = discs
    assert (boss.fill, hole.fill) == ("black", "white")
    assert hole.radius < BOLD.width / 2 < boss.radius
