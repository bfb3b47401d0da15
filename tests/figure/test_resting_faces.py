"""The face of a translating follower lies on the cam: a rim does not sink into the plate."""

from __future__ import annotations

import pytest

from kinegrade.figure.mechanism.layers import draw
from kinegrade.figure.mechanism.paper import scale_to_paper
from kinegrade.figure.scene import BOLD, FIRM, Disc, Strokes
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template


@pytest.mark.parametrize(
    "name", ["flat-faced-follower-eccentric-circle", "flat-faced-follower-curvature-radius"]
)
def test_the_face_of_a_follower_touches_the_rim_from_outside_where_a_dot_is(name: str) -> None:
    solution = solve_template(load_template(name), {})
    mechanism = scale_to_paper(solution.assembly.mechanism.map(float), 100.0)
    primitives = draw(mechanism, solution.template.figure).primitives
    contact = mechanism.points["A"]
    bold = [part for part in primitives if isinstance(part, Strokes) and part.pen == BOLD]
    lines = [line for part in bold for line in part.lines]
    levels = [start.y for start, end in lines if start.y == pytest.approx(end.y)]
    edge_of_rim, half_plate = contact.y + FIRM.width / 2, BOLD.width / 2
    assert levels == [pytest.approx(edge_of_rim + half_plate)]
    assert min(at.y for line in lines for at in line) == pytest.approx(levels[0])
    assert contact in [part.centre for part in primitives if isinstance(part, Disc)]
