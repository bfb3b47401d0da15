"""A belt is drawn as two strands, each touching both rims."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise

import pytest

from kinegrade.figure.joints.symbol import Strand, Symbol
from kinegrade.figure.joints.table import find_symbols
from kinegrade.figure.plane import foot, length
from kinegrade.figure.scene import THIN, Strokes
from kinegrade.figure.sketch import sketch
from kinegrade.mechanics.joints import GROUND, Belt, Circle, Line
from kinegrade.mechanics.mechanism import Body, Mechanism
from kinegrade.mechanics.vector import Vector
from tests.figure.mechanisms import Case
from tests.figure.wheel_mechanisms import belt_about_fixed_pulley, belt_on_arm, crossed_belt_on_arm

CENTRES = {"O": Vector(1.0, -2.0), "A": Vector(4.0, 2.0)}  # 5 apart


def find_belt(first: float, second: float, crossed: bool) -> Symbol:
    belt = Belt("I", Circle("O", first), "II", Circle("A", second), GROUND, crossed)
    bodies = (Body("I", ("O",)), Body("II", ("A",)))
    (symbol,) = find_symbols(Mechanism(CENTRES, bodies, (belt,), ()), {})
    return symbol


def cross_between(one: Strand, other: Strand) -> bool:
    """Whether two strands cross: the ends of each lie on both sides of the other."""
    return all(
        (end - start).cross(first - start) * (end - start).cross(second - start) < 0
        for (start, end), (first, second) in pairwise((one, other, one))
    )


@pytest.mark.parametrize("crossed", [False, True])
@pytest.mark.parametrize("radii", [(1.0, 2.0), (2.0, 0.5), (1.5, 1.5)])
def test_each_strand_touches_both_rims(radii: tuple[float, float], crossed: bool) -> None:
    symbol = find_belt(*radii, crossed)
    for strand in symbol.strands:
        start, end = strand
        for at, centre, radius in zip(strand, CENTRES.values(), radii, strict=True):
            assert length(at - centre) == pytest.approx(radius)
            assert length(foot(centre, Line(start, end - start)) - at) == pytest.approx(0, abs=1e-9)
    assert cross_between(*symbol.strands) is crossed
    assert [rim.radius for rim in symbol.rims] == list(radii)


@pytest.mark.parametrize("case", [belt_on_arm, crossed_belt_on_arm, belt_about_fixed_pulley])
def test_the_strands_are_one_thin_piece_of_the_figure(case: Callable[[], Case]) -> None:
    mechanism, hints = case()
    scene = sketch(mechanism, hints)
    (symbol,) = [each for each in find_symbols(mechanism, {}) if each.strands]
    expected = [length(end - start) * scene.scale for start, end in symbol.strands]
    drawn = [
        [length(end - start) for start, end in part.lines]
        for part in scene.primitives
        if isinstance(part, Strokes) and part.pen == THIN
    ]
    assert [pytest.approx(each) for each in drawn].count(expected) == 1
