"""Where an extension line begins: at the end of a bar that leads its way, and where a bar beside it
has left it.
"""

from __future__ import annotations

from math import radians

import pytest

from kinegrade.figure.marks.lengths.dimension_lines import SymbolBeside
from kinegrade.figure.marks.lengths.extension_gaps import Around, Gap, find_gap
from kinegrade.figure.mechanism.straight_parts import Bar
from kinegrade.figure.placing.obstacles import Obstacles
from kinegrade.figure.placing.place import place_label
from kinegrade.figure.plane import polar
from kinegrade.figure.scene import BOLD, THIN, Pen, Strokes
from kinegrade.mechanics.vector import Vector

POINT, RIGHT = Vector(3.0, 2.0), Vector(1.0, 0.0)
NOTHING = Obstacles.of(())


def _find_gap_beside(degrees: float) -> Gap:
    """The gap to the right of a point that a bar of 20 mm leaves at an angle to it."""
    bar = Bar("AB", POINT, POINT + polar(radians(degrees), 20.0))
    return find_gap(POINT, RIGHT, Around(NOTHING, NOTHING, (bar,)))


def test_a_bar_along_an_extension_line_takes_its_place_up_to_its_end() -> None:
    assert _find_gap_beside(0.0) == Gap(20.5, hidden=0.0)
    assert _find_gap_beside(180.0).reach == pytest.approx(1.6)


def test_an_extension_line_begins_where_a_bar_beside_it_is_clear_of_it() -> None:
    """At 10 degrees half a bar and 0.7 mm take 1.1/sin(10 degrees); at 1 degree it is too far."""
    assert _find_gap_beside(10.0).reach == pytest.approx(6.335, abs=1e-3)
    assert [_find_gap_beside(turn).reach for turn in (1.0, 20.0)] == [1.6, 1.6]


def test_an_extension_line_begins_beyond_the_corner_of_the_sleeve_that_its_point_is_in() -> None:
    """A sleeve of 6.4 mm by 4.4 mm: at 45 degrees it ends 2.2/sin(45 degrees) mm from its pin."""
    around = Around(NOTHING, NOTHING, half_pins=((POINT, polar(radians(45))),))
    assert find_gap(POINT, RIGHT, around).reach == pytest.approx(3.611, abs=1e-3)
    assert find_gap(POINT + RIGHT, RIGHT, around).reach == pytest.approx(1.6)


@pytest.mark.parametrize("pen", [BOLD, THIN])
def test_the_symbol_of_a_bar_is_clearly_nearer_to_it_than_to_another_line(pen: Pen) -> None:
    """At a sharp angle: the symbol stands outside it, or where the two are well apart."""
    start, end, other = (POINT, POINT + polar(radians(90)) * 20.0, POINT + polar(radians(75)) * 20)
    drawn = Obstacles.of([Strokes(((start, end),), BOLD), Strokes(((start, other),), pen)])
    for beside in (SymbolBeside(*ends, "r", drawn=drawn) for ends in ((start, end), (end, start))):
        assert place_label(beside.wish(), drawn).label.centre.x < POINT.x
