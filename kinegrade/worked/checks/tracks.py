"""Checks of a wheel between two tracks that has been found by its points of contact: the motion of
its centre follows from the other one, too.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from kinegrade.language.message import Message
from kinegrade.mechanics.laws import find_rolling
from kinegrade.mechanics.plan import Step
from kinegrade.worked.checks.check import Check, compare
from kinegrade.worked.checks.forms import state_form
from kinegrade.worked.checks.sides import Side
from kinegrade.worked.formulas.numbers import measure
from kinegrade.worked.rates.kinds import describe_track
from kinegrade.worked.steps.titles import select_scalars
from kinegrade.worked.steps.two_tracks import find_two_tracks
from kinegrade.worked.vectors.stage import Stage
from kinegrade.worked.vectors.vectors import UNITS


def list_track_checks(step: Step, stage: Stage) -> Iterator[Check]:
    """The check of a wheel between two tracks, the motion of whose centre has been found."""
    wheel = find_two_tracks(step, stage)
    if wheel is None or not wheel.is_centre_needed:
        return
    other = wheel.first if wheel.start is wheel.second else wheel.second
    centre = other.roll.circle.centre
    way = Message(
        f"solution.centre-from-contact-{stage.level}",
        centre=stage.case.naming.point(centre),
        track=describe_track(other.roll, stage.case),
    )
    unit, value = UNITS[stage.level, False], wheel.measure_centre()
    found = Side(measure(value, unit), value, wheel.centre)
    letters = wheel.name_centre_from(other)
    followed = Side(wheel.find_centre_from(other), wheel.measure_from(other), letters)
    for relation in select_scalars(step, stage.case):
        if find_rolling(relation.source) == other.roll:
            check = compare(way, found, followed, unit, form=state_form(relation))
            yield replace(check, points=frozenset((centre,)))
