"""The check at the end of a chapter."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import chain

from kinegrade.mechanics.plan import Step
from kinegrade.mechanics.vector_equation import Level
from kinegrade.problem.template.template import Ask
from kinegrade.worked.case import Case
from kinegrade.worked.checks.bodies import list_body_checks
from kinegrade.worked.checks.carriers import list_carrier_checks
from kinegrade.worked.checks.check import Check, choose_check
from kinegrade.worked.checks.derivatives import list_derivative_checks
from kinegrade.worked.checks.places import list_place_checks
from kinegrade.worked.checks.poles import list_pole_checks
from kinegrade.worked.checks.projections import list_projection_checks
from kinegrade.worked.checks.tracks import list_track_checks
from kinegrade.worked.checks.trains import list_train_checks
from kinegrade.worked.document import Block
from kinegrade.worked.vectors.stage import Stage


def check_rates(stages: Mapping[Step, Stage], level: Level, case: Case) -> Iterator[Block]:
    """The check of the last step that has one, else that of a wheel between tracks, of the points
    of a body, of gears on a carrier or about fixed axes, of a point that slides, else of a step by
    sums of angles that are still to be worked out.
    """
    if case.findings.places_alone:
        yield from _say_chosen(list_pole_checks(stages.values(), case), case)
        return
    last_first = tuple(reversed(tuple(stages.items())))
    projections = (list_projection_checks(step, stage) for step, stage in last_first)
    summed = (list_projection_checks(step, stage, summing=True) for step, stage in last_first)
    kinds = (list_track_checks, list_body_checks, list_carrier_checks, list_train_checks)
    others = (kind(level, case) for kind in kinds)
    derivatives = (list_derivative_checks(stages.values()),)
    found = chain.from_iterable(chain(projections, others, derivatives, summed))
    yield from _say_chosen(found, case)


def check_places(asked: Sequence[Ask], case: Case) -> Iterator[Block]:
    """The check of answers that positions alone decide."""
    yield from _say_chosen(list_place_checks(asked, case), case)


def _say_chosen(checks: Iterable[Check], case: Case) -> Iterator[Block]:
    """The check that tells something at a glance, if there is one."""
    chosen = choose_check(checks)
    if chosen is not None:
        yield from chosen.say(case)
