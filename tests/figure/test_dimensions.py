"""Dimension lines go round what they measure."""

from __future__ import annotations

from kinegrade.figure.marks.dimensions import mark_lengths
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.scene import BOLD, Disc
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import Length
from tests.figure.clear import heads

AB = {"A": Vector(-20.0, 0.0), "B": Vector(20.0, 0.0)}


def test_a_dimension_line_goes_round_a_large_wheel() -> None:
    layout = Layout.of((Disc(Vector(0.0, 0.0), 18.0, BOLD),))
    marked = layout.marked(mark_lengths(AB, Length("d", "A", "B"), layout.obstacles))
    tips = [head.corners[0] for head in heads(marked)]
    assert [round(tip.x, 6) for tip in tips] == [-20.0, 20.0]
    assert all(abs(tip.y) > 18.0 for tip in tips)
    assert marked.crowded == ()
