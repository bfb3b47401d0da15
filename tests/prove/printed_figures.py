"""Printed figures have no flaw at any draw: the SVG is read and measured by geometry of its own."""

from __future__ import annotations

from pathlib import Path

from kinegrade.figure.back_ends.svg import to_svg
from kinegrade.figure.sketch import sketch
from kinegrade.problem.printed_givens import mark_question
from tests.figures.angle_flaws import find_angle_flaws
from tests.figures.flaws import find_flaws, find_part_flaws
from tests.figures.known import drop_known
from tests.figures.on_paper import find_points_on_paper
from tests.figures.support_flaws import find_support_flaws
from tests.figures.svg_shapes import read_picture
from tests.prove.draws import seeded_solution, seeded_template


def hold(seed: int, _: Path) -> None:
    """Print the figure of the instance of a seed and look for flaws."""
    name = seeded_template(seed).name
    solution = seeded_solution(seed)
    mechanism = solution.motion.frames.mechanism.map(float)
    hints = mark_question(solution.template, solution.template.asked())
    scene = sketch(mechanism, hints)
    picture = read_picture(to_svg(scene))
    flaws = find_flaws(picture) + find_part_flaws(picture, mechanism, hints, scene.scale)
    points = find_points_on_paper(picture, mechanism, scene.scale)
    flaws += find_angle_flaws(picture, points, hints.angles)
    flaws += find_support_flaws(picture)
    found = drop_known(name, flaws)
    assert found == [], f"{name}: {'; '.join(found)}"
