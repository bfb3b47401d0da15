"""Instances held against what mistakes lead to, in doubles for many of them at once."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import tau
from typing import Any

import numpy as np

from kinegrade.numbers.noting.pad import Doubles
from kinegrade.problem.template.template import Ask
from kinegrade.students.mistaking.mistake_outcomes import SAME
from kinegrade.students.rounding.rounding import Rounding


@dataclass(frozen=True)
class Comparison:
    """Instances held against what mistakes lead to: for every ask a row for each mistake, by
    `identifiers`.

    `right` has every ask's right answers, in its unit; `near` marks where a mistaken value might be
    taken for right, `changed` where it is another value at all, `stuck` where there is none because
    no mechanism has such measures; `fit` marks the instances that may be drawn, as far as doubles
    can decide. `roundings` are those of honest students, and `strayed` marks where rounding leaves
    what is allowed. `unmet` is the place of the first condition that an instance
    does not meet, -1 where there is none.
    """

    identifiers: Mapping[str, tuple[str, ...]]
    right: Mapping[str, Any]
    near: Mapping[str, Any]
    changed: Mapping[str, Any]
    stuck: Mapping[str, Any]
    fit: Any
    roundings: Mapping[str, Rounding[Doubles]]
    strayed: Mapping[str, Any]
    unmet: Any


def measure_distance(one: Any, other: Any, ask: Ask) -> Any:
    """The difference of two answers; of angles that turn round, the difference without full
    turns.
    """
    difference = np.abs(one - other)
    if not ask.cyclic:
        return difference
    turn = 360.0 if ask.unit.degrees else tau
    return np.abs(difference - turn * np.round(difference / turn))


def is_different(one: Any, other: Any) -> Any:
    """Where one value is another than the other, and not the same rounded; False where there is
    none.
    """
    return np.abs(one - other) > SAME * np.maximum(np.maximum(np.abs(one), np.abs(other)), 1.0)


def collect_columns(draws: Sequence[Mapping[str, str]]) -> dict[str, list[str]]:
    """For each parameter its values in all draws."""
    return {name: [draw[name] for draw in draws] for name in draws[0]}
