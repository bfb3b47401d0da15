"""The letter of the vertex of an angle stands outside the angle where there is room."""

from __future__ import annotations

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
