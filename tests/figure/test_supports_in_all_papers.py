"""The support of a fixed pin stands on the same side of it in all papers of a template."""

from __future__ import annotations

import pytest

from kinegrade.figure.joints.symbol import find_fixed_pins
from kinegrade.figure.mechanism.anatomy import Anatomy
from kinegrade.figure.mechanism.paper import scale_to_paper
from kinegrade.figure.mechanism.stands import choose_upright
from kinegrade.figure.plane import unit
from kinegrade.figure.sketch import sketch
from kinegrade.problem.printed_givens import mark_question
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.library.library import load_template
from tests.problem.draws import draw_filter, drawn

PAPERS = 12


def list_supports(solution: Solution) -> dict[str, tuple[float, float]]:
    """Towards where each fixed pin is supported."""
    mechanism = solution.motion.frames.mechanism.map(float)
    hints = mark_question(solution.template, solution.template.asked())
    paper = scale_to_paper(mechanism, sketch(mechanism, hints).scale)
    anatomy = Anatomy.of(paper, hints)
    toward = {
        name: unit(choose_upright(name, anatomy)) for name in find_fixed_pins(anatomy.symbols)
    }
    return {name: (round(at.x), round(at.y)) for name, at in toward.items()}


@pytest.mark.parametrize(
    "template",
    [
        "eccentric-cam-offset-follower",
        "guide-tube-rod-fixed-centrode",
        "planetary-gear-external-rim-accelerations",
        "ring-gear-planet-relative-spin",
    ],
)
def test_the_supports_of_a_mechanism_are_alike_in_all_papers(template: str) -> None:
    papers = drawn(draw_filter(load_template(template), "alike"), PAPERS)
    first, *others = (list_supports(paper.solution) for paper in papers)
    assert first
    assert others
    assert [each for each in others if each != first] == []
