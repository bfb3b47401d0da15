"""The mistakes of writing an answer down: the factor by which each changes what is right.

A mistake is data here too: a factor, and the asks that give occasion for it. `mistake_names` has
its identifier and the sentence that describes it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import pi
from typing import Any

from flint import fmpq

from kinegrade.problem.template.template import Ask
from kinegrade.sign_conventions import UNSIGNED
from kinegrade.students.mistaking.mistake_names import MistakeName


def _has_sense(ask: Ask) -> bool:
    return ask.sign not in UNSIGNED


def _is_magnitude(ask: Ask) -> bool:
    return ask.sign in UNSIGNED


def _is_counted(ask: Ask) -> bool:
    """Whether a number that is far too large is wrong: an angle that turns round may come by."""
    return not ask.cyclic


def _is_angular_rate(ask: Ask) -> bool:
    """Whether an angular velocity or acceleration is asked for, in radians and seconds."""
    return ask.unit.angle == 1 and ask.unit.time < 0 and ask.unit.is_si


def _is_angular_velocity(ask: Ask) -> bool:
    return _is_angular_rate(ask) and ask.unit.time == -1


def _always(ask: Ask) -> bool:
    return True


_WRITTEN: Mapping[MistakeName, tuple[Any, Callable[[Ask], bool]]] = {
    "sense-reversed": (fmpq(-1), _has_sense),
    "minus-in-magnitude": (fmpq(-1), _is_magnitude),
    "power-of-ten-up": (fmpq(10), _always),
    "power-of-ten-down": (fmpq(1, 10), _always),
    "two-powers-of-ten-up": (fmpq(100), _is_counted),
    "two-powers-of-ten-down": (fmpq(1, 100), _always),
    "three-powers-of-ten-up": (fmpq(1000), _is_counted),
    "three-powers-of-ten-down": (fmpq(1, 1000), _always),
    "degrees-per-second": (180 / pi, _is_angular_rate),
    "rpm-typed": (30 / pi, _is_angular_velocity),
}


def list_answer_factors(ask: Ask) -> dict[str, Any]:
    """The factor by which each mistake that the ask gives occasion for changes its answer."""
    return {name: factor for name, (factor, occurs) in _WRITTEN.items() if occurs(ask)}
