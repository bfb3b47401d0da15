"""Racks that mesh with no gear of the figure: bodies of the shape "rack" that translate in a
straight guide of the ground.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from kinegrade.figure.joints.symbol import Symbol
from kinegrade.figure.mechanism.straight.rods import find_guides_of_rods, list_others
from kinegrade.figure.mechanism.straight_parts import Bar
from kinegrade.figure.plane import mean
from kinegrade.mechanics.mechanism import Mechanism

_RACK = 22.0  # millimetres from the pin of a rack to its free end


def find_racks(
    mechanism: Mechanism, shapes: Mapping[str, str], symbols: Sequence[Symbol]
) -> Iterator[Bar]:
    """The racks, each from its point away from the other bodies, with its back to the ground and
    its teeth on the side of these.
    """
    for guide in find_guides_of_rods(symbols):
        if shapes.get(guide.body) == "rack":
            rest = mean(list_others(mechanism, guide)) - guide.at
            toward = guide.along * (-1.0 if guide.along.dot(rest) > 0 else 1.0)
            across = guide.along.turned()
            back = across * (-1.0 if across.dot(rest) > 0 else 1.0)
            end = guide.at + toward * _RACK
            yield Bar(guide.body, guide.at, end, "rack", free=(end,), back=back)
