"""The letter of the vertex of an angle stands outside the angle where there is room."""

from __future__ import annotations

from dataclasses import replace

from kinegrade.figure.marks.names import label_points
from kinegrade.figure.mechanism.layers import draw
from kinegrade.figure.mechanism.paper import scale_to_paper
from kinegrade.figure.plane import angle_of
from kinegrade.figure.scene import Bow
from kinegrade.figure.sketch import sketch
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import Angle, FigureHints

POINTS = {"O": Vector(0.0, 0.0), "A": Vector(0.5, 0.0), "B": Vector(0.2, 0.4)}


def test_a_letter_in_an_angle_would_name_it() -> None:
    hints = FigureHints(
        angles=(Angle(r"\gamma", "O", "A", "B"),), labels=dict.fromkeys(POINTS) | {"O": "O"}
    )
    scene = sketch(Mechanism(POINTS, (), (), ()), hints)
    (arc,) = (part for part in scene.primitives if isinstance(part, Bow))
    (letter,) = (label for label in scene.labels if label.symbol == "O")
    assert not 0 <= angle_of(letter.centre - arc.centre) <= arc.sweep


def test_any_place_in_an_angle_is_worse_for_the_letter_of_its_vertex_than_none_near_by() -> None:
    hints = FigureHints(angles=(Angle(r"\gamma", "O", "A", "B"),), labels=dict.fromkeys(POINTS, ""))
    hints = replace(hints, labels={**hints.labels, "O": "O"})
    paper = scale_to_paper(Mechanism(POINTS, (), (), ()), 100.0)
    (wish,) = label_points(paper, hints, draw(paper, hints))
    assert wish.demerits is not None
    widest = angle_of(POINTS["B"])
    within = [0.05 < angle_of(Vector(*spot)) < widest - 0.05 for spot in wish.spots]
    outside = [angle_of(Vector(*spot)) < -0.05 for spot in wish.spots]
    assert max(wish.demerits[outside]) == 0
    assert min(wish.demerits[within]) >= 3.0
