"""The points of a mechanism that are in view: those that something drawn or marked refers to."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import is_dataclass, replace
from typing import Any

from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.problem.template.hints import FigureHints


def crop_to_view(mechanism: Mechanism, hints: FigureHints) -> Mechanism:
    """The mechanism without points that serve only for construction, which may lie far away."""
    labelled = tuple(name for name, symbol in hints.labels.items() if symbol)
    marks = (
        hints.lengths,
        hints.angles,
        hints.radii,
        hints.circles,
        hints.lines,
        hints.right_angles,
        hints.arrows,
        hints.frames,
        labelled,
    )
    used = set(_list_texts((mechanism.bodies, mechanism.joints, mechanism.drivers, marks)))
    return replace(
        mechanism, points={name: at for name, at in mechanism.points.items() if name in used}
    )


def _list_texts(value: Any) -> Iterator[str]:
    """Every text in a value made of dataclasses and tuples."""
    if isinstance(value, str):
        yield value
    elif isinstance(value, tuple):
        for part in value:
            yield from _list_texts(part)
    elif is_dataclass(value):
        for part in vars(value).values():
            yield from _list_texts(part)
