"""No point of a tactile figure stands without the parts on which it lies, on later sheets neither."""

from __future__ import annotations

import pytest

from kinegrade.figure.scene import Bow, Disc, Primitive, Scene
from kinegrade.figure.tactile.clearance import list_rows, measure_gap
from kinegrade.figure.tactile.sizes import MARK
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.printed_givens import mark_question
from tests.prove.draws import seeded_solution
from tests.prove.tactile_sheets import draw_sheets

BRAILLE = 0.8  # its dots are smaller in millimetres than those of points


# A bent rod in two sleeves, a cam with a tappet, a bar through a sleeve, and a rack steering
@pytest.mark.parametrize("seed", [27, 47, 48, 49])
def test_what_carries_a_point_stands_with_it_on_every_sheet(seed: int) -> None:
    solution = seeded_solution(seed)
    template = solution.template
    figure = draw_sheets(solution, mark_question(template, template.asked()))
    carried = {each for sheet in figure.sheets for each in find_points(sheet.scene, carried=True)}
    assert carried
    for sheet in figure.sheets:
        assert carried.isdisjoint(find_points(sheet.scene, carried=False))


def find_points(scene: Scene, *, carried: bool) -> set[tuple[float, float]]:
    """Where dots of points touch a part, or lie in the middle of its circle; or where they do not."""
    parts = [each for each in scene.primitives if is_part(each)]
    dots = [each for each in scene.primitives if isinstance(each, Disc) and is_dot(each)]
    return {
        locate(dot.centre) for dot in dots if any(lies_on(dot, part) for part in parts) is carried
    }


def is_dot(disc: Disc) -> bool:
    """Whether a disc is a point."""
    return disc.pen is None and disc.radius > BRAILLE


def is_part(primitive: Primitive) -> bool:
    """Whether a line is thicker than those of marks."""
    pen = getattr(primitive, "pen", None)
    return pen is not None and pen.width > MARK.width


def lies_on(dot: Disc, part: Primitive) -> bool:
    """Whether a dot touches a line, or lies in the middle of a circle."""
    if isinstance(part, Disc | Bow) and locate(part.centre) == locate(dot.centre):
        return True
    return measure_gap(list_rows(dot), list_rows(part)) < 0


def locate(at: Vector) -> tuple[float, float]:
    """A place to a thousandth of a millimetre."""
    return round(at.x, 3), round(at.y, 3)
