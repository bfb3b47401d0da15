"""Drawings of a solution: each is drawn once, however often the solution is written, and each
letter stands in it for one thing."""

from __future__ import annotations

from collections import Counter

import pytest

from kinegrade.figure.scene import Label, Scene
from kinegrade.language import Language
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import find_template_names, load_template
from kinegrade.worked.document import Picture, Pictures
from kinegrade.worked.drawings import Drawings
from kinegrade.worked.solution import write_worked_solution
from tests.worked.draws import drawn, kept, told


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


def list_doubled(picture: Picture) -> list[str]:
    """The symbols that stand twice in a picture."""
    labels = (part.symbol for part in picture.scene.primitives if isinstance(part, Label))
    return [symbol for symbol, times in Counter(labels).items() if times > 1]


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_a_letter_stands_once_in_a_picture(name: str) -> None:
    """That of a pole outside the picture stood at the tips of both normals."""
    for place in range(len(drawn(name))):
        for block in kept(name, place, "pole"):
            for picture in block.pictures if isinstance(block, Pictures) else ():
                assert list_doubled(picture) == [], picture.caption


@pytest.mark.parametrize(
    ("language", "told"),
    [
        ("en", "the normals lead to the velocity pole $P$ of $AB$, outside the picture"),
        ("de", "die Normalen führen zum Momentanpol $P$ von $AB$, außerhalb des Bildes"),
        ("zh", "法线的交点为 $AB$ 的速度瞬心 $P$，位于图外"),
    ],
)
def test_a_pole_outside_the_picture_stands_in_its_caption(language: Language, told: str) -> None:
    template = load_template("slider-crank")
    solution = solve_template(template, {"k": "2", "phi": "85"})
    blocks = write_worked_solution(solution, template.asked(), language, "pole").blocks
    pictures = [one for each in blocks if isinstance(each, Pictures) for one in each.pictures]
    assert pictures[0].caption == told
    assert [
        part
        for part in pictures[0].scene.primitives
        if isinstance(part, Label) and part.symbol == "P"
    ] == []
