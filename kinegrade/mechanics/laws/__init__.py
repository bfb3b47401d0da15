"""The laws: why the rates of a mechanism are related, each a value that a relation carries.

A law of turning rates gives their factors, from shares that a student may take of its parts: all of
them are 1 where it is right.
"""

from __future__ import annotations

from kinegrade.mechanics.laws.conditions import EqualRotation, GuidedBody, GuidedPoint, SharedPoint
from kinegrade.mechanics.laws.imposed import (
    ImposedCircling,
    ImposedComponent,
    ImposedMotion,
    ImposedRotation,
    find_imposed_rotation,
)
from kinegrade.mechanics.laws.rims import EqualBeltSpeed, EqualPitchSpeed, EqualRimSpeed, find_rims
from kinegrade.mechanics.laws.rolling import NoSlip, find_rolling
from kinegrade.mechanics.laws.turning import Turning

Condition = SharedPoint | GuidedPoint | GuidedBody | EqualRotation
Imposed = ImposedRotation | ImposedMotion | ImposedComponent | ImposedCircling
Law = (
    SharedPoint | GuidedPoint | EqualRotation | NoSlip | EqualPitchSpeed | EqualBeltSpeed | Imposed
)

__all__ = [
    "Condition",
    "EqualBeltSpeed",
    "EqualPitchSpeed",
    "EqualRimSpeed",
    "EqualRotation",
    "GuidedBody",
    "GuidedPoint",
    "Imposed",
    "ImposedCircling",
    "ImposedComponent",
    "ImposedMotion",
    "ImposedRotation",
    "Law",
    "NoSlip",
    "SharedPoint",
    "Turning",
    "find_imposed_rotation",
    "find_rims",
    "find_rolling",
]
