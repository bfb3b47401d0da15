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
from kinegrade.worked.checks.right_angles import list_right_angle_checks
from kinegrade.worked.checks.theorems import list_theorem_checks
from kinegrade.worked.checks.tracks import list_track_checks
from kinegrade.worked.checks.trains import list_train_checks
from kinegrade.worked.document import Block
from kinegrade.worked.vectors.stage import Stage


def check_rates(stages: Mapping[Step, Stage], level: Level, case: Case) -> Iterator[Block]:
    """The check of a chapter that goes by another way than its steps: the last step's that has
    one. No vector equation is projected once more, which would test the arithmetic alone.
    """
    if case.findings.places_alone:
        yield from _say_chosen([list_pole_checks(stages.values(), case)], case)
        return
    last_first = tuple(reversed(tuple(stages.items())))
    theorems = (list_theorem_checks(step, stage) for step, stage in last_first)
    tracks = (list_track_checks(step, stage) for step, stage in last_first)
    kinds = (list_carrier_checks, list_train_checks)
    laws = (kind(level, case) for kind in kinds)
    constraints = (
        chain(list_right_angle_checks(stage), list_constraint_checks(stage))
        for _, stage in last_first
    )
    others = chain(theorems, tracks, laws, constraints, (list_new_body_checks(level, case),))
    groups = (chain.from_iterable(others), list_body_checks(level, case))
    yield from _say_chosen(groups, case)


def check_places(asked: Sequence[Ask], case: Case) -> Iterator[Block]:
    """The check of answers that positions alone decide."""
    yield from _say_chosen([list_place_checks(asked, case)], case)


def _say_chosen(groups: Iterable[Iterable[Check]], case: Case) -> Iterator[Block]:
    """The check of the first group that has one which tells something, if there is one."""
    found = (check for check in map(choose_check, groups) if check is not None)
    for check in islice(found, 1):
        yield from check.say(case)
