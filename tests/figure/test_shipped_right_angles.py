"""In figures of shipped templates every right angle that two bars always make carries its mark."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations
from random import Random

import pytest

from kinegrade.errors import MechanismError
from kinegrade.figure.mechanism.layers import draw
from kinegrade.figure.mechanism.paper import scale_to_paper
from kinegrade.figure.mechanism.straight_parts import Bar, Rod
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import find_template_names
from kinegrade.problem.template.template import Template
from tests.laws.cases import first_fulfilling, shipped

MILLIMETRES = 1000.0  # a metre on paper: parts of a body are then longer than any symbol


def choose(template: Template, numbers: Random) -> dict[str, str]:
    return first_fulfilling(template, lambda given: numbers.choice(given.choices))


def mechanisms(template: Template) -> Iterator[Mechanism]:
    """The mechanism at three draws."""
    found = 0
    for seed in range(20):
        try:
            solution = solve_template(template, choose(template, Random(seed)))
        except MechanismError:
            continue
        yield scale_to_paper(solution.motion.frames.mechanism.map(float), MILLIMETRES)
        found += 1
        if found == 3:
            return


def right_angles(mechanism: Mechanism, template: Template) -> set[tuple[frozenset[str], str]]:
    """The points on two bars at right angles to each other, with the point where these meet."""
    points = mechanism.points
    drawn = draw(mechanism, template.figure).parts
    bars = [part for part in drawn if isinstance(part, Bar | Rod)]
    return {
        (frozenset((one, other)), corner)
        for corner, at in points.items()
        for first, second in combinations(bars, 2)
        for one in points
        for other in points
        if is_leg(points[one], at, first)
        and is_leg(points[other], at, second)
        and abs((points[one] - at).dot(points[other] - at)) < 1e-3
    }


def is_leg(point: Vector, at: Vector, bar: Bar | Rod) -> bool:
    """Whether a bar is drawn between two points."""
    spread = (bar.end - bar.start).squared()
    for end in (point, at):
        share = (end - bar.start).dot(bar.end - bar.start) / spread
        if (
            abs((end - bar.start).cross(bar.end - bar.start)) > 1e-3 * spread
            or not -0.001 < share < 1.001
        ):
            return False
    return (point - at).squared() > 1.0


@pytest.mark.parametrize("name", find_template_names())
def test_a_right_angle_of_two_bars_at_all_values_is_marked(name: str) -> None:
    template = shipped(name)
    always = set.intersection(*(right_angles(each, template) for each in mechanisms(template)))
    marked = {corner for _, corner, _ in template.figure.right_angles}
    assert {corner for _, corner in always} - marked == set()
