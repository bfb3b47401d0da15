"""Figures are clear at any draw: symbols apart from each other and from bold lines, all on paper,
and none missing.

The figure of the paper and every picture of the worked solution are looked at.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from kinegrade.figure.scene import Scene
from kinegrade.figure.sketch import HEIGHT, WIDTH, sketch
from kinegrade.problem.printed_givens import mark_question
from kinegrade.problem.solution import Solution
from kinegrade.worked.document import Pictures
from kinegrade.worked.solution import write_worked_solution
from tests.figure.clear import faults
from tests.figure.test_letters import list_missing
from tests.prove.draws import seeded_solution


def hold(seed: int, _: Path) -> None:
    """Draw the figure and the pictures of the instance of a seed."""
    solution = seeded_solution(seed)
    template = solution.template
    mechanism = solution.motion.frames.mechanism.map(float)
    figure = sketch(mechanism, mark_question(template, template.asked()))
    assert figure.width <= WIDTH, template.name
    assert figure.height <= HEIGHT, template.name
    missing = list_missing(solution)
    assert missing == [], f"{template.name}: no letter {missing}"
    for name, scene in [("the figure", figure), *_pictures(solution)]:
        found = faults(scene, scene.width, scene.height)
        assert found == [], f"{template.name}, {name}: {found}"


def _pictures(solution: Solution) -> Iterator[tuple[str, Scene]]:
    """The pictures of the worked solution with their captions."""
    for block in write_worked_solution(solution, solution.template.asked(), "en").blocks:
        if isinstance(block, Pictures):
            yield from ((picture.caption, picture.scene) for picture in block.pictures)
