"""Checks of a wheel between two tracks that has been found by its points of contact: the motion of
its centre follows from either of them.
"""

from __future__ import annotations

from collections.abc import Iterator

from kinegrade.language.message import Message
from kinegrade.mechanics.plan import Step
from kinegrade.worked.checks.check import Check, compare
from kinegrade.worked.checks.sides import Side
from kinegrade.worked.steps.two_tracks import find_two_tracks
from kinegrade.worked.vectors.stage import Stage
from kinegrade.worked.vectors.vectors import UNITS


def list_track_checks(step: Step, stage: Stage) -> Iterator[Check]:
    """The check of a wheel between two tracks."""
    wheel = find_two_tracks(step, stage)
    if wheel is None:
        return
    centre = stage.case.naming.point(wheel.first.roll.circle.centre)
    way = Message(f"solution.centre-from-contacts-{stage.level}", centre=centre)
    left, right = (
        Side(wheel.find_centre_from(one), wheel.measure_from(one))
        for one in (wheel.first, wheel.second)
    )
    yield compare(way, left, right, UNITS[stage.level, False])
