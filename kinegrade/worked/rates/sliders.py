"""Sliders that are no bodies of their own: the end of a rod is pinned to a block on a guide."""

from __future__ import annotations

from collections.abc import Iterator

from kinegrade.figure.joints.table import find_symbols
from kinegrade.language.message import Message, list_plainly
from kinegrade.worked.case import Case


def describe_sliders(case: Case) -> Iterator[Message]:
    """That they translate, in one statement."""
    points = [f"${case.naming.point(point)}$" for point in dict.fromkeys(_list_sliders(case))]
    if points:
        kind = "solution.slider-translates" if len(points) == 1 else "solution.sliders-translate"
        yield Message(kind, points=list_plainly(points))


def _list_sliders(case: Case) -> Iterator[str]:
    """The points at which the figure has a block on a guide; a body that translates is told."""
    mechanism = case.motion.frames.mechanism.map(float)
    for symbol in find_symbols(mechanism, case.template.figure.shapes):
        guided = symbol.guide and symbol.pinned and symbol.guide.body not in case.translating
        if symbol.point and guided:
            yield symbol.point
