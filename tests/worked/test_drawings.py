"""Drawings of a solution: each is drawn once, however often the solution is written."""

from __future__ import annotations

from kinegrade.figure.scene import Scene
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template
from kinegrade.worked.document import Pictures
from kinegrade.worked.drawings import Drawings
from tests.worked.draws import told


def test_what_is_shown_again_is_not_drawn_again() -> None:
    solution = solve_template(load_template("slider-crank"), {})
    scene = next(each for each in told(solution) if isinstance(each, Pictures)).pictures[0].scene
    drawings, drawn = Drawings(), list[str]()

    def draw() -> Scene:
        drawn.append("drawn")
        return scene

    assert drawings.find(("a", 1), draw) is drawings.find(("a", 1), draw) is scene
    assert drawings.find(("a", 2), draw) is scene
    assert len(drawn) == 2
