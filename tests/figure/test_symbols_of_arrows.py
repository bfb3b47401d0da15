"""Where the symbols of the arrows of given motions stand: each beside its own, none in the way."""

from __future__ import annotations

from math import hypot

import numpy as np

from kinegrade.figure.marks.straight.arrow_places import Site
from kinegrade.figure.marks.straight.motions import add_motions
from kinegrade.figure.mechanism.straight_parts import Rod
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.placing.place import Wish
from kinegrade.figure.plane import nearest_of
from kinegrade.figure.scene import BOLD, FIRM, THIN, Strokes
from kinegrade.mechanics.vector import Vector
from tests.figure.arrows_at_sliders import BOTH, RIGHT, UP, lay_floor, slider


def test_the_symbol_of_an_arrow_is_not_on_the_other_side_of_the_rail_of_its_point() -> None:
    mechanism = slider(1, 0)
    at = mechanism.points["B"]
    above = Strokes(((at + Vector(1.0, 3.0), at + Vector(11.0, 3.0)),), FIRM)
    layout = Layout.of([above])
    free = add_motions(layout, Site(mechanism), BOTH[:1])
    railed = add_motions(layout, Site(mechanism, [lay_floor(at)]), BOTH[:1])
    assert free.marks[-1].path() == railed.marks[-1].path()
    assert free.labels[0].centre.y < at.y - 1.7 < railed.labels[0].centre.y


def test_each_symbol_is_nearest_to_its_own_arrow() -> None:
    mechanism = slider(1, 1)
    layout = add_motions(Layout.of(()), Site(mechanism), BOTH)
    arrows = [mark.path()[0] for mark in layout.marks]
    for number, label in enumerate(layout.labels):
        gaps = [hypot(*(label.centre - nearest_of(label.centre, *arrow))) for arrow in arrows]
        assert gaps[number] == min(gaps)
        assert max(gaps) - min(gaps) > 0.6


def test_the_symbol_of_an_arrow_leaves_the_letter_of_its_point_a_place() -> None:
    mechanism = slider(1.0, 0.0)
    at = mechanism.points["B"]
    usual = add_motions(Layout.of(()), Site(mechanism), BOTH[:1]).labels[-1].centre
    close = usual - RIGHT * 2.2
    letter = Wish("B", np.array([close, at + Vector(0.0, 12.0)]), names=at)
    layout = add_motions(Layout.of(()), Site(mechanism), BOTH[:1], named=[letter])
    assert layout.labels[-1].centre != usual
    assert layout.written([letter]).labels[-1].centre == close


def test_the_symbol_of_an_arrow_stays_where_the_letter_of_its_point_has_another_place() -> None:
    mechanism = slider(1.0, 0.0)
    at = mechanism.points["B"]
    usual = add_motions(Layout.of(()), Site(mechanism), BOTH[:1]).labels[-1].centre
    letter = Wish("B", np.array([usual, at + Vector(0.0, 3.0)]), names=at)
    layout = add_motions(Layout.of(()), Site(mechanism), BOTH[:1], named=[letter])
    assert layout.labels[-1].centre == usual


def test_a_symbol_is_not_cut_off_from_its_arrow_by_a_rod() -> None:
    mechanism = slider(1, 0)
    at = mechanism.points["B"]
    rod = Rod(mechanism.bodies[-1].name, at, at + RIGHT * 30.0, ())
    above = (at + UP * 6.6 - RIGHT * 20.0, at + UP * 6.6 + RIGHT * 30.0)
    layout = Layout.of([Strokes(((rod.start, rod.end),), BOLD), Strokes((above,), FIRM)])
    layout = add_motions(layout, Site(mechanism, (), (rod,)), BOTH[:1])
    [mark], [label] = layout.marks, layout.labels
    start, _ = mark.path()[0]
    assert abs(start.y - at.y) > 1.0
    assert (start.y - at.y) * (label.centre.y - at.y) > 0


def test_a_symbol_does_not_stand_past_a_tip_at_the_end_of_a_line() -> None:
    mechanism = slider(1, 0)
    at = mechanism.points["B"]
    leg = Strokes(((at + RIGHT * 3.0, at + RIGHT * 13.0),), THIN)
    close = [(at + RIGHT * 3.0 + UP * side, at + RIGHT * 9.0 + UP * side) for side in (1.6, -1.6)]
    layout = add_motions(Layout.of([leg, Strokes(tuple(close), FIRM)]), Site(mechanism), BOTH[:1])
    [label] = layout.labels
    assert abs(label.centre.y - at.y) > 1.0
