"""Where the numbers of teeth are given, none are drawn that could be counted to be others."""

from __future__ import annotations

import pytest

from kinegrade.figure.plane import length
from kinegrade.figure.scene import TOOTHED, Outline
from kinegrade.figure.sketch import sketch
from kinegrade.figure.teeth import COARSE, FINE, trace_gear
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.printed_givens import mark_question
from kinegrade.problem.template.library.library import load_template
from tests.figures.sheet import deal

CENTRE, TOOTH = Vector(0.0, 0.0), Vector(12.0, 0.0)


@pytest.mark.parametrize(
    ("template", "counted"),
    [
        ("differential-epicyclic-train", True),
        ("epicyclic-train-by-tooth-counts", True),
        ("planetary-gear-external-rim-velocities", False),
        ("rack-steering", False),
        ("slider-crank", False),
    ],
)
def test_teeth_are_counted_where_the_label_of_a_body_states_a_given_number(
    template: str, counted: bool
) -> None:
    loaded = load_template(template)
    assert mark_question(loaded, loaded.asked()).counted is counted


def test_fine_teeth_are_cut_about_the_meshes_alone() -> None:
    contour = trace_gear(CENTRE, TOOTH, False, FINE, (TOOTH,))
    roots = [corner for corner in contour if length(corner) < 12.0]
    assert 4 < len(roots) < len(contour) / 4
    assert max(length(root - TOOTH) for root in roots) < 6.0
    assert trace_gear(CENTRE, TOOTH, False) == trace_gear(CENTRE, TOOTH, False, COARSE)


@pytest.mark.parametrize("seed", ["w81a", "w81b"])
def test_most_of_the_sun_and_of_the_ring_of_a_counted_train_is_without_teeth(seed: str) -> None:
    solution = deal("differential-epicyclic-train", seed)
    hints = mark_question(solution.template, solution.template.asked())
    scene = sketch(solution.motion.frames.mechanism.map(float), hints)
    gears = [each for each in scene.primitives if isinstance(each, Outline) and each.pen == TOOTHED]
    assert len(gears) == 3
    for gear in sorted(gears, key=lambda each: len(each.corners))[1:]:
        steps = zip(gear.corners, gear.corners[1:], strict=False)
        flanks = [one for one, other in steps if length(other - one) > FINE.root + FINE.tip]
        assert 4 < len(flanks) < len(gear.corners) / 4
