"""A letter is nearer to its own point than to the support of another one."""

from __future__ import annotations

import pytest
from shapely import LineString, Point, box

from kinegrade.figure.scene import THIN
from kinegrade.figure.sketch import sketch
from kinegrade.problem.printed_givens import mark_question
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template
from tests.figure.clear import lines

STROKE = 2.0  # millimetres of a stroke of hatching at most
CROSS = 1.5  # millimetres of half the cross of a centre, at most
MORE = 1.0  # millimetres by which hatching may be nearer


@pytest.mark.parametrize("phi", ["-155", "-140", "-135", "-45"])
def test_the_letter_of_a_centre_is_not_at_the_hatching_of_a_pivot(phi: str) -> None:
    template = load_template("eccentric-cam-offset-follower")
    given = {"r": "0.6", "e": "0.22", "h": "0.26", "phi": phi, "omega": "-1", "alpha": "-10"}
    mechanism = solve_template(template, given).motion.frames.mechanism.map(float)
    scene = sketch(mechanism, mark_question(template, template.asked()))
    (letter,) = (label for label in scene.labels if label.symbol == "C")
    (x, y), wide, high = letter.centre, letter.width / 2, letter.height / 2
    paper = box(x - wide, y - high, x + wide, y + high)
    short = [LineString(line) for line in lines(scene, THIN)]
    strokes = [line for line in short if line.length < STROKE and is_slanted(line)]
    arms = [line for line in short if line.length < 2 * CROSS and not is_slanted(line)]
    cross = min((Point(arm.centroid) for arm in arms), key=paper.distance)
    assert strokes
    assert paper.distance(cross) < min(map(paper.distance, strokes)) + MORE


def is_slanted(line: LineString) -> bool:
    (x, y), (to_x, to_y) = line.coords
    return abs(x - to_x) > 0.1 and abs(y - to_y) > 0.1
