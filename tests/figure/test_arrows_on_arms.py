"""The arrow of an arm among gears is told from the arc of the angle that ends at the arm, and its
symbol from that of the arm's length.
"""

from __future__ import annotations

from functools import partial
from itertools import pairwise
from math import pi

import pytest

from kinegrade.figure.marks.turning_arrow import Company
from kinegrade.figure.placing.beside import makes_product
from kinegrade.figure.plane import length, nearest_of
from kinegrade.figure.scene import FIRM, THIN, Bow, Label, Scene
from kinegrade.mechanics.vector import Vector
from tests.figure.test_arrows_along_rods import draw

ORIGIN = Vector(0.0, 0.0)
ARC = Bow(ORIGIN, 7.0, 0.0, pi / 2, THIN)


def rate_beside_arc(radius: float) -> float:
    """How bad an arrow is that begins where the arc ends."""
    return Company((ARC,), (), (), ()).rate(Bow(ORIGIN, radius, pi / 2, 6.0 / radius, FIRM))


def test_an_arrow_does_not_go_on_where_an_arc_of_about_its_radius_ends() -> None:
    assert rate_beside_arc(6.5) >= rate_beside_arc(5.0) + 2.0
    assert rate_beside_arc(8.0) >= rate_beside_arc(5.0) + 2.0
    assert rate_beside_arc(5.0) > rate_beside_arc(11.0)


@pytest.mark.parametrize("seed", ["31d2", "v71b", "s1", "s3", "s5", "s7"])
def test_the_symbol_of_an_arm_makes_no_product_with_that_of_its_rate(seed: str) -> None:
    scene = draw("differential-epicyclic-train", seed)
    of_arm, of_rate = (find_label(scene, symbol) for symbol in ("l", "n_{A}"))
    assert not makes_product(of_arm, [of_rate])
    # and the arrow is on the arm, within the gear about its pivot
    arrows = [part for part in scene.primitives if isinstance(part, Bow) and part.pen == FIRM]
    assert min(arrows, key=partial(measure_off, of_rate)).radius < 12.0


def find_label(scene: Scene, symbol: str) -> Label:
    """The label with a symbol."""
    [found] = [label for label in scene.labels if label.symbol == symbol]
    return found


def measure_off(label: Label, arrow: Bow) -> float:
    """Millimetres from the middle of a label to an arrow."""
    steps = pairwise(arrow.path())
    return min(length(label.centre - nearest_of(label.centre, *step)) for step in steps)
