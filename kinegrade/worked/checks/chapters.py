"""The check at the end of a chapter."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import chain, islice

from kinegrade.mechanics.plan import Step
from kinegrade.mechanics.vector_equation import Level
from kinegrade.problem.template.template import Ask
from kinegrade.worked.case import Case
from kinegrade.worked.checks.bodies import list_body_checks, list_new_body_checks
from kinegrade.worked.checks.carriers import list_carrier_checks
from kinegrade.worked.checks.check import Check, choose_check
from kinegrade.worked.checks.constraints import list_constraint_checks
from kinegrade.worked.checks.places import list_place_checks
from kinegrade.worked.checks.poles import list_pole_checks
from kinegrade.worked.checks.projections import (
    list_projection_checks,
    list_theorem_checks,
)
from kinegrade.worked.checks.tracks import list_track_checks
from kinegrade.worked.checks.trains import list_train_checks
from kinegrade.worked.document import Block
from kinegrade.worked.vectors.stage import Stage


def check_rates(stages: Mapping[Step, Stage], level: Level, case: Case) -> Iterator[Block]:
    """The check of a chapter that goes by another way than its steps: the last step's that has
    one. A vector equation is multiplied again by what has not been used only where nothing else
    tells whether it is right.
    """
    if case.findings.places_alone:
        yield from _say_chosen([list_pole_checks(stages.values(), case)], case)
        return
    last_first = tuple(reversed(tuple(stages.items())))
    theorems = (list_theorem_checks(step, stage) for step, stage in last_first)
    tracks = (list_track_checks(step, stage) for step, stage in last_first)
    kinds = (list_carrier_checks, list_train_checks)
    laws = (kind(level, case) for kind in kinds)
    constraints = (list_constraint_checks(stage) for _, stage in last_first)
    others = chain(theorems, tracks, laws, constraints, (list_new_body_checks(level, case),))
    projections = (list_projection_checks(step, stage) for step, stage in last_first)
    again = (chain.from_iterable(projections), list_body_checks(level, case))
    yield from _say_chosen((chain.from_iterable(others), *again), case)


def check_places(asked: Sequence[Ask], case: Case) -> Iterator[Block]:
    """The check of answers that positions alone decide."""
    yield from _say_chosen([list_place_checks(asked, case)], case)


def _say_chosen(groups: Iterable[Iterable[Check]], case: Case) -> Iterator[Block]:
    """The check of the first group that has one which tells something, if there is one."""
    found = (check for check in map(choose_check, groups) if check is not None)
    for check in islice(found, 1):
        yield from check.say(case)
